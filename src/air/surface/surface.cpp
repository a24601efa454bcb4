#include "idiophone/air/surface/surface.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "idiophone/air/surface/corners.hpp"

namespace idiophone::surface {

namespace {

const Sampling& validated(const Sampling& sampling) {
  sampling.validate();
  return sampling;
}

void check(const std::vector<std::array<Index, 3>>& triangles, const std::vector<Vector3>& reference) {
  for (std::size_t vertex = 0; vertex < reference.size(); ++vertex) {
    if (!reference[vertex].allFinite()) {
      throw std::invalid_argument(fmt::format("surface: the position of vertex {} is not finite", vertex));
    }
  }
  for (std::size_t number = 0; number < triangles.size(); ++number) {
    for (const Index vertex : triangles[number]) {
      if (vertex < 0 || static_cast<std::size_t>(vertex) >= reference.size()) {
        throw std::invalid_argument(
            fmt::format("surface: triangle {} has vertex {}; there are {}", number, vertex, reference.size()));
      }
    }
    const auto [a, b, c] = triangles[number];
    const Vector3 twice_area = (reference[b] - reference[a]).cross(reference[c] - reference[a]);
    if (!(twice_area.norm() > 0.0)) {
      throw std::invalid_argument(
          fmt::format("surface: triangle {} (vertices {}, {}, {}) has no area; repair the mesh", number, a, b, c));
    }
  }
}

}  // namespace

Surface::Surface(const std::vector<std::array<Index, 3>>& triangles, const std::vector<Vector3>& reference,
                 const Sampling& sampling)
    : sampling_(validated(sampling)),
      triangles_(triangles.size()),
      vertices_(reference.size()),
      corners_(corner_places(triangles)),
      edges_(6 * padded(triangles_) / lane_count, Lanes4{}),
      shares_(padded(triangles_), 1.0),
      reference_(SurfaceMotion::position_length(vertices_)),
      pressure_(sampling, ReadTime::middle, padded(triangles_)),
      displacement_(sampling, ReadTime::end, SurfaceMotion::position_length(vertices_)) {
  check(triangles, reference);
  slots_.fill(std::vector<double>(SurfaceMotion::position_length(vertices_)));
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    Vector3::Map(&reference_[3 * vertex]) = reference[vertex];
  }
  for (std::size_t number = 0; number < triangles_; ++number) {
    const std::size_t four = number / lane_count;
    const std::size_t lane = number % lane_count;
    const auto& corners = triangles[number];
    for (int axis = 0; axis < 3; ++axis) {
      edges_[6 * four + axis][lane] = reference[corners[1]][axis] - reference[corners[0]][axis];
      edges_[6 * four + 3 + axis][lane] = reference[corners[2]][axis] - reference[corners[0]][axis];
    }
  }
}

SurfaceMotion Surface::start(std::span<const double> velocities) {
  std::swap(slots_[0], slots_[reads_ + 1]);
  displacement_.fill(slots_[0]);
  reads_ = 1;
  const double read_rate = static_cast<double>(sampling_.rate) * sampling_.reads_per_sample();
  slots_[1] = slots_[0];
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    slots_[1][i] += velocities[i] / read_rate;
  }
  SurfaceMotion steady{std::vector<double>(padded(triangles_)), slots_[0]};
  std::ranges::transform(steady.position, reference_, steady.position.begin(), std::plus());
  std::array<AlignedBlock, reads_at_once> pressures;
  for (std::size_t pack = 0; pack < padded(triangles_) / pack_size; ++pack) {
    for (std::size_t lane = 0; lane < pack_size; lane += lane_count) {
      find_pressures(pack * pack_size + lane, pressures);
    }
    std::ranges::copy(pressures[0].values, &steady.pressure[pack * pack_size]);
  }
  pressure_.fill(steady.pressure);
  reads_ = 0;
  reads_filtered_ = 0;
  return steady;
}

void Surface::read() {
  if (reads_filtered_ == sampling_.reads_per_sample()) {
    throw std::logic_error("Surface::read: the audio sample is complete; take it first");
  }
  ++reads_;
  if (reads_ == reads_at_once || reads_filtered_ + static_cast<int>(reads_) == sampling_.reads_per_sample()) {
    filter_reads();
  }
}

void Surface::filter_reads() {
  filter_displacements();
  filter_pressures();
  std::swap(slots_.front(), slots_[reads_]);
  reads_filtered_ += static_cast<int>(reads_);
  reads_ = 0;
}

void Surface::filter_displacements() {
  std::array<const double*, reads_at_once> reads;
  for (std::size_t pack = 0; pack < SurfaceMotion::position_length(vertices_) / pack_size; ++pack) {
    for (std::size_t read = 0; read < reads_at_once; ++read) {
      reads[read] = &slots_[read + 1][pack * pack_size];
    }
    displacement_.add(pack, std::span(reads).first(reads_), reads_filtered_);
  }
}

void Surface::filter_pressures() {
  std::array<AlignedBlock, reads_at_once> pressures;
  std::array<const double*, reads_at_once> reads;
  std::ranges::transform(pressures, reads.begin(), [](const AlignedBlock& pack) { return pack.values.data(); });
  for (std::size_t pack = 0; pack < padded(triangles_) / pack_size; ++pack) {
    for (std::size_t lane = 0; lane < pack_size; lane += lane_count) {
      find_pressures(pack * pack_size + lane, pressures);
    }
    pressure_.add(pack, std::span(reads).first(reads_), reads_filtered_);
  }
}

void Surface::find_pressures(std::size_t first, std::array<AlignedBlock, reads_at_once>& pressures) const {
  const double read_rate = static_cast<double>(sampling_.rate) * sampling_.reads_per_sample();
  const double scale = sampling_.impedance * read_rate / 3.0;
  const Index* places = &corners_[3 * first];
  const Lanes4* reference = &edges_[6 * first / lane_count];
  const Lanes4 share = load(&shares_[first]);
  Corners begin = gather(places, slots_[0].data());
  for (std::size_t read = 0; read < reads_; ++read) {
    const Corners end = gather(places, slots_[read + 1].data());
    VectorLanes moved, edge12, edge13;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      moved[axis] = end.sum[axis] - begin.sum[axis];
      edge12[axis] = reference[axis] + 0.5 * (begin.edge12[axis] + end.edge12[axis]);
      edge13[axis] = reference[3 + axis] + 0.5 * (begin.edge13[axis] + end.edge13[axis]);
    }
    const VectorLanes normal = cross(edge12, edge13);
    put(share * (scale * dot(moved, normal) / divisible_length(normal)), &pressures[read].values[first % pack_size]);
    begin = end;
  }
}

void Surface::take(SurfaceMotion& motion) {
  if (reads_filtered_ != sampling_.reads_per_sample()) {
    throw std::logic_error(fmt::format("Surface::take: {} of {} reads of this audio sample were given",
                                       reads_filtered_ + static_cast<int>(reads_), sampling_.reads_per_sample()));
  }
  reads_filtered_ = 0;
  motion.pressure.resize(padded(triangles_));
  motion.position.resize(SurfaceMotion::position_length(vertices_));
  pressure_.take(motion.pressure);
  displacement_.take(motion.position);
  std::ranges::transform(motion.position, reference_, motion.position.begin(), std::plus());
}

}  // namespace idiophone::surface
