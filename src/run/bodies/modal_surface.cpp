#include "modal_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "idiophone/air/surface/corners.hpp"
#include "idiophone/foundation/cross_matrix.hpp"
#include "idiophone/foundation/lanes.hpp"

namespace idiophone::bodies {

namespace {

// Coordinates: displacement of the centre of mass, rotation less the identity column by column, modes. Rates: velocity
// of the centre of mass and angular velocity in the body's own frame, modes.
constexpr Eigen::Index rigid_coordinates = 12;
constexpr Eigen::Index rigid_rates = 6;

Eigen::Map<const Vector3> shift(const Eigen::VectorXd& coordinates) {
  return Eigen::Map<const Vector3>(coordinates.data());
}

Eigen::Map<const Eigen::Matrix3d> turn_less_one(const Eigen::VectorXd& coordinates) {
  return Eigen::Map<const Eigen::Matrix3d>(coordinates.data() + 3);
}

Eigen::Map<const Eigen::VectorXd> as_vector(std::span<const double> values) {
  return {values.data(), std::ssize(values)};
}

Eigen::VectorXd coordinates_of(const motion::ModalState& state) {
  Eigen::VectorXd coordinates(rigid_coordinates + std::ssize(state.places));
  coordinates.head<3>() = state.shift;
  Eigen::Map<Eigen::Matrix3d>(coordinates.data() + 3) = state.turn_less_one;
  coordinates.tail(std::ssize(state.places)) = as_vector(state.places);
  return coordinates;
}

Eigen::VectorXd rates_of(const Vector3& velocity, const Vector3& spin, const Eigen::VectorXd& of_modes) {
  Eigen::VectorXd rates(rigid_rates + of_modes.size());
  rates.head<3>() = velocity;
  rates.segment<3>(3) = spin;
  rates.tail(of_modes.size()) = of_modes;
  return rates;
}

/// Rates times the time between the coordinates.
Eigen::VectorXd change(const Eigen::VectorXd& before, const Eigen::VectorXd& now) {
  const Eigen::Matrix3d mean = Eigen::Matrix3d::Identity() + (turn_less_one(before) + turn_less_one(now)) / 2;
  // The rotation between the two, less the identity, without rounding of small rotations.
  const Eigen::Matrix3d turn =
      turn_less_one(now) + turn_less_one(before).transpose() + turn_less_one(before).transpose() * turn_less_one(now);
  const Eigen::Matrix3d twice = turn - turn.transpose();
  const Eigen::Index modes = now.size() - rigid_coordinates;
  const Vector3 moved = shift(now) - shift(before);
  const Vector3 turned(twice(2, 1) / 2, twice(0, 2) / 2, twice(1, 0) / 2);
  return rates_of(mean.transpose() * moved, turned, now.tail(modes) - before.tail(modes));
}

/// Adds the reads of an audio sample, and takes the filtered values.
/// @param reads  [reads x width]
Eigen::VectorXd filtered(surface::LowPass& filter, const std::vector<double>& reads, std::size_t width,
                         std::size_t count) {
  std::vector<const double*> places(reads.size() / width);
  for (std::size_t pack = 0; pack < width / pack_size; ++pack) {
    for (std::size_t read = 0; read < places.size(); ++read) {
      places[read] = &reads[read * width + pack * pack_size];
    }
    filter.add(pack, places, 0);
  }
  std::vector<double> values(width);
  filter.take(values);
  return as_vector(std::span(values).first(count));
}

}  // namespace

ModalSurface::ModalSurface(const modal_bodies::ModalBasis& basis, const Shape& shape, const surface::Sampling& sampling)
    : read_rate_(static_cast<double>(sampling.rate) * sampling.reads_per_sample()),
      corners_(surface::corner_places(shape.triangles)),
      velocities_(3 * shape.nodes.size() + 1),
      pressures_(padded(shape.triangles.size())),
      before_(rigid_coordinates + static_cast<Eigen::Index>(basis.modes())),
      coordinates_(padded(before_.size()) * sampling.reads_per_sample()),
      rates_(coordinates_.size()),
      coordinate_filter_(sampling, surface::ReadTime::end, padded(before_.size())),
      rate_filter_(sampling, surface::ReadTime::middle, padded(before_.size())) {
  const std::size_t vertices = shape.nodes.size();
  const auto modes = static_cast<Eigen::Index>(basis.modes());
  if (basis.stretching.exists()) {
    rotation_ = as_vector(basis.stretching.rotation).reshaped(modes, modes);
  }
  reference_.resize(3, static_cast<Eigen::Index>(vertices));
  Eigen::MatrixXd shapes(static_cast<Eigen::Index>(3 * vertices), modes);
  for (std::size_t v = 0; v < vertices; ++v) {
    reference_.col(static_cast<Eigen::Index>(v)) = shape.positions[v];
    for (Eigen::Index mode = 0; mode < modes; ++mode) {
      shapes.col(mode).segment<3>(static_cast<Eigen::Index>(3 * v)) =
          Eigen::Map<const Vector3>(&basis.shapes[3 * (mode * basis.nodes() + shape.nodes[v])]);
    }
  }
  vibration_ = VertexShapes(shapes);
  arms_ = reference_.colwise() - shape.centre;
  normals_.fill(pressures_);
  for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
    const auto [i, j, k] = shape.triangles[t];
    const Vector3 normal = (arms_.col(j) - arms_.col(i)).cross(arms_.col(k) - arms_.col(i)).normalized();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      normals_.at(axis)[t] = sampling.impedance / 3 * normal[static_cast<Eigen::Index>(axis)];
    }
  }
}

