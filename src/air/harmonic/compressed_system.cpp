#include "compressed_system.hpp"

#include <algorithm>

#include "idiophone/foundation/each_once.hpp"
#include "local_potential.hpp"

namespace idiophone::harmonic {

namespace {

bool contains(const std::vector<Index>& numbers, Index number) {
  return std::ranges::binary_search(numbers, number);
}

}  // namespace

CompressedSystem::CompressedSystem(const Equations& equations, std::span<const PointSource> sources,
                                   double longest_edge)
    : equations_(equations),
      grid_(grid_about(vertices_and_images(equations.boundary), longest_edge, equations.wave_number)),
      receivers_(receivers_of(equations, grid_)),
      convolution_(grid_, equations.wave_number) {
  find_dipoles();
  make_pattern();
  right_sides_.setZero(equations.vertices(), equations.slopes.cols());
  equations.add_mass(matrix_, right_sides_);
  equations.add_incident(sources, right_sides_);
  for (const Receiver& receiver : receivers_) {
    add_panel_pairs(receiver);
  }
  factorise(longest_edge);
  const auto slopes = slope_charges();
  for (const Receiver& receiver : receivers_) {
    subtract_grid(receiver, slopes);
  }
  add_grid_right_sides(slopes);
}

void CompressedSystem::find_dipoles() {
  // The part of the tests that the normal derivative makes.
  for (const Stencil& test : receivers_.front().tests) {
    dipoles_.push_back({test.middle, (test.weights.imag() / equations_.coupling.imag()).cast<Complex>()});
  }
}

/// Charges of q on each panel: [motions][panels].
std::vector<std::vector<Stencil>> CompressedSystem::slope_charges() const {
  std::vector<std::vector<Stencil>> all(equations_.slopes.cols());
  for (std::size_t s = 0; s < equations_.panels.size(); ++s) {
    const Panel& panel = equations_.panels[s];
    const std::array<int, 3> middle = grid_.nearest(panel.centre);
    for (std::vector<Stencil>& stencils : all) {
      stencils.push_back({middle, Eigen::VectorXcd::Zero(grid_.stencil_size())});
    }
    for (const TrianglePoint& q : triangle_rule_5()) {
      const Interpolation at = interpolate(grid_, middle, panel.at(q.shape), panel.normal);
      for (std::size_t m = 0; m < all.size(); ++m) {
        const auto corners =
            equations_.slopes.col(static_cast<Eigen::Index>(m)).segment<3>(static_cast<Eigen::Index>(3 * s));
        const Complex slope = corners.cwiseProduct(q.shape.cast<Complex>()).sum();
        all[m].back().weights += q.weight * panel.area * slope * at.value;
      }
    }
  }
  return all;
}

void CompressedSystem::make_pattern() {
  std::vector<Eigen::Triplet<Complex>> zeros;
  for (const Receiver& receiver : receivers_) {
    for (std::size_t a = 0; a < receiver.vertices.size(); ++a) {
      for (const Index b : receiver.vertices[a]) {
        zeros.emplace_back(static_cast<int>(a), b, 0.0);
      }
    }
  }
  matrix_.resize(equations_.vertices(), equations_.vertices());
  matrix_.setFromTriplets(zeros.begin(), zeros.end());
}

void CompressedSystem::add_panel_pairs(const Receiver& receiver) {
  const auto& triangles = equations_.boundary.triangles;
  const Eigen::MatrixXcd& slopes = equations_.slopes;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    std::vector<Index> near;
    for (const Index a : triangles[t]) {
      near.insert(near.end(), receiver.panels_near[a].begin(), receiver.panels_near[a].end());
    }
    keep_each_once(near);
    for (const Index s : near) {
      const PanelPair pair = panel_pair(receiver.panels[t], equations_.panels[s], equations_.wave_number);
      const Eigen::Matrix3cd block = equations_.pressure_block(receiver.panels[t], equations_.panels[s], pair);
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = triangles[t].at(i);
        for (std::size_t j = 0; j < 3; ++j) {
          const Index b = triangles[s].at(j);
          if (contains(receiver.vertices[a], b)) {
            matrix_.coeffRef(a, b) += receiver.gain * block(i, j);
          }
          if (contains(receiver.panels_near[a], s)) {
            right_sides_.row(a) += receiver.gain * pair.single_layer(i, j) * slopes.row(3 * Eigen::Index{s} + j);
          }
          if (contains(receiver.panels_near[b], static_cast<Index>(t))) {  // K', as in burton_miller()
            right_sides_.row(b) +=
                receiver.gain * equations_.coupling * pair.double_layer(i, j) * slopes.row(3 * t + i);
          }
        }
      }
    }
  }
}

