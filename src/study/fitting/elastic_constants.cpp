#include "elastic_constants.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "idiophone/scene/anisotropy.hpp"

namespace idiophone::fitting {

namespace {

/// An optional constant that is 0 stays so: the class of the crystal lacks it.
ElasticConstants crystal_constants(const scene::Crystal& crystal) {
  ElasticConstants constants;
  const auto each = scene::independent_constants(crystal.symmetry);
  for (std::size_t k = 0; k < each.size(); ++k) {
    if (each[k].is_optional && crystal.constants[k] == 0) {
      continue;
    }
    const int row = each[k].name[1] - '1';
    const int column = each[k].name[2] - '1';
    constants.push_back({.name = each[k].name,
                         .kind = each[k].is_diagonal ? ConstantKind::modulus : ConstantKind::ratio,
                         .in = [k](scene::Material& m) -> double& { return (*m.crystal).constants[k]; },
                         .unit =
                             [row, column](const scene::Material& m) {
                               const scene::StiffnessMatrix c = scene::stiffness_matrix(*m.crystal);
                               return std::sqrt(c(row, row) * c(column, column));
                             }});
  }
  return constants;
}

ElasticConstants orthotropic_constants() {
  constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
  constexpr std::array<const char*, 3> planes = {"xy", "yz", "xz"};
  ElasticConstants constants;
  const auto add = [&](const std::string& name, const auto& directions, ConstantKind kind,
                       Vector3 scene::Orthotropy::*member) {
    for (int i = 0; i < 3; ++i) {
      constants.push_back({name + "_" + directions.at(i), kind,
                           [member, i](scene::Material& m) -> double& { return ((*m.orthotropy).*member)[i]; }});
    }
  };
  add("young", axes, ConstantKind::modulus, &scene::Orthotropy::young);
  add("poisson", planes, ConstantKind::ratio, &scene::Orthotropy::poisson);
  add("shear", planes, ConstantKind::modulus, &scene::Orthotropy::shear);
  return constants;
}

}  // namespace

ElasticConstants elastic_constants(const scene::Material& material) {
  if (material.crystal) {
    return crystal_constants(*material.crystal);
  }
  if (material.orthotropy) {
    return orthotropic_constants();
  }
  return {{"young", ConstantKind::modulus, [](scene::Material& m) -> double& { return m.young; }},
          {"poisson", ConstantKind::ratio, [](scene::Material& m) -> double& { return m.poisson; }}};
}

double expected_deviation(const ElasticConstant& constant) {
  switch (constant.kind) {
    case ConstantKind::modulus:
      return 0.2;
    case ConstantKind::ratio:
      return 0.1;
    case ConstantKind::turn:
      break;
  }
  return 0.3;  // rad, 17 degrees
}

Eigen::VectorXd unknowns(const ElasticConstants& constants, const TurnedMaterial& material) {
  TurnedMaterial source = material;
  Eigen::VectorXd values(constants.size());
  std::ranges::transform(constants, values.begin(), [&](const ElasticConstant& constant) {
    const double value = constant.in(source);
    return constant.kind == ConstantKind::modulus ? std::log(value) : value / constant.unit(material);
  });
  return values;
}

TurnedMaterial with_unknowns(const ElasticConstants& constants, TurnedMaterial material,
                             const Eigen::VectorXd& unknowns) {
  for (std::size_t i = 0; i < constants.size(); ++i) {
    if (constants[i].kind == ConstantKind::modulus) {
      constants[i].in(material) = std::exp(unknowns[i]);
    }
  }
  const scene::Material of_moduli = material;
  for (std::size_t i = 0; i < constants.size(); ++i) {
    if (constants[i].kind != ConstantKind::modulus) {
      constants[i].in(material) = unknowns[i] * constants[i].unit(of_moduli);
    }
  }
  if (const auto along_axes = scene::constants_along_axes(material)) {
    material.young = along_axes->young.maxCoeff();
  }
  return material;
}

Eigen::MatrixXd value_slopes(const ElasticConstants& constants, const TurnedMaterial& material) {
  const Eigen::VectorXd here = unknowns(constants, material);
  const auto values = [&](const Eigen::VectorXd& there) {
    TurnedMaterial other = with_unknowns(constants, material, there);
    Eigen::VectorXd found(here.size());
    std::ranges::transform(constants, found.begin(),
                           [&](const ElasticConstant& constant) { return constant.in(other); });
    return found;
  };
  constexpr double h = 1e-5;  // for central differences
  Eigen::MatrixXd slopes(here.size(), here.size());
  for (Eigen::Index k = 0; k < here.size(); ++k) {
    const Eigen::VectorXd change = h * Eigen::VectorXd::Unit(here.size(), k);
    slopes.col(k) = (values(here + change) - values(here - change)) / (2 * h);
  }
  return slopes;
}

}  // namespace idiophone::fitting
