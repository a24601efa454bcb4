#include "convolution_grid.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "idiophone/foundation/bounding_box.hpp"

namespace idiophone::harmonic {

namespace {

/// Lagrange's polynomials of the nodes -reach to reach, and their derivatives.
struct LinePolynomials {
  std::vector<double> value, slope;
};

LinePolynomials polynomials_at(int reach, double x) {
  LinePolynomials all;
  for (int node = -reach; node <= reach; ++node) {
    double value = 1.0, slope = 0.0;
    for (int other = -reach; other <= reach; ++other) {
      if (other != node) {
        slope = (slope * (x - other) + value) / (node - other);
        value *= (x - other) / (node - other);
      }
    }
    all.value.push_back(value);
    all.slope.push_back(slope);
  }
  return all;
}

/// The smallest number not below this one without prime factors above 5: fast to transform.
std::size_t fast_size(std::size_t least) {
  for (std::size_t size = least;; ++size) {
    std::size_t rest = size;
    for (const std::size_t prime : {2UL, 3UL, 5UL}) {
      while (rest % prime == 0) {
        rest /= prime;
      }
    }
    if (rest == 1) {
      return size;
    }
  }
}

}  // namespace

std::array<int, 3> Grid::nearest(const Vector3& point) const {
  std::array<int, 3> node{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    node.at(axis) = static_cast<int>(std::lround((point[axis] - origin[axis]) / spacing));
  }
  return node;
}

Grid grid_about(std::span<const Vector3> points, double longest_edge, double wave_number) {
  constexpr double nodes_in_wave_length = 8.0;
  Grid grid;
  const double wave_length = 2.0 * std::numbers::pi / wave_number;
  grid.spacing = std::clamp(wave_length / nodes_in_wave_length, longest_edge / 2.5, longest_edge / 1.5);
  grid.reach = static_cast<int>(std::ceil(longest_edge / grid.spacing + 0.5 - 1e-9));
  const Eigen::AlignedBox3d box = bounding_box(points);
  grid.origin = box.min() - Vector3::Constant((grid.reach + 1) * grid.spacing);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grid.nodes.at(axis) = static_cast<int>(std::ceil(box.sizes()[axis] / grid.spacing)) + 2 * grid.reach + 3;
  }
  return grid;
}

Interpolation interpolate(const Grid& grid, const std::array<int, 3>& middle, const Vector3& point,
                          const Vector3& direction) {
  std::array<LinePolynomials, 3> lines;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lines.at(axis) = polynomials_at(grid.reach, (point[axis] - grid.origin[axis]) / grid.spacing - middle.at(axis));
  }
  const auto& [x, y, z] = lines;
  const Vector3 per_node = direction / grid.spacing;
  Interpolation result{Eigen::VectorXd(grid.stencil_size()), Eigen::VectorXd(grid.stencil_size())};
  Eigen::Index number = 0;
  for (int i = 0; i < grid.width(); ++i) {
    for (int j = 0; j < grid.width(); ++j) {
      for (int k = 0; k < grid.width(); ++k) {
        result.value[number] = x.value[i] * y.value[j] * z.value[k];
        result.slope[number++] = per_node[0] * x.slope[i] * y.value[j] * z.value[k] +
                                 per_node[1] * x.value[i] * y.slope[j] * z.value[k] +
                                 per_node[2] * x.value[i] * y.value[j] * z.slope[k];
      }
    }
  }
  return result;
}

std::complex<double> grid_green(const Grid& grid, double wave_number, int i, int j, int k) {
  const double r =
      grid.spacing * std::sqrt(static_cast<double>(i) * i + static_cast<double>(j) * j + static_cast<double>(k) * k);
  return r > 0 ? std::polar(1.0 / (4.0 * std::numbers::pi * r), -wave_number * r) : 0.0;
}

GridConvolution::GridConvolution(const Grid& grid, double wave_number) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    size_.at(axis) = fast_size(2UL * grid.nodes.at(axis) - 1);
  }
  const std::size_t count = size_[0] * size_[1] * size_[2];
  constexpr std::size_t most = 1UL << 28U;
  if (count > most) {
    throw std::runtime_error(fmt::format(
        "boundary elements: the surface needs a grid of {} nodes, above {}: choose a coarser mesh, or put bodies and "
        "obstacles nearer together",
        count, most));
  }
  values_.resize(count);
  auto* data = reinterpret_cast<fftw_complex*>(values_.data());  // NOLINT(*-reinterpret-cast): the same layout
  const auto plan = [&](int sign) {
    return Plan(fftw_plan_dft_3d(static_cast<int>(size_[0]), static_cast<int>(size_[1]), static_cast<int>(size_[2]),
                                 data, data, sign, FFTW_ESTIMATE));
  };
  forward_ = plan(FFTW_FORWARD);
  backward_ = plan(FFTW_BACKWARD);
  const auto offset = [&](std::size_t axis, std::size_t index) {
    return static_cast<int>(index) - (index > size_.at(axis) / 2 ? static_cast<int>(size_.at(axis)) : 0);
  };
  for (std::size_t i = 0; i < size_[0]; ++i) {
    for (std::size_t j = 0; j < size_[1]; ++j) {
      for (std::size_t k = 0; k < size_[2]; ++k) {
        values_[(i * size_[1] + j) * size_[2] + k] =
            grid_green(grid, wave_number, offset(0, i), offset(1, j), offset(2, k)) / static_cast<double>(count);
      }
    }
  }
  fftw_execute(forward_.get());
  spectrum_ = values_;
}

std::span<std::complex<double>> GridConvolution::charges() {
  std::ranges::fill(values_, 0.0);
  return values_;
}

void GridConvolution::transform() {
  fftw_execute(forward_.get());
  for (std::size_t i = 0; i < values_.size(); ++i) {
    values_[i] *= spectrum_[i];
  }
  fftw_execute(backward_.get());
}

}  // namespace idiophone::harmonic
