#include "regions_by_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

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
      fmt::format("bodies.{}.materials: {} has no physical group '{}' of elements of the body; {}", body.name,
                  body.mesh.string(), region.name,
                  loaded.element_groups.empty()
                      ? fmt::format("it has none: define them by Physical {}(\"{}\") in gmsh", kind, region.name)
                      : fmt::format("it has: {}", listed_names(loaded.element_groups))));
}

std::string text_of(const GmshMesh& loaded, Index element) {
  return loaded.mesh.nodes.empty() ? fmt::format("element {}", loaded.element_tags[element])
                                   : element_text(loaded, element);
}

}  // namespace

std::vector<Index> found_regions(const scene::Body& body, const GmshMesh& loaded) {
  const auto tag_of = [&](Index element) { return loaded.element_tags[element]; };
  std::vector<Index> by_tag(loaded.element_tags.size());
  std::iota(by_tag.begin(), by_tag.end(), 0);
  std::ranges::sort(by_tag, {}, tag_of);
  std::vector<Index> regions(loaded.element_tags.size(), no_region);
  for (Index number = 0; number < std::ssize(body.regions); ++number) {
    const scene::MaterialRegion& region = body.regions[number];
    const auto group = loaded.element_groups.find(region.name);
    if (group == loaded.element_groups.end()) {
      continue;
    }
    for (const std::size_t tag : group->second) {
      const auto found = std::ranges::lower_bound(by_tag, tag, {}, tag_of);
      if (found == by_tag.end() || tag_of(*found) != tag) {
        continue;  // an element of a surface
      }
      Index& its = regions[*found];
      if (its != no_region && its != number) {
        throw deck::DeckError(
            region.where,
            fmt::format("bodies.{}.materials: in {}, {} is in both groups '{}' and '{}', so it would "
                        "have two materials",
                        body.name, body.mesh.string(), text_of(loaded, *found), body.regions[its].name, region.name));
      }
      its = number;
    }
  }
  return regions;
}

std::vector<Index> region_counts(const scene::Body& body, std::span<const Index> regions) {
  std::vector<Index> counts(body.regions.size() + 1);
  for (const Index region : regions) {
    ++counts[region == no_region ? body.regions.size() : static_cast<std::size_t>(region)];
  }
  return counts;
}

void require_regions(const scene::Body& body, const GmshMesh& loaded, std::span<const Index> regions,
                     std::span<const Index> counts) {
  for (std::size_t number = 0; number < body.regions.size(); ++number) {
    if (counts[number] == 0) {
      refuse_group(body, body.regions[number], loaded);
    }
  }
  const auto first = std::ranges::find(regions, no_region);
  if (first != regions.end()) {
    throw deck::DeckError(
        body.regions.front().where,
        fmt::format("bodies.{}.materials: {} elements of {} are in none of these groups, such as {}", body.name,
                    counts.back(), body.mesh.string(), text_of(loaded, static_cast<Index>(first - regions.begin()))));
  }
}

std::vector<Index> regions_by_group(const scene::Body& body, const GmshMesh& loaded) {
  std::vector<Index> regions = found_regions(body, loaded);
  require_regions(body, loaded, regions, region_counts(body, regions));
  return regions;
}

}  // namespace idiophone::mesh