void CompressedSystem::subtract_grid(const Receiver& receiver, const std::vector<std::vector<Stencil>>& slopes) {
  LocalPotential potential(grid_, equations_.wave_number);
  for (std::size_t a = 0; a < receiver.tests.size(); ++a) {
    std::vector<const std::array<int, 3>*> middles;
    for (const Index b : receiver.vertices[a]) {
      middles.push_back(&dipoles_[b].middle);
    }
    for (const Index s : receiver.panels_near[a]) {
      middles.push_back(&slopes.front()[s].middle);
    }
    if (middles.empty()) {
      continue;
    }
    potential.compute(receiver.tests[a].middle, receiver.tests[a].weights, middles);
    for (const Index b : receiver.vertices[a]) {
      matrix_.coeffRef(static_cast<Index>(a), b) -=
          receiver.gain * potential.gather(dipoles_[b].middle, dipoles_[b].weights);
    }
    for (std::size_t m = 0; m < slopes.size(); ++m) {
      for (const Index s : receiver.panels_near[a]) {
        right_sides_(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(m)) -=
            receiver.gain * potential.gather(slopes[m][s].middle, slopes[m][s].weights);
      }
    }
  }
}

void CompressedSystem::add_grid_right_sides(const std::vector<std::vector<Stencil>>& slopes) {
  for (std::size_t m = 0; m < slopes.size(); ++m) {
    const std::span<Complex> field = convolution_.charges();
    for (const Stencil& charges : slopes[m]) {
      scatter(charges, 1.0, field);
    }
    convolution_.transform();
    for (const Receiver& receiver : receivers_) {
      for (std::size_t a = 0; a < receiver.tests.size(); ++a) {
        right_sides_(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(m)) +=
            receiver.gain * gather(receiver.tests[a], field);
      }
    }
  }
}

void CompressedSystem::factorise(double longest_edge) {
  SparseMatrix close = matrix_;
  close.prune([&](Eigen::Index a, Eigen::Index b, const Complex&) {
    return std::ranges::any_of(receivers_, [&](const Receiver& receiver) {
      return (receiver.places[a] - receivers_.front().places[b]).norm() < 2.0 * longest_edge;
    });
  });
  factors_.setDroptol(1e-3);
  factors_.setFillfactor(4);
  factors_.compute(close);
}

void CompressedSystem::scatter(const Stencil& stencil, Complex factor, std::span<Complex> charges) const {
  Eigen::Index number = 0;
  for (int i = -grid_.reach; i <= grid_.reach; ++i) {
    for (int j = -grid_.reach; j <= grid_.reach; ++j) {
      const std::size_t line = convolution_.place(stencil.middle[0] + i, stencil.middle[1] + j, stencil.middle[2]);
      for (int k = -grid_.reach; k <= grid_.reach; ++k) {
        charges[line + k] += factor * stencil.weights[number++];
      }
    }
  }
}

Complex CompressedSystem::gather(const Stencil& stencil, std::span<const Complex> potentials) const {
  Complex sum = 0.0;
  Eigen::Index number = 0;
  for (int i = -grid_.reach; i <= grid_.reach; ++i) {
    for (int j = -grid_.reach; j <= grid_.reach; ++j) {
      const std::size_t line = convolution_.place(stencil.middle[0] + i, stencil.middle[1] + j, stencil.middle[2]);
      for (int k = -grid_.reach; k <= grid_.reach; ++k) {
        sum += potentials[line + k] * stencil.weights[number++];
      }
    }
  }
  return sum;
}

void CompressedSystem::multiply(const Eigen::Ref<const Eigen::VectorXcd>& pressure,
                                Eigen::Ref<Eigen::VectorXcd> result) {
  const std::span<Complex> field = convolution_.charges();
  for (std::size_t b = 0; b < dipoles_.size(); ++b) {
    scatter(dipoles_[b], pressure[static_cast<Eigen::Index>(b)], field);
  }
  convolution_.transform();
  result = matrix_ * pressure;
  for (const Receiver& receiver : receivers_) {
    for (std::size_t a = 0; a < receiver.tests.size(); ++a) {
      result[static_cast<Eigen::Index>(a)] += receiver.gain * gather(receiver.tests[a], field);
    }
  }
}

void CompressedSystem::precondition(const Eigen::Ref<const Eigen::VectorXcd>& residual,
                                    Eigen::Ref<Eigen::VectorXcd> result) const {
  result = factors_.solve(residual);
}

}  // namespace idiophone::harmonic
