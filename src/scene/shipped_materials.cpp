// Where each number comes from is in docs/use/materials.md.

#include "shipped_materials.hpp"

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

/// @param orthotropy  x along the grain, y across the rings, z along the rings
/// @param density     kg/m3
/// @param loss        tan(phi)
Material wood(const char* name, const Orthotropy& orthotropy, double density, double loss) {
  Material material = isotropic(name, orthotropy.young.maxCoeff(), 0.0, density, loss);
  material.orthotropy = orthotropy;
  return material;
}

}  // namespace

const std::vector<Material>& shipped_materials() {
  static const std::vector<Material> all = {
      isotropic("steel", 210.0e9, 0.293, 7850, 2e-4),
      isotropic("aluminium", 70.3e9, 0.345, 2700, 1e-4),
      isotropic("brass", 100.6e9, 0.350, 8500, 5e-4),
      isotropic("bronze", 100.0e9, 0.34, 8600, 5e-4),
      isotropic("copper", 129.8e9, 0.343, 8960, 2e-3),
      isotropic("glass", 71.3e9, 0.22, 2500, 1e-3),
      isotropic("alumina", 370.0e9, 0.22, 3900, 1e-4),
      isotropic("porcelain", 70.0e9, 0.20, 2400, 2e-3),
      isotropic("concrete", 30.0e9, 0.20, 2300, 6e-3),
      isotropic("acrylic", 5.6e9, 0.35, 1150, 0.03),
      isotropic("nylon", 2.9e9, 0.40, 1140, 0.014),
      isotropic("rubber", 2.0e6, 0.49, 930, 0.1),
      wood("spruce", {{11.9e9, 0.928e9, 0.512e9}, {0.372, 0.435, 0.467}, {0.762e9, 0.0357e9, 0.726e9}}, 450, 8e-3),
      wood("maple", {{13.9e9, 1.83e9, 0.903e9}, {0.424, 0.774, 0.476}, {1.54e9, 0.29e9, 0.876e9}}, 705, 0.01),
      wood("rosewood", {{13.5e9, 1.9e9, 0.95e9}, {0.38, 0.65, 0.45}, {1.5e9, 0.28e9, 1.1e9}}, 840, 6e-3),
  };
  return all;
}

}  // namespace idiophone::scene
