#include "idiophone/solids/solid/oriented_material.hpp"

#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::solid {

namespace {

/// Of an undeformed body whose material would grow by this part of itself in all directions, Pa.
Eigen::Matrix3d stress_of_growth(const scene::Material& material, const Eigen::Matrix3d& axes, double growth) {
  const Eigen::Matrix3d strain = -growth * Eigen::Matrix3d::Identity();
  return stress_of(elasticity(material, axes), strain);
}

}  // namespace

std::vector<OrientedMaterial> oriented_materials(const scene::Body& body, std::span<const scene::Material> materials) {
  std::vector<OrientedMaterial> result;
  for (const scene::MaterialRegion& region : body.all_regions()) {
    const scene::Material& material = materials[region.material];
    const Eigen::Matrix3d axes = body.turn() * region.grain;
    Eigen::Matrix3d stress = body.initial_stress();
    if (body.prestress && material.expansion) {
      stress += stress_of_growth(material, axes, *material.expansion * body.prestress->temperature);
    }
    result.push_back({material, axes, stress});
  }
  return result;
}

}  // namespace idiophone::solid
