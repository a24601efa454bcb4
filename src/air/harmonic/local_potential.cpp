#include "local_potential.hpp"

#include <algorithm>
#include <cstdlib>

namespace idiophone::harmonic {

void LocalPotential::tabulate(int half_width) {
  half_width_ = half_width;
  green_ = {};
  for (int i = -half_width; i <= half_width; ++i) {
    for (int j = -half_width; j <= half_width; ++j) {
      for (int k = -half_width; k <= half_width; ++k) {
        const std::complex<double> value = grid_green(grid_, wave_number_, i, j, k);
        green_.real.push_back(value.real());
        green_.imaginary.push_back(value.imag());
      }
    }
  }
}

void LocalPotential::compute(const std::array<int, 3>& middle, const Eigen::VectorXcd& charges,
                             const std::vector<const std::array<int, 3>*>& others) {
  const int reach = grid_.reach;
  int farthest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    int low = others.front()->at(axis), high = low;
    for (const auto* other : others) {
      low = std::min(low, other->at(axis));
      high = std::max(high, other->at(axis));
    }
    first_.at(axis) = low - reach;
    count_.at(axis) = high - low + 2 * reach + 1;
    farthest = std::max({farthest, std::abs(low - middle.at(axis)), std::abs(high - middle.at(axis))});
  }
  if (farthest + 2 * reach > half_width_) {
    tabulate(farthest + 2 * reach);
  }
  const auto nodes = static_cast<std::size_t>(count_[0]) * count_[1] * count_[2];
  potential_.real.assign(nodes, 0.0);
  potential_.imaginary.assign(nodes, 0.0);
  const int side = 2 * half_width_ + 1;
  Eigen::Index number = 0;
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j <= reach; ++j) {
      for (int k = -reach; k <= reach; ++k) {
        const double real = charges[number].real(), imaginary = charges[number].imag();
        ++number;
        for (int x = 0; x < count_[0]; ++x) {
          const int dx = first_[0] + x - middle[0] - i + half_width_;
          for (int y = 0; y < count_[1]; ++y) {
            const int dy = first_[1] + y - middle[1] - j + half_width_;
            const int dz = first_[2] - middle[2] - k + half_width_;
            const std::size_t from = (static_cast<std::size_t>(dx) * side + dy) * side + dz;
            const std::size_t to = (static_cast<std::size_t>(x) * count_[1] + y) * count_[2];
            for (int z = 0; z < count_[2]; ++z) {
              const double g = green_.real[from + z], h = green_.imaginary[from + z];
              potential_.real[to + z] += real * g - imaginary * h;
              potential_.imaginary[to + z] += real * h + imaginary * g;
            }
          }
        }
      }
    }
  }
}

std::complex<double> LocalPotential::gather(const std::array<int, 3>& middle, const Eigen::VectorXcd& weights) const {
  std::complex<double> sum = 0.0;
  Eigen::Index number = 0;
  for (int i = -grid_.reach; i <= grid_.reach; ++i) {
    for (int j = -grid_.reach; j <= grid_.reach; ++j) {
      const std::size_t line = place({middle[0] + i, middle[1] + j, middle[2] - grid_.reach});
      for (int k = 0; k < grid_.width(); ++k) {
        sum += weights[number++] * std::complex(potential_.real[line + k], potential_.imaginary[line + k]);
      }
    }
  }
  return sum;
}

}  // namespace idiophone::harmonic
