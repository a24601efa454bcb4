#pragma once
// The elastic constants of a material as the unknowns of a fit.

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "idiophone/scene/material.hpp"

namespace idiophone::fitting {

/// The unknown of a modulus is its logarithm. That of a ratio is the ratio itself: a Poisson's ratio, or
/// c_ij/sqrt(c_ii c_jj) of a crystal, which is between -1 and 1.
enum class ConstantKind { modulus, ratio };

struct ElasticConstant {
  std::string name;  ///< young, poisson; or young_x, ..., poisson_xy, ..., shear_xy, ... of an orthotropic material;
                     ///< or c11, ... of a crystal
  ConstantKind kind = ConstantKind::modulus;
  std::function<double&(scene::Material&)> in;  ///< where a material has it
  std::function<double(const scene::Material&)> unit = [](const scene::Material&) {
    return 1.0;
  };  ///< the value of a ratio of 1, given the moduli of the material
};

using ElasticConstants = std::vector<ElasticConstant>;

/// Those of the names, in the material's order; all of them where there are no names.
/// @throws std::runtime_error for a name that is not one of the material's constants
[[nodiscard]] ElasticConstants elastic_constants(const scene::Material& material,
                                                 const std::vector<std::string>& names);

/// Standard deviation of an unknown before anything is measured.
[[nodiscard]] double expected_deviation(const ElasticConstant& constant);

/// The unknowns of a material. [constants]
[[nodiscard]] Eigen::VectorXd unknowns(const ElasticConstants& constants, const scene::Material& material);

/// The material with other unknowns.
[[nodiscard]] scene::Material with_unknowns(const ElasticConstants& constants, scene::Material material,
                                            const Eigen::VectorXd& unknowns);

/// Derivatives of the values of the constants by their unknowns. [constants x constants]
[[nodiscard]] Eigen::MatrixXd value_slopes(const ElasticConstants& constants, const scene::Material& material);

}  // namespace idiophone::fitting
