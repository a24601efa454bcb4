#include "idiophone/study/bench/tap_place.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/foundation/bounding_box.hpp"

namespace idiophone::bench {

namespace {

Eigen::Map<const Eigen::Matrix3Xd> motions_of(const eigenmodes::Mode& mode) {
  return {mode.shape.data(), 3, static_cast<Eigen::Index>(mode.shape.size() / 3)};
}

/// [nodes] as tapped_share()
Eigen::ArrayXd shares_of(const eigenmodes::Mode& mode, const Side& side) {
  const auto motions = motions_of(mode);
  return motions.row(side.facing).cwiseAbs().array() / motions.colwise().norm().maxCoeff();
}

}  // namespace

double tapped_share(const Workpiece::Solved& body, const Side& side, std::size_t mode, Index node) {
  return shares_of(body.modes[mode], side)[node];
}

Index tapped_node(const mesh::Mesh& mesh, const Vector3& place) {
  const Eigen::AlignedBox3d box = bounding_box(mesh.nodes);
  const double away = box.exteriorDistance(place);
  if (away > 0.01 * box.diagonal().norm()) {
    throw std::runtime_error(
        fmt::format("a tap at {:g},{:g},{:g} m is {:.3g} m away from the body", place.x(), place.y(), place.z(), away));
  }
  const auto nearest =
      std::ranges::min_element(mesh.nodes, {}, [&](const Vector3& node) { return (node - place).squaredNorm(); });
  return static_cast<Index>(nearest - mesh.nodes.begin());
}

std::optional<Vector3> deciding_place(const Workpiece::Solved& body, const Side& side, std::size_t mode,
                                      std::optional<std::size_t> other) {
  constexpr double least_share = 0.2;
  const Eigen::ArrayXd shares = shares_of(body.modes[mode], side);
  const Eigen::ArrayXd others =
      other ? shares_of(body.modes[*other], side) : Eigen::ArrayXd(Eigen::ArrayXd::Zero(shares.size()));
  std::optional<Index> best;
  for (const mesh::Triangle& triangle : body.mesh.outer_surface()) {
    for (const Index node : triangle) {
      constexpr double more = 1e-6;  // of equal motions by symmetry, the first, whatever the solver's rounding
      const bool is_better = shares[node] > (best ? (1 + more) * shares[*best] : least_share);
      if (others[node] < silent_share / 2 && is_better) {
        best = node;
      }
    }
  }
  return best ? std::optional<Vector3>(body.mesh.nodes[*best]) : std::nullopt;
}

}  // namespace idiophone::bench