std::size_t ModalSurface::coordinates(const modal_bodies::ModalBasis& basis) {
  return rigid_coordinates + basis.modes();
}

void ModalSurface::start(const motion::ModalState& state, std::span<double> pressure, std::span<double> position) {
  before_ = coordinates_of(state);
  const Eigen::Matrix3d back = Eigen::Matrix3d::Identity() + state.turn_less_one.transpose();
  const Eigen::VectorXd rates = rates_of(back * state.velocity, back * state.spin, as_vector(state.rates));
  const auto fill = [](surface::LowPass& filter, const Eigen::VectorXd& values) {
    std::vector<double> all(padded(values.size()));
    std::ranges::copy(values, all.begin());
    filter.fill(all);
  };
  fill(coordinate_filter_, before_);
  fill(rate_filter_, rates);
  reads_ = 0;
  find(rates, before_, pressure, position);
}

void ModalSurface::read(const motion::ModalState& state) {
  const Eigen::VectorXd now = coordinates_of(state);
  const Eigen::VectorXd rates = read_rate_ * change(before_, now);
  const auto first = static_cast<std::ptrdiff_t>(reads_ * padded(now.size()));
  std::ranges::copy(now, coordinates_.begin() + first);
  std::ranges::copy(rates, rates_.begin() + first);
  before_ = now;
  ++reads_;
}

void ModalSurface::take(std::span<double> pressure, std::span<double> position) {
  const std::size_t width = padded(before_.size());
  reads_ = 0;
  const Eigen::VectorXd rates = filtered(rate_filter_, rates_, width, before_.size() - rigid_coordinates + rigid_rates);
  find(rates, filtered(coordinate_filter_, coordinates_, width, before_.size()), pressure, position);
}

void ModalSurface::find(const Eigen::VectorXd& rates, const Eigen::VectorXd& coordinates, std::span<double> pressure,
                        std::span<double> position) {
  vibration_.find(coordinates.tail(coordinates.size() - rigid_coordinates), rates.tail(rates.size() - rigid_rates));
  find_pressures(rates, pressure);
  find_positions(coordinates, position);
}

void ModalSurface::find_pressures(const Eigen::VectorXd& rates, std::span<double> pressure) {
  const Vector3 velocity = rates.head<3>();
  const Eigen::Matrix3d spin = cross_matrix(rates.segment<3>(3));
  Eigen::Map<Eigen::Matrix3Xd>(velocities_.data(), 3, arms_.cols()) =
      (vibration_.velocities().cast<double>() + spin.lazyProduct(arms_)).colwise() + velocity;
  for (std::size_t first = 0; first < pressures_.size(); first += lane_count) {
    const VectorLanes normal = {load(&normals_[0][first]), load(&normals_[1][first]), load(&normals_[2][first])};
    put(surface::dot(normal, surface::gather(&corners_[3 * first], velocities_.data()).sum), &pressures_[first]);
  }
  std::copy_n(pressures_.begin(), pressure.size(), pressure.begin());
}

void ModalSurface::find_positions(const Eigen::VectorXd& coordinates, std::span<double> position) {
  const Eigen::Matrix3d turn = turn_less_one(coordinates);
  const Vector3 shifted = shift(coordinates);
  const VertexShapes::Field displacements = vibration_.displacements();
  Eigen::Map<Eigen::Matrix3Xd> positions(position.data(), 3, arms_.cols());
  double largest_square = largest_square_;  // in a register
  for (Eigen::Index v = 0; v < arms_.cols(); ++v) {
    const Vector3 moved = displacements.col(v).cast<double>();
    largest_square = std::max(largest_square, moved.squaredNorm());
    positions.col(v) = reference_.col(v) + moved + shifted + turn * (arms_.col(v) + moved);
  }
  largest_square_ = largest_square;
  if (rotation_.size() > 0) {
    const Eigen::VectorXd places = coordinates.tail(rotation_.cols());
    largest_rotation_square_ = std::max(largest_rotation_square_, places.dot(rotation_ * places));
  }
}

void ModalSurface::archive(std::size_t coordinate, parallel::ArchiveRow& row) {
  row.value(before_[static_cast<Eigen::Index>(coordinate)]);
  coordinate_filter_.archive(coordinate, row);
  rate_filter_.archive(coordinate, row);
}

}  // namespace idiophone::bodies
