#include "idiophone/run/bodies/gauge_channels.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <utility>

#include "idiophone/foundation/parallel/reproducible_sum.hpp"
#include "idiophone/run/bodies/observation.hpp"

namespace idiophone::bodies {

namespace {

using Quantity = scene::Gauge::Quantity;

spectra::Series gauge_channel(const scene::Gauge& gauge) {
  const std::string path = "/gauges/" + gauge.name + "/";
  switch (gauge.quantity) {
    case Quantity::distance:
      return {path + "distance", "m", 0.0, {"distance"}, "distance of two points", {}};
    case Quantity::strain:
      return {path + "strain", "1", 0.0, {"strain"}, "relative change of the distance of two points", {}};
    case Quantity::angle:
      return {path + "angle", "rad", 0.0, {"angle"}, "angle at the second of three points", {}};
    case Quantity::curvature:
      break;
  }
  return {path + "curvature",
          "1/m",
          0.0,
          {"x", "y", "z"},
          "curvature of the circle through three points, towards its centre",
          {}};
}

std::vector<spectra::Series> gauge_series(const scene::Scene& scene) {
  std::vector<spectra::Series> all;
  for (const scene::Gauge& gauge : scene.gauges) {
    all.push_back(gauge_channel(gauge));
  }
  return all;
}

Vector3 curvature(const Vector3& u, const Vector3& v) {
  const double product = u.squaredNorm() * v.squaredNorm() * (u - v).squaredNorm();
  if (product == 0.0) {
    return Vector3::Zero();
  }
  return 2.0 / product * (u.squaredNorm() * v - v.squaredNorm() * u).cross(u.cross(v));
}

}  // namespace

std::vector<double> measured(Quantity quantity, std::span<const Vector3> points, std::span<const Vector3> reference) {
  const Vector3 u = points[0] - points[1];
  switch (quantity) {
    case Quantity::distance:
      return {u.norm()};
    case Quantity::strain:
      return {u.norm() / (reference[0] - reference[1]).norm() - 1.0};
    case Quantity::angle: {
      const Vector3 v = points[2] - points[1];
      return {std::atan2(u.cross(v).norm(), u.dot(v))};
    }
    case Quantity::curvature:
      break;
  }
  const Vector3 bent = curvature(u, points[2] - points[1]);
  return {bent.begin(), bent.end()};
}

GaugeChannels::GaugeChannels(const Preparation& ready, motion::Motion& motion, MPI_Comm communicator)
    : MotionRateChannels(ready.scene, gauge_series(ready.scene)),
      motion_(motion),
      reference_(ready.part.reference),
      communicator_(communicator) {
  for (std::size_t g = 0; g < channels().size(); ++g) {
    Points& gauge = gauges_.emplace_back(Points{ready.scene.gauges[g].quantity, {}, {}});
    for (const mesh::Patch& patch : ready.attachments.gauges[g]) {
      gauge.patches.push_back(motion::owned(patch, ready.part));
    }
  }
  note_places([&](Index node) -> Vector3 { return reference_[node]; });
  std::size_t gauge = 0;
  take_places([&](std::vector<Vector3> places) { gauges_[gauge++].undeformed = std::move(places); });
}

/// Notes the mean of place(node) over each patch.
template <class Place>
void GaugeChannels::note_places(const Place& place) {
  for (const Points& gauge : gauges_) {
    for (const mesh::Patch& patch : gauge.patches) {
      std::array<ReproducibleSum, 3> sums;
      for (std::size_t n = 0; n < patch.nodes.size(); ++n) {
        const Vector3 term = patch.shares[n] * place(patch.nodes[n]);
        for (int i = 0; i < 3; ++i) {
          sums[i].add(term[i]);
        }
      }
      for (const ReproducibleSum& sum : sums) {
        append(words_, sum);
      }
    }
  }
}

/// take(places) of each gauge in each row, on rank 0. Collective.
template <class Take>
void GaugeChannels::take_places(const Take& take) {
  const std::vector<std::int64_t> sums = sum_over_ranks(words_, communicator_);
  words_.clear();
  for (std::span<const std::int64_t> words = sums; !words.empty();) {
    for (const Points& gauge : gauges_) {
      std::vector<Vector3> places(gauge.patches.size());
      for (Vector3& place : places) {
        for (double& component : place) {
          component = take_sum(words).value();
        }
      }
      take(std::move(places));
    }
  }
}

void GaugeChannels::note_row() {
  motion_.update_nodes();
  note_places([&](Index node) -> Vector3 { return reference_[node] + Vector3(motion_.state()[node].displacement); });
}

std::vector<std::vector<double>> GaugeChannels::collect() {
  std::vector<std::vector<double>> series(gauges_.size());
  std::size_t next = 0;
  take_places([&](const std::vector<Vector3>& places) {
    const std::size_t g = next++ % gauges_.size();
    const std::vector<double> row = measured(gauges_[g].quantity, places, gauges_[g].undeformed);
    series[g].insert(series[g].end(), row.begin(), row.end());
  });
  return series;
}

}  // namespace idiophone::bodies
