#include "idiophone/solids/solid/oriented_material.hpp"

namespace idiophone::solid {

std::vector<OrientedMaterial> oriented_materials(const scene::Body& body, std::span<const scene::Material> materials) {
  std::vector<OrientedMaterial> result;
  for (const scene::MaterialRegion& region : body.all_regions()) {
    result.push_back({materials[region.material], body.turn() * region.grain, body.initial_stress()});
  }
  return result;
}

}  // namespace idiophone::solid
