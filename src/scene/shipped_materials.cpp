// Where each number comes from is in docs/materials.md.

#include "idiophone/scene/shipped_materials.hpp"

namespace idiophone::scene {

namespace {

/// @param young    Pa
/// @param density  kg/m3
Material isotropic(const char* name, double young, double poisson, double density) {
  Material material;
  material.name = name;
  material.young = young;
  material.poisson = poisson;
  material.density = density;
  return material;
}

}  // namespace

const std::vector<Material>& shipped_materials() {
  static const std::vector<Material> all = {
      isotropic("steel", 210.0e9, 0.293, 7850),  isotropic("aluminium", 70.3e9, 0.345, 2700),
      isotropic("brass", 100.6e9, 0.350, 8500),  isotropic("bronze", 100.0e9, 0.34, 8600),
      isotropic("copper", 129.8e9, 0.343, 8960), isotropic("glass", 71.3e9, 0.22, 2500),
      isotropic("alumina", 370.0e9, 0.22, 3900), isotropic("porcelain", 70.0e9, 0.20, 2400),
      isotropic("concrete", 30.0e9, 0.20, 2300), isotropic("acrylic", 5.6e9, 0.35, 1150),
      isotropic("nylon", 2.9e9, 0.40, 1140),     isotropic("rubber", 2.0e6, 0.49, 930),
  };
  return all;
}

}  // namespace idiophone::scene
