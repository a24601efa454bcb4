#include "elastic_constants.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "idiophone/foundation/deck/suggestion.hpp"

namespace idiophone::fitting {

namespace {

ElasticConstants all_constants(const scene::Material& material) {
  if (!material.orthotropy) {
    return {{"young", ConstantKind::modulus, [](scene::Material& m) -> double& { return m.young; }},
            {"poisson", ConstantKind::poisson_ratio, [](scene::Material& m) -> double& { return m.poisson; }}};
  }
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
  add("poisson", planes, ConstantKind::poisson_ratio, &scene::Orthotropy::poisson);
  add("shear", planes, ConstantKind::modulus, &scene::Orthotropy::shear);
  return constants;
}

}  // namespace

ElasticConstants elastic_constants(const scene::Material& material, const std::vector<std::string>& names) {
  if (material.crystal) {
    throw std::runtime_error(fmt::format(
        "material {} is a crystal, whose constants are not fitted; give young, poisson and shear instead of stiffness",
        material.name));
  }
  ElasticConstants constants = all_constants(material);
  std::vector<std::string> known;
  std::ranges::transform(constants, std::back_inserter(known), &ElasticConstant::name);
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) == known.end()) {
      throw std::runtime_error(fmt::format("material {} has no elastic constant '{}'{}; it has: {}", material.name,
                                           name, deck::suggestion(name, known), fmt::join(known, ", ")));
    }
  }
  if (!names.empty()) {
    std::erase_if(constants, [&](const ElasticConstant& constant) {
      return std::ranges::find(names, constant.name) == names.end();
    });
  }
  return constants;
}

Eigen::VectorXd unknowns(const ElasticConstants& constants, const scene::Material& material) {
  scene::Material source = material;
  Eigen::VectorXd values(constants.size());
  std::ranges::transform(constants, values.begin(), [&](const ElasticConstant& constant) {
    const double value = constant.in(source);
    return constant.kind == ConstantKind::modulus ? std::log(value) : value;
  });
  return values;
}

scene::Material with_unknowns(const ElasticConstants& constants, scene::Material material,
                              const Eigen::VectorXd& unknowns) {
  for (std::size_t i = 0; i < constants.size(); ++i) {
    constants[i].in(material) = constants[i].kind == ConstantKind::modulus ? std::exp(unknowns[i]) : unknowns[i];
  }
  if (material.orthotropy) {
    material.young = material.orthotropy->young.maxCoeff();
  }
  return material;
}

}  // namespace idiophone::fitting
