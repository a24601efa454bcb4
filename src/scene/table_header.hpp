#pragma once
// Headers of tables of a time and a value: the first line, which names both with their units.

#include <optional>
#include <string>
#include <string_view>

#include "idiophone/foundation/deck/mistakes.hpp"

namespace idiophone::scene {

/// Units of a table: what one of them is in s, and in N or 1.
struct TableUnits {
  double time = 1.0;
  double value = 1.0;
  bool is_force = false;  ///< the values are newtons
};

/// Reads a line such as "time/ms, force/N" or "time (s), value".
/// @param line   without comment; it begins with a letter
/// @param where  its place; of mistakes
/// @return none, and a mistake, if it is none
[[nodiscard]] std::optional<TableUnits> read_table_header(std::string_view line, const deck::Location& where,
                                                          deck::Mistakes& mistakes);

/// The units of a table in a file: those of its header, or s and 1 without one.
[[nodiscard]] TableUnits units_of_table(const std::string& file);

}  // namespace idiophone::scene
