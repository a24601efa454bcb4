#include "regions_by_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "checks.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/listed_names.hpp"

namespace idiophone::mesh {

namespace {

constexpr Index no_region = -1;

[[noreturn]] void refuse_group(const scene::Body& body, const scene::MaterialRegion& region, const GmshMesh& loaded) {
  const std::string kind = body.thickness ? "Surface" : "Volume";
  throw deck::DeckError(
      region.where,
      fmt::format("bodies.{}.materials: the mesh has no physical group '{}' of elements of the body; {}", body.name,
                  region.name,
                  loaded.element_groups.empty()
                      ? fmt::format("it has none: define them by Physical {}(\"{}\") in gmsh", kind, region.name)
                      : fmt::format("it has: {}", listed_names(loaded.element_groups))));
}

/// Places of the elements of a region's group.
std::vector<Index> elements_of(const scene::Body& body, const scene::MaterialRegion& region, const GmshMesh& loaded,
                               const std::unordered_map<std::size_t, Index>& place_of_tag) {
  const auto group = loaded.element_groups.find(region.name);
  std::vector<Index> elements;
  if (group != loaded.element_groups.end()) {
    for (const std::size_t tag : group->second) {
      if (const auto found = place_of_tag.find(tag); found != place_of_tag.end()) {
        elements.push_back(found->second);
      }
    }
  }
  if (elements.empty()) {
    refuse_group(body, region, loaded);
  }
  return elements;
}

void refuse_elements_without_material(const scene::Body& body, const GmshMesh& loaded,
                                      const std::vector<Index>& regions) {
  const auto first = std::ranges::find(regions, no_region);
  if (first != regions.end()) {
    throw deck::DeckError(
        body.regions.front().where,
        fmt::format("bodies.{}.materials: {} elements of the mesh are in none of these groups, such as {}", body.name,
                    std::ranges::count(regions, no_region),
                    element_text(loaded, static_cast<Index>(first - regions.begin()))));
  }
}

}  // namespace

std::vector<Index> regions_by_group(const scene::Body& body, const GmshMesh& loaded) {
  std::unordered_map<std::size_t, Index> place_of_tag;
  for (std::size_t element = 0; element < loaded.element_tags.size(); ++element) {
    place_of_tag.emplace(loaded.element_tags[element], static_cast<Index>(element));
  }
  std::vector<Index> regions(loaded.element_tags.size(), no_region);
  for (Index number = 0; number < std::ssize(body.regions); ++number) {
    const scene::MaterialRegion& region = body.regions[number];
    for (const Index element : elements_of(body, region, loaded, place_of_tag)) {
      if (regions[element] != no_region && regions[element] != number) {
        throw deck::DeckError(
            region.where,
            fmt::format("bodies.{}.materials: {} is in both groups '{}' and '{}', so it would have "
                        "two materials",
                        body.name, element_text(loaded, element), body.regions[regions[element]].name, region.name));
      }
      regions[element] = number;
    }
  }
  refuse_elements_without_material(body, loaded, regions);
  return regions;
}

}  // namespace idiophone::mesh
