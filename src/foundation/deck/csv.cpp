#include "idiophone/foundation/deck/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>

namespace idiophone::deck {

namespace {

constexpr std::string_view blanks = " \t\r";

std::size_t skip_blanks(std::string_view line, std::size_t position) {
  return std::min(line.find_first_not_of(blanks, position), line.size());
}

/// Reads one row. What is wrong is put into `mistake`, and where into `position`.
bool parse_row(std::string_view line, const std::vector<CsvColumn>& columns, std::vector<double>& row,
               std::size_t& position, std::string& mistake) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto& [name, unit] = columns[i];
    const char* end = line.data() + line.size();
    const auto [rest, error] = std::from_chars(line.data() + position, end, row.emplace_back());
    if (error != std::errc{} || !std::isfinite(row.back())) {
      mistake = fmt::format("expected a {}{}, found '{}'", name, unit.empty() ? "" : " (" + unit + ")",
                            line.substr(position));
      return false;
    }
    position = skip_blanks(line, rest - line.data());
    if (i + 1 == columns.size()) {
      break;
    }
    if (position == line.size() || line[position] != ',') {
      mistake = fmt::format("expected a comma between {} and {}, found '{}'", name, columns[i + 1].name,
                            line.substr(position));
      return false;
    }
    position = skip_blanks(line, position + 1);
  }
  if (position != line.size()) {
    mistake = fmt::format("unexpected '{}' after the {}: a row has {}", line.substr(position), columns.back().name,
                          columns.size() == 1 ? "one number" : fmt::format("{} numbers", columns.size()));
  }
  return position == line.size();
}

}  // namespace

std::ifstream open_csv(const std::filesystem::path& file) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  std::ifstream csv(file);
  std::size_t read = 0;
  while (read < byte_order_mark.size() && csv.peek() == static_cast<unsigned char>(byte_order_mark[read])) {
    csv.get();
    ++read;
  }
  if (read < byte_order_mark.size()) {  // no mark; a pipe cannot seek, so the bytes are put back
    for (; read > 0; --read) {
      csv.unget();
    }
  }
  return csv;
}

bool read_csv(const std::filesystem::path& file, const std::vector<CsvColumn>& columns, Mistakes& mistakes,
              std::vector<CsvRow>& rows, std::optional<CsvHeader>* header) {
  const std::size_t before = mistakes.count();
  const auto place = [&](int line, std::size_t position) {
    return Location{file.string(), line, static_cast<int>(position) + 1};
  };
  std::ifstream csv = open_csv(file);
  if (!csv) {
    mistakes.add(place(1, 0), "can't read this file");
  }
  bool header_is_possible = header != nullptr;
  std::string text;
  for (int number = 1; std::getline(csv, text) && mistakes.count() < before + most_mistakes_of_a_table; ++number) {
    const std::string_view line = std::string_view(text).substr(0, text.find('#'));
    std::size_t position = skip_blanks(line, 0);
    if (position == line.size()) {
      continue;
    }
    if (std::exchange(header_is_possible, false) && std::isalpha(static_cast<unsigned char>(line[position])) != 0) {
      const std::size_t end = line.find_last_not_of(blanks) + 1;
      *header = CsvHeader{place(number, position), std::string(line.substr(position, end - position))};
      continue;
    }
    CsvRow row{.where = place(number, position), .values = {}};
    std::string mistake;
    if (parse_row(line, columns, row.values, position, mistake)) {
      rows.push_back(std::move(row));
    } else {
      mistakes.add(place(number, position), mistake);
    }
  }
  return mistakes.count() == before;
}

}  // namespace idiophone::deck
