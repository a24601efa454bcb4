#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

namespace {

/// Levenshtein's distance: how many letters to insert, drop or exchange to make one word the other.
std::size_t edit_distance(const std::string& from, const std::string& to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char letter : from) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t exchanged = diagonal + (letter == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({exchanged, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

const std::vector<Index>& find_group(const Mesh& mesh, const std::string& group, const deck::Location& where) {
  if (const auto found = mesh.groups.find(group); found != mesh.groups.end()) {
    return found->second;
  }
  if (mesh.groups.empty()) {
    throw deck::DeckError(where, fmt::format("the mesh has no group '{}', nor any other: define it by "
                                             "Physical Surface(\"{}\") in gmsh",
                                             group, group));
  }
  std::vector<std::string> names;
  for (const auto& [name, nodes] : mesh.groups) {
    names.push_back(name);
  }
  const auto nearest =
      std::ranges::min_element(names, {}, [&](const auto& name) { return edit_distance(group, name); });
  constexpr std::size_t most_names = 30;
  const std::string nearest_name = *nearest;
  const std::string more = names.size() > most_names ? fmt::format(" and {} more", names.size() - most_names) : "";
  names.resize(std::min(names.size(), most_names));
  throw deck::DeckError(where, fmt::format("the mesh has no group '{}'; did you mean '{}'? It has: {}{}", group,
                                           nearest_name, fmt::join(names, ", "), more));
}

}  // namespace idiophone::mesh
