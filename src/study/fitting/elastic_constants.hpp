#pragma once
// The elastic constants of a material as the unknowns of a fit.

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "turned_material.hpp"

namespace idiophone::fitting {

/// The unknown of a modulus is its logarithm. That of a ratio is the ratio itself: a Poisson's ratio, or
/// c_ij/sqrt(c_ii c_jj) of a crystal, which is between -1 and 1. That of a turn of the axes is its angle in rad.
enum class ConstantKind { modulus, ratio, turn };

struct ElasticConstant {
  std::string name;  ///< young, poisson; or young_x, ..., poisson_xy, ..., shear_xy, ... of an orthotropic material;
                     ///< or c11, ... of a crystal; or turn_x, turn_y, turn_z of the axes
  ConstantKind kind = ConstantKind::modulus;
  std::function<double&(TurnedMaterial&)> in;  ///< where a material has it
  std::function<double(const scene::Material&)> unit = [](const scene::Material&) {
    return 1.0;
  };  ///< the value of a ratio of 1 or a turn of 1 rad, given the moduli of the material
};

using ElasticConstants = std::vector<ElasticConstant>;

/// All constants of a material, without turns.
[[nodiscard]] ElasticConstants elastic_constants(const scene::Material& material);

/// Standard deviation of an unknown before anything is measured.
[[nodiscard]] double expected_deviation(const ElasticConstant& constant);

/// The unknowns of a material. [constants]
[[nodiscard]] Eigen::VectorXd unknowns(const ElasticConstants& constants, const TurnedMaterial& material);

/// The material with other unknowns.
[[nodiscard]] TurnedMaterial with_unknowns(const ElasticConstants& constants, TurnedMaterial material,
                                           const Eigen::VectorXd& unknowns);

/// Derivatives of the values of the constants by their unknowns. [constants x constants]
[[nodiscard]] Eigen::MatrixXd value_slopes(const ElasticConstants& constants, const TurnedMaterial& material);

}  // namespace idiophone::fitting
