#pragma once
// SLEPc's Krylov-Schur, shifted and inverted by MUMPS's parallel Cholesky factors.

#include <optional>
#include <string>
#include <vector>

#include "eigen_problem.hpp"
#include "idiophone/foundation/part_watch.hpp"
#include "idiophone/solids/eigenmodes/no_modes.hpp"

namespace idiophone::eigenmodes {

/// An eigenpair of K x = lambda M x.
struct Eigenpair {
  double value = 0.0;          ///< lambda, (rad/s)^2
  std::vector<double> vector;  ///< a field at the owned nodes, x^T M x = 1
};

/// How many eigenpairs are wanted beside the rigid motions.
struct EigenpairCount {
  int count = 0;
  std::optional<double> below = std::nullopt;  ///< (rad/s)^2: where it is known that so many are below it
};

/// The lowest eigenpairs beside the rigid motions, ascending. Collective.
/// @param shift  above zero or, without rigid motions, zero; the search begins at -shift, (rad/s)^2
/// @param watch  of the search; if it ends that, there are fewer eigenpairs, the lowest ones
/// @throws std::runtime_error where fewer are found, one is wrong, or the rigid motions are not without strain
[[nodiscard]] std::vector<Eigenpair> lowest_eigenpairs(const EigenProblem& problem,
                                                       const std::vector<std::vector<double>>& rigid_motions,
                                                       const EigenpairCount& wanted, double shift,
                                                       const PartWatch& watch = {});

/// The error of a body that has no modes up to a frequency (Hz). It searches for the lowest mode, to name its
/// frequency. Collective.
/// @param body  as in NoModes; the other parameters are those of lowest_eigenpairs()
[[nodiscard]] NoModes no_modes_up_to(double frequency, const std::string& body, const EigenProblem& problem,
                                     const std::vector<std::vector<double>>& rigid_motions, double shift);

}  // namespace idiophone::eigenmodes
