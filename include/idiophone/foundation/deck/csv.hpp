#pragma once
// Tables of numbers in CSV files. A row is a line of numbers with commas between them; # begins a comment.

#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/deck/mistakes.hpp"

namespace idiophone::deck {

struct CsvColumn {
  std::string name;
  std::string unit = {};  ///< for messages; may be empty
};

struct CsvRow {
  Location where;
  std::vector<double> values;  ///< [columns] finite
};

/// Appends the rows of a file. Reports the first ten mistakes.
/// @return whether there was none
bool read_csv(const std::filesystem::path& file, const std::vector<CsvColumn>& columns, Mistakes& mistakes,
              std::vector<CsvRow>& rows);

}  // namespace idiophone::deck
