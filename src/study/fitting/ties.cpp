#include "ties.hpp"

#include <algorithm>
#include <functional>

namespace idiophone::fitting {

namespace {

/// The name of the unknown that moves a constant; empty: none does.
using UnknownOf = std::function<std::string(const ElasticConstant&)>;

Ties ties_by(const UnknownOf& unknown_of, const ElasticConstants& constants) {
  std::vector<std::string> names;
  for (const ElasticConstant& constant : constants) {
    const std::string name = unknown_of(constant);
    if (!name.empty() && std::ranges::find(names, name) == names.end()) {
      names.push_back(name);
    }
  }
  Ties ties = Ties::Zero(static_cast<Eigen::Index>(constants.size()), static_cast<Eigen::Index>(names.size()));
  for (std::size_t k = 0; k < constants.size(); ++k) {
    const auto place = std::ranges::find(names, unknown_of(constants[k]));
    if (place != names.end()) {
      ties(static_cast<Eigen::Index>(k), place - names.begin()) = 1.0;
    }
  }
  return ties;
}

/// The letter of the axis with the largest of Young's moduli.
char stiffest_axis(const scene::Orthotropy& constants) {
  Eigen::Index axis = 0;
  constants.young.maxCoeff(&axis);
  return "xyz"[axis];
}

}  // namespace

std::vector<Ties> stages_of_ties(const ElasticConstants& constants, const scene::Material& material,
                                 const std::vector<std::string>& fitted) {
  const auto itself = [&](const ElasticConstant& constant) {
    return fitted.empty() || std::ranges::find(fitted, constant.name) != fitted.end() ? constant.name : std::string();
  };
  const auto modulus = [&](const ElasticConstant& constant) {
    return constant.kind == ConstantKind::modulus ? itself(constant) : std::string();
  };
  const auto all_moduli = [&](const ElasticConstant& constant) {
    return modulus(constant).empty() ? std::string() : std::string("moduli");
  };
  std::vector<UnknownOf> stages = {all_moduli};
  if (material.orthotropy) {
    const char axis = stiffest_axis(*material.orthotropy);
    stages.emplace_back([modulus, axis](const ElasticConstant& constant) -> std::string {
      if (modulus(constant).empty()) {
        return {};
      }
      const std::size_t directions = constant.name.find('_') + 1;
      return constant.name.substr(0, directions) +
             (constant.name.find(axis, directions) < constant.name.size() ? "along" : "across");
    });
  }
  stages.emplace_back(modulus);
  stages.emplace_back(itself);
  std::vector<Ties> all;
  for (const UnknownOf& stage : stages) {
    const Ties ties = ties_by(stage, constants);
    const bool is_new = all.empty() || ties.cols() > all.back().cols();
    if (ties.cols() > 0 && is_new) {
      all.push_back(ties);
    }
  }
  return all;
}

Ties single_ties(const std::vector<bool>& chosen) {
  Ties ties = Ties::Zero(static_cast<Eigen::Index>(chosen.size()), std::ranges::count(chosen, true));
  Eigen::Index unknown = 0;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (chosen[k]) {
      ties(static_cast<Eigen::Index>(k), unknown++) = 1.0;
    }
  }
  return ties;
}

}  // namespace idiophone::fitting
