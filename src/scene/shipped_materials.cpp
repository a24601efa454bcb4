// Where each number comes from is in docs/materials.md.

#include "idiophone/scene/shipped_materials.hpp"

namespace idiophone::scene {

namespace {

/// @param young    Pa
/// @param density  kg/m3
/// @param loss     tan(phi)
Material isotropic(const char* name, double young, double poisson, double density, double loss) {
  Material material;
  material.name = name;
  material.young = young;
  material.poisson = poisson;
  material.density = density;
  material.damping.loss.emplace().value = loss;
  return material;
}

}  // namespace

const std::vector<Material>& shipped_materials() {
  static const std::vector<Material> all = {
      isotropic("steel", 210.0e9, 0.293, 7850, 2e-4),  isotropic("aluminium", 70.3e9, 0.345, 2700, 1e-4),
      isotropic("brass", 100.6e9, 0.350, 8500, 5e-4),  isotropic("bronze", 100.0e9, 0.34, 8600, 5e-4),
      isotropic("copper", 129.8e9, 0.343, 8960, 2e-3), isotropic("glass", 71.3e9, 0.22, 2500, 1e-3),
      isotropic("alumina", 370.0e9, 0.22, 3900, 1e-4), isotropic("porcelain", 70.0e9, 0.20, 2400, 2e-3),
      isotropic("concrete", 30.0e9, 0.20, 2300, 6e-3), isotropic("acrylic", 5.6e9, 0.35, 1150, 0.03),
      isotropic("nylon", 2.9e9, 0.40, 1140, 0.014),    isotropic("rubber", 2.0e6, 0.49, 930, 0.1),
  };
  return all;
}

}  // namespace idiophone::scene
