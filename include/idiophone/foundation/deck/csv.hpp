#pragma once
// Tables of numbers in CSV files. A row is a line of numbers with commas between them; # begins a comment.

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/deck/mistakes.hpp"

namespace idiophone::deck {

/// So many mistakes are answered: a file that is no such table at all would bring thousands.
inline constexpr std::size_t most_mistakes_of_a_table = 10;

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

/// Opens a file for reading, after the byte order mark of UTF-8 with which spreadsheets begin files.
/// @return a stream that has failed if the file can't be read
[[nodiscard]] std::ifstream open_csv(const std::filesystem::path& file);

/// Appends the rows of a file. Reports the first mistakes, at most most_mistakes_of_a_table.
/// @param header  gets the header if there is one; if omitted, a header is a mistake
/// @return whether there was no mistake
bool read_csv(const std::filesystem::path& file, const std::vector<CsvColumn>& columns, Mistakes& mistakes,
              std::vector<CsvRow>& rows, std::optional<CsvHeader>* header = nullptr);

}  // namespace idiophone::deck
