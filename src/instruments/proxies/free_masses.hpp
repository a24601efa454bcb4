#pragma once
// Unknowns of the masses that are not pinned, for systems of equations.

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::proxies {

/// Numbers three unknowns for each mass that is not pinned.
class FreeMasses {
 public:
  explicit FreeMasses(const std::vector<bool>& pinned) {
    for (const bool is_pinned : pinned) {
      first_.push_back(is_pinned ? -1 : unknowns_);
      unknowns_ += is_pinned ? 0 : 3;
    }
  }

  [[nodiscard]] Index unknowns() const { return unknowns_; }
  [[nodiscard]] bool is_free(std::size_t mass) const { return first_[mass] >= 0; }
  [[nodiscard]] Index first(std::size_t mass) const { return first_[mass]; }  ///< of three; of a mass that is free

  /// Adds a spring to the entries of a stiffness matrix. @param block  force over displacement of one end, N/m
  void add_spring(std::vector<Eigen::Triplet<double>>& entries, const Spring& spring,
                  const Eigen::Matrix3d& block) const {
    add(entries, spring.a, spring.a, block);
    add(entries, spring.b, spring.b, block);
    add(entries, spring.a, spring.b, -block);
    add(entries, spring.b, spring.a, -block);
  }

 private:
  void add(std::vector<Eigen::Triplet<double>>& entries, Index row, Index column, const Eigen::Matrix3d& block) const {
    if (!is_free(row) || !is_free(column)) {
      return;
    }
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        entries.emplace_back(first(row) + i, first(column) + j, block(i, j));
      }
    }
  }

  std::vector<Index> first_;  ///< [masses] -1: pinned
  Index unknowns_ = 0;
};

}  // namespace idiophone::proxies
