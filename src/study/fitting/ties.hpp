#pragma once
// Few unknowns that move many elastic constants.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "elastic_constants.hpp"

namespace idiophone::fitting {

/// Which constants each unknown moves: [constants x unknowns], 1 where it moves one, by as much as the unknown itself.
using Ties = Eigen::MatrixXd;

/// Ties of a fit that begins with few unknowns, from one for all moduli to one for each constant. In between, an
/// orthotropic material is first transversely isotropic, as far as its changes go, about the axis of the largest of
/// Young's moduli; then each modulus is by itself. The others keep their values.
/// @param constants  all of the material
/// @param fitted     the names of those that may change; empty: all
[[nodiscard]] std::vector<Ties> stages_of_ties(const ElasticConstants& constants, const scene::Material& material,
                                               const std::vector<std::string>& fitted);

/// An unknown for each of these constants by itself.
/// @param chosen  [constants]
[[nodiscard]] Ties single_ties(const std::vector<bool>& chosen);

}  // namespace idiophone::fitting
