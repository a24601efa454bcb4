// The elastic constants of a material: the same in all directions, given along three axes, or those of a crystal.

#include <cmath>

#include "idiophone/scene/sections.hpp"
#include "idiophone/scene/symmetries.hpp"

namespace idiophone::scene {

namespace {

/// What makes the stiffness of such a material not positive definite, so that it would gain energy by being strained;
/// empty where nothing does.
std::string contradiction(const Orthotropy& constants) {
  const auto& [e, nu, shear] = constants;
  constexpr int pairs[3][2] = {{0, 1}, {1, 2}, {0, 2}};
  for (int p = 0; p < 3; ++p) {
    const auto [i, j] = pairs[p];
    const double most = std::sqrt(e[i] / e[j]);
    if (!(std::abs(nu[p]) < most)) {
      return fmt::format(
          "{0}{1} must be above -{2:.4g} and below {2:.4g}, sqrt(E_{0}/E_{1}), found {3:.6g}: such a material would "
          "gain energy by being strained",
          "xyz"[i], "xyz"[j], most, nu[p]);
    }
  }
  constexpr double least = 1e-4;  // nearer to 0, the material is as good as incompressible and needs very short steps
  const double rest = 1 - nu[0] * nu[0] * e[1] / e[0] - nu[1] * nu[1] * e[2] / e[1] - nu[2] * nu[2] * e[2] / e[0] -
                      2 * nu[0] * nu[1] * nu[2] * e[2] / e[0];
  return rest >= least
             ? ""
             : fmt::format(
                   "the three together are too large: 1 - nu_xy nu_yx - nu_yz nu_zy - nu_xz nu_zx - "
                   "2 nu_xy nu_yz nu_zx, with nu_ji = nu_ij E_j/E_i, must be at least {}, and is {:.4g}: such a "
                   "material would gain energy by being strained",
                   least, rest);
}

bool is_list(const Node* node) {
  return node != nullptr && node->kind == Node::Kind::list;
}

/// What makes a crystal gain energy by being strained; empty where nothing does.
std::string contradiction(const Crystal& crystal) {
  constexpr double least = 1e-4;  // of the largest: softer is as good as without resistance
  const Eigen::Vector<double, 6> moduli = kelvin_moduli(stiffness_matrix(crystal));
  return moduli[0] >= least * moduli[5]
             ? ""
             : fmt::format(
                   "this stiffness is not positive definite: its smallest eigenvalue is {:.4g} Pa, and must be at "
                   "least "
                   "{:.4g} Pa, {} of the largest; such a crystal would gain energy by being strained",
                   moduli[0], least * moduli[5], least);
}

/// The key stiffness, in place of young, poisson and shear.
void read_crystal(Section& section, Material& material) {
  for (const char* key : {"young", "poisson", "shear"}) {
    section.refuse(key,
                   section.find("stiffness") != nullptr
                       ? "has no meaning beside the key stiffness, which holds all elastic constants"
                       : fmt::format("has no meaning: '{}' starts from a crystal; give its stiffness", material.name));
  }
  if (section.find("stiffness") == nullptr || section.required("stiffness", material.crystal.emplace())) {
    material.orthotropy.reset();
    material.young = constants_along_axes(material)->young.maxCoeff();
  }
}

}  // namespace

const Choices<Symmetry>& symmetries() {
  static const Choices<Symmetry> all{{{"cubic", Symmetry::cubic},
                                      {"hexagonal", Symmetry::hexagonal},
                                      {"trigonal", Symmetry::trigonal},
                                      {"tetragonal", Symmetry::tetragonal},
                                      {"orthotropic", Symmetry::orthotropic},
                                      {"monoclinic", Symmetry::monoclinic},
                                      {"triclinic", Symmetry::triclinic}}};
  return all;
}

static bool read(const Node& node, Mistakes& mistakes, Crystal& crystal) {
  Section section(node, mistakes);
  const bool has_symmetry = section.required("symmetry", crystal.symmetry, symmetries());
  if (!has_symmetry) {
    return false;
  }
  const std::span<const CrystalConstant> each = independent_constants(crystal.symmetry);
  crystal.constants.assign(each.size(), 0.0);
  for (std::size_t k = 0; k < each.size(); ++k) {
    const Range range{.at_least = each[k].is_diagonal ? 1.0 : -1e15, .at_most = 1e15, .unit = "Pa"};
    if (each[k].is_optional) {
      section.optional(each[k].name, crystal.constants[k], range);
    } else {
      section.required(each[k].name, crystal.constants[k], range);
    }
  }
  if (!section.finish()) {
    return false;
  }
  const std::string reason = contradiction(crystal);
  return reason.empty() || mistakes.add(node, reason);
}

void read_elastic_constants(Section& section, Material& material) {
  for (const char* key : {"young", "poisson", "shear", "stiffness"}) {
    section.know(key);
  }
  if (section.find("stiffness") != nullptr || material.crystal) {
    read_crystal(section, material);
    return;
  }
  const bool directional = is_list(section.find("young")) || is_list(section.find("poisson")) ||
                           section.find("shear") != nullptr || material.orthotropy;
  // What it starts from has all that must be given otherwise, if it is of the same kind.
  const bool complete = section.find("from") != nullptr && material.orthotropy.has_value() == directional;
  const auto need = [&](const std::string& key, auto& value, const Range& range) {
    return complete ? section.optional(key, value, range) : section.required(key, value, range);
  };
  const Range modulus{.at_least = 1.0, .at_most = 1e15, .unit = "Pa"};
  if (!directional) {
    need("young", material.young, modulus);
    need("poisson", material.poisson, Range{.at_least = -0.9999, .at_most = 0.4999});
    return;
  }
  Orthotropy constants = material.orthotropy.value_or(Orthotropy{});
  const bool has_young = need("young", constants.young, modulus);
  const bool has_poisson = need("poisson", constants.poisson, Range{.at_least = -100.0, .at_most = 100.0});
  const bool has_shear = need("shear", constants.shear, modulus);
  if (has_young && has_poisson && has_shear) {
    if (const std::string reason = contradiction(constants); !reason.empty()) {
      const Node* poisson = section.find("poisson");
      section.mistakes().add(poisson != nullptr ? *poisson : section.node(), reason);
    }
  }
  material.orthotropy = constants;
  material.young = constants.young.maxCoeff();
}

}  // namespace idiophone::scene
