#pragma once
// K x = lambda M x among the components that are free to move.

#include <petscmat.h>

#include <vector>

#include "idiophone/foundation/parallel/petsc.hpp"

namespace idiophone::eigenmodes {

/// Matrices, and how their vectors belong to a field on the body.
class EigenProblem {
 public:
  EigenProblem() = default;
  virtual ~EigenProblem() = default;
  EigenProblem(const EigenProblem&) = delete;
  EigenProblem& operator=(const EigenProblem&) = delete;
  EigenProblem(EigenProblem&&) = delete;
  EigenProblem& operator=(EigenProblem&&) = delete;

  [[nodiscard]] virtual Mat stiffness() const = 0;  ///< K, N/m
  [[nodiscard]] virtual Mat mass() const = 0;       ///< M, kg

  /// A new vector of the free components out of a field at the owned nodes.
  [[nodiscard]] virtual parallel::Handle<Vec> restricted(const std::vector<double>& field) const = 0;
  /// A field at the owned nodes, zero where held, out of a vector of the free components.
  [[nodiscard]] virtual std::vector<double> extended(Vec vector) const = 0;
};

}  // namespace idiophone::eigenmodes
