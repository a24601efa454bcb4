#include "values_of_views.hpp"

#include <fmt/format.h>

#include <cmath>
#include <unordered_map>

#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::mesh {

namespace {

MeshValues values_of_view(const scene::Body& body, const ViewBlock& view, const std::vector<std::size_t>& tags,
                          const std::vector<Index>& order) {
  const char* what = view.of_elements == 0 ? "node" : "element";
  const auto refuse_view = [&](const std::string& why) {
    throw deck::DeckError(body.mesh_where, fmt::format("the view '{}' of {} {}", view.name, body.mesh.string(), why));
  };
  if (view.steps != 1 || view.values.size() != view.tags.size()) {
    refuse_view(fmt::format("has vectors or several time steps; it needs one number for each {}", what));
  }
  std::unordered_map<std::uint64_t, double> by_tag;
  for (std::size_t i = 0; i < view.tags.size(); ++i) {
    by_tag[view.tags[i]] = view.values[i];
  }
  MeshValues result{.name = view.name, .of_elements = view.of_elements != 0, .value = {}};
  for (const Index place : order) {
    const auto found = by_tag.find(tags[place]);
    if (found == by_tag.end()) {
      refuse_view(fmt::format("has no value for {} {}; give all of them one", what, tags[place]));
    }
    if (!std::isfinite(found->second)) {
      refuse_view(fmt::format("has a value for {} {} that is not finite", what, tags[place]));
    }
    result.value.push_back(found->second);
  }
  return result;
}

}  // namespace

std::vector<MeshValues> values_of_views(const scene::Body& body, const GmshMesh& loaded,
                                        const std::vector<Index>& nodes, const std::vector<Index>& elements) {
  std::vector<MeshValues> values;
  for (const ViewBlock& view : loaded.views) {
    values.push_back(view.of_elements == 0 ? values_of_view(body, view, loaded.node_tags, nodes)
                                           : values_of_view(body, view, loaded.element_tags, elements));
  }
  return values;
}

}  // namespace idiophone::mesh
