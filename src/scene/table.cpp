// Tables in CSV files: rows of a time and what belongs to it.

#include "idiophone/foundation/deck/csv.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

namespace {

/// Reports the first time that is not at least 0, and the first one that does not follow the one before.
bool check_times(const std::vector<deck::CsvRow>& rows, Mistakes& mistakes) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double time = rows[i].values[0];
    if (time < 0.0) {
      mistakes.add(rows[i].where, fmt::format("the time must be at least 0 s, found {}", time));
      return false;
    }
    if (i > 0 && time <= rows[i - 1].values[0]) {
      mistakes.add(rows[i].where,
                   fmt::format("times must ascend; {} s does not follow {} s", time, rows[i - 1].values[0]));
      return false;
    }
  }
  return true;
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, CsvRows& rows, const Folder& folder, const CsvColumns& columns) {
  std::filesystem::path file;
  if (!read(node, mistakes, file, folder)) {
    return false;
  }
  std::vector<deck::CsvColumn> described;
  for (const std::string& name : columns.names) {
    described.push_back({.name = name, .unit = described.empty() ? "s" : ""});
  }
  std::vector<deck::CsvRow> found;
  if (!deck::read_csv(file, described, mistakes, found) || !check_times(found, mistakes)) {
    return false;
  }
  for (deck::CsvRow& row : found) {
    rows.push_back(std::move(row.values));
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
