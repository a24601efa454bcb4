#pragma once
// Tables of numbers in CSV files. A row is a line of numbers with commas between them; # begins a comment.

#include <filesystem>
#include <optional>
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

/// A first line that begins with a letter, without its comment.
struct CsvHeader {
  Location where;
  std::string text;
};

/// Appends the rows of a file. Reports the first ten mistakes.
/// @param header  gets the header if there is one; if omitted, a header is a mistake
/// @return whether there was no mistake
bool read_csv(const std::filesystem::path& file, const std::vector<CsvColumn>& columns, Mistakes& mistakes,
              std::vector<CsvRow>& rows, std::optional<CsvHeader>* header = nullptr);

}  // namespace idiophone::deck
