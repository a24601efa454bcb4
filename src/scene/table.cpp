// Tables in CSV files: rows of a time and what belongs to it.

#include <charconv>
#include <cmath>
#include <fstream>

#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

namespace {

constexpr std::size_t most_mistakes = 10;  // a file that is no table at all would bring thousands
constexpr std::string_view blanks = " \t\r";

std::size_t skip_blanks(std::string_view line, std::size_t position) {
  return std::min(line.find_first_not_of(blanks, position), line.size());
}

/// Reads one row and checks it. What is wrong is put into `mistake`, and where into `position`.
bool parse_row(std::string_view line, const CsvColumns& columns, std::vector<double>& row, std::size_t& position,
               std::string& mistake) {
  const std::vector<std::string>& names = columns.names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const char* end = line.data() + line.size();
    const auto [rest, error] = std::from_chars(line.data() + position, end, row.emplace_back());
    if (error != std::errc{} || !std::isfinite(row.back())) {
      mistake = fmt::format("expected a {}{}, found '{}'", names[i], i == 0 ? " (s)" : "", line.substr(position));
      return false;
    }
    position = skip_blanks(line, rest - line.data());
    if (i + 1 == names.size()) {
      break;
    }
    if (position == line.size() || line[position] != ',') {
      mistake =
          fmt::format("expected a comma between {} and {}, found '{}'", names[i], names[i + 1], line.substr(position));
      return false;
    }
    position = skip_blanks(line, position + 1);
  }
  if (position != line.size()) {
    mistake = fmt::format("unexpected '{}' after the {}", line.substr(position), names.back());
  }
  return position == line.size();
}

bool read_rows(std::istream& csv, const std::string& name, Mistakes& mistakes, CsvRows& rows,
               const CsvColumns& columns) {
  const std::size_t before = mistakes.count();
  std::string text;
  for (int number = 1; std::getline(csv, text) && mistakes.count() < before + most_mistakes; ++number) {
    const std::string_view line = std::string_view(text).substr(0, text.find('#'));
    std::size_t position = skip_blanks(line, 0);
    if (position == line.size()) {
      continue;
    }
    const std::size_t start = position;
    std::vector<double> row;
    std::string mistake;
    if (parse_row(line, columns, row, position, mistake)) {
      position = start;
      if (row[0] < 0.0) {
        mistake = fmt::format("the time must be at least 0 s, found {}", row[0]);
      }
      if (!rows.empty() && row[0] <= rows.back()[0]) {
        mistake = fmt::format("times must ascend; {} s does not follow {} s", row[0], rows.back()[0]);
      }
      rows.push_back(row);
    }
    if (!mistake.empty()) {
      mistakes.add({name, number, static_cast<int>(position) + 1}, mistake);
    }
  }
  return mistakes.count() == before;
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, CsvRows& rows, const Folder& folder, const CsvColumns& columns) {
  std::filesystem::path file;
  if (!read(node, mistakes, file, folder)) {
    return false;
  }
  std::ifstream csv(file);
  if (!csv) {
    return mistakes.add(node, "can't read " + std::filesystem::absolute(file).string());
  }
  if (!read_rows(csv, file.string(), mistakes, rows, columns)) {
    return false;
  }
  if (rows.size() >= 2) {
    return true;
  }
  return mistakes.add(node, fmt::format("needs at least 2 rows '{}', found {} in {}", fmt::join(columns.names, ", "),
                                        rows.size(), std::filesystem::absolute(file).string()));
}

bool read(const Node& node, Mistakes& mistakes, Table& table, const Folder& folder, const TimeAndValue& /*rule*/) {
  CsvRows rows;
  const bool good = read(node, mistakes, rows, folder, CsvColumns{{"time", "value"}});
  for (const auto& row : rows) {
    if (good) {
      table.push_back({row[0], row[1]});
    }
  }
  return good;
}

}  // namespace idiophone::scene
