// The path of a listener in a deck.

#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

namespace {

/// A row [time, x, y, z] of the deck.
bool read_row(const Node& node, Mistakes& mistakes, CsvRows& rows) {
  if (node.kind != Node::Kind::list || node.children.size() != 4) {
    return mistakes.add(node, "expected a row [time, x, y, z] (s and m), found " + describe(node));
  }
  std::vector<double> row(4);
  bool good = read(node.children[0], mistakes, row[0], Range{.at_least = 0.0, .at_most = 1e6, .unit = "s"});
  for (std::size_t i = 1; i < row.size(); ++i) {
    good &= read(node.children[i], mistakes, row[i], coordinate);
  }
  if (good && !rows.empty() && row[0] <= rows.back()[0]) {
    good = mistakes.add(node, fmt::format("times must ascend; {} s does not follow {} s", row[0], rows.back()[0]));
  }
  rows.push_back(row);
  return good;
}

bool read_rows(const Node& node, Mistakes& mistakes, CsvRows& rows) {
  bool good = true;
  for (const Node& child : node.children) {
    good &= read_row(child, mistakes, rows);
  }
  if (good && rows.size() < 2) {
    return mistakes.add(node, fmt::format("needs at least 2 rows [time, x, y, z], found {}", rows.size()));
  }
  return good;
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, Path& path, const Folder& folder) {
  CsvRows rows;
  const bool good = node.kind == Node::Kind::list
                        ? read_rows(node, mistakes, rows)
                        : read(node, mistakes, rows, folder, CsvColumns{{"time", "x", "y", "z"}});
  if (!good) {
    return false;
  }
  path.where = node.where;
  for (const auto& row : rows) {
    path.points.push_back({row[0], {row[1], row[2], row[3]}});
    if (!(path.points.back().position.cwiseAbs().maxCoeff() <= coordinate.at_most)) {
      return mistakes.add(node, fmt::format("at {} s the position ({}, {}, {}) m is farther than {} m from the origin",
                                            row[0], row[1], row[2], row[3], coordinate.at_most));
    }
  }
  return true;
}

}  // namespace idiophone::scene
