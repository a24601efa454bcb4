#include "idiophone/instruments/proxies/lattice.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "equilibrium.hpp"
#include "frequency_bound.hpp"
#include "masses.hpp"

namespace idiophone::proxies {

namespace {

constexpr double decay_of_60_db = 6.907755278982137;  // ln 1000

/// Adds springs between the same masses, which are in order.
std::vector<Spring> merged(const std::vector<Spring>& springs) {
  std::vector<Spring> merged;
  for (const Spring& spring : springs) {
    if (merged.empty() || merged.back().a != spring.a || merged.back().b != spring.b) {
      merged.push_back(spring);
      continue;
    }
    Spring& sum = merged.back();
    const double stiffness = sum.stiffness + spring.stiffness;
    sum.damping = (sum.stiffness * sum.damping + spring.stiffness * spring.damping) / stiffness;
    sum.natural = (sum.stiffness * sum.natural + spring.stiffness * spring.natural) / stiffness;
    sum.stiffness = stiffness;
    sum.section += spring.section;
  }
  return merged;
}

bool all_at_least(std::span<const double> values, double limit, bool is_limit_allowed) {
  return std::ranges::all_of(values, [&](double value) {
    return std::isfinite(value) && (value > limit || (is_limit_allowed && value == limit));
  });
}

/// Distance along a ray at which it goes through a triangle; negative if it does not (Moller and Trumbore, J. Graphics
/// Tools 2(1), 1997).
double distance_to_triangle(const Vector3& origin, const Vector3& direction, const std::array<Vector3, 3>& corners) {
  constexpr double margin = 1e-9;  // so that no ray slips between two triangles
  const Vector3 side1 = corners[1] - corners[0], side2 = corners[2] - corners[0];
  const Vector3 p = direction.cross(side2);
  const double determinant = side1.dot(p);
  if (determinant == 0.0) {
    return -1.0;
  }
  const Vector3 offset = origin - corners[0];
  const double u = offset.dot(p) / determinant;
  const Vector3 q = offset.cross(side1);
  const double v = direction.dot(q) / determinant;
  return u < -margin || v < -margin || u + v > 1.0 + margin ? -1.0 : side2.dot(q) / determinant;
}

/// Shares inversely to the distances from a point.
Contact shared_by_distance(const TetrahedralMesh& mesh, const std::array<Index, 3>& triangle, const Vector3& point) {
  constexpr double least_distance = 1e-300;  // m; a mass that is nearer takes all
  Contact contact{.masses = triangle, .shares = {}};
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double distance = (mesh.nodes[triangle[i]] - point).norm();
    contact.shares[i] = 1.0 / std::max(distance, least_distance);
    sum += contact.shares[i];
  }
  for (double& share : contact.shares) {
    share /= sum;
  }
  return contact;
}

std::array<Vector3, 3> corners_of(const TetrahedralMesh& mesh, const std::array<Index, 3>& triangle) {
  return {mesh.nodes[triangle[0]], mesh.nodes[triangle[1]], mesh.nodes[triangle[2]]};
}

}  // namespace

Damping damping_for(const std::array<double, 2>& frequency, const std::array<double, 2>& t60) {
  std::array<double, 2> square{}, loss{};  // twice the decay rate is mass + stiffness w^2
  for (std::size_t i = 0; i < 2; ++i) {
    square[i] = std::pow(2.0 * std::numbers::pi * frequency[i], 2);
    loss[i] = 2.0 * decay_of_60_db / t60[i];
  }
  const double stiffness = (loss[1] - loss[0]) / (square[1] - square[0]);
  const Damping damping{.mass = loss[0] - stiffness * square[0], .stiffness = stiffness};
  if (!(damping.mass >= 0.0) || !(damping.stiffness >= 0.0)) {
    throw std::invalid_argument(
        "no damping gives these decay times: the higher frequency must decay faster, but by no more than the square "
        "of the ratio of the frequencies");
  }
  return damping;
}

void Lattice::check() const {
  if (!(material_.young > 0.0) || !(material_.density > 0.0) || !(material_.damping.mass >= 0.0) ||
      !(material_.damping.stiffness >= 0.0)) {
    throw std::invalid_argument("Young's modulus and density must be above 0, damping must not be negative");
  }
  const auto fits = [](const auto& values, std::size_t count) { return values.empty() || values.size() == count; };
  if (!fits(own_.stiffness, mesh_.tetrahedra.size()) || !fits(own_.edges, mesh_.tetrahedra.size()) ||
      !fits(own_.damping, mesh_.tetrahedra.size()) || !fits(own_.length, mesh_.tetrahedra.size()) ||
      !fits(own_.masses, mesh_.nodes.size())) {
    throw std::invalid_argument("own values are given for all tetrahedra or nodes, or for none");
  }
  if (!all_at_least(own_.stiffness, 0.0, false) || !all_at_least(own_.damping, 0.0, true) ||
      !all_at_least(own_.length, 0.0, false) || !all_at_least(own_.masses, 0.0, false)) {
    throw std::invalid_argument("own stiffness, lengths and masses must be above 0, own damping must not be negative");
  }
  for (const EdgeFactors& edges : own_.edges) {
    if (!all_at_least(edges, 0.0, false)) {
      throw std::invalid_argument("the factors of edges must be above 0");
    }
  }
  for (const OwnSpring& spring : own_.springs) {
    if (!all_at_least(std::array{spring.stiffness, spring.length}, 0.0, false) ||
        !all_at_least(std::array{spring.damping}, 0.0, true)) {
      throw std::invalid_argument("a spring's own stiffness and length must be above 0, its damping not negative");
    }
  }
  if (!is_free_ && std::ranges::count(pinned_, true) < 3) {
    throw std::invalid_argument("a pinned body needs at least three pinned masses; it could turn about fewer");
  }
}

void Lattice::find_springs(std::span<const double> volumes) {
  std::vector<Spring> springs;
  for (std::size_t t = 0; t < volumes.size(); ++t) {
    const auto& nodes = mesh_.tetrahedra[t];
    std::size_t edge = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        const auto [a, b] = std::minmax(nodes[i], nodes[j]);
        const double length = (mesh_.nodes[b] - mesh_.nodes[a]).norm();
        const double factor = own_stiffness(t) * own_edges(t)[edge++];
        springs.push_back({.a = a,
                           .b = b,
                           .stiffness = material_.young * factor * volumes[t] / (length * length),
                           .damping = material_.damping.stiffness * own_damping(t),
                           .section = volumes[t] / length,
                           .natural = length * (own_.length.empty() ? 1.0 : own_.length[t])});
      }
    }
  }
  std::ranges::stable_sort(springs, {}, [](const Spring& spring) { return std::tuple(spring.a, spring.b); });
  springs_ = merged(springs);
  change_own_springs();
  damping_ = material_.damping;
  if (!is_damped_evenly()) {
    damping_.stiffness = std::ranges::max(springs_, {}, &Spring::damping).damping;
  }
}

void Lattice::change_own_springs() {
  const auto masses_of = [](const Spring& spring) { return std::pair(spring.a, spring.b); };
  for (const OwnSpring& own : own_.springs) {
    const std::pair<Index, Index> masses = std::minmax(own.a, own.b);
    const auto spring = std::ranges::lower_bound(springs_, masses, {}, masses_of);
    if (spring == springs_.end() || masses_of(*spring) != masses) {
      throw std::invalid_argument("there is no spring between the masses " + std::to_string(own.a) + " and " +
                                  std::to_string(own.b));
    }
    spring->stiffness *= own.stiffness;
    spring->damping *= own.damping;
    spring->natural *= own.length;
  }
}

bool Lattice::is_damped_evenly() const {
  return own_.damping.empty() && std::ranges::all_of(
                                     own_.springs, [](double own) { return own == 1.0; }, &OwnSpring::damping);
}

bool Lattice::is_under_tension() const {
  return !own_.length.empty() || std::ranges::any_of(
                                     own_.springs, [](double own) { return own != 1.0; }, &OwnSpring::length);
}

/// Moves the masses to where the springs are in equilibrium; a free body keeps its centre of mass.
void Lattice::find_rest(std::span<const double> volumes) {
  given_nodes_ = std::exchange(mesh_.nodes, equilibrium(mesh_.nodes, springs_, pinned_));
  if (is_free_) {
    const Vector3 shift = inertia_of(given_nodes_, masses_).centre - inertia_of(mesh_.nodes, masses_).centre;
    for (Vector3& node : mesh_.nodes) {
      node += shift;
    }
  }
  for (std::size_t t = 0; t < volumes.size(); ++t) {
    if (!(signed_volume(mesh_.nodes, mesh_.tetrahedra[t]) * signed_volume(given_nodes_, mesh_.tetrahedra[t]) > 0.0)) {
      throw std::invalid_argument("the natural lengths turn tetrahedron " + std::to_string(t) +
                                  " inside out; they must be closer to the lengths in the mesh");
    }
  }
  for (Spring& spring : springs_) {
    spring.tension = spring.stiffness * ((mesh_.nodes[spring.b] - mesh_.nodes[spring.a]).norm() - spring.natural);
  }
}

Lattice::Lattice(TetrahedralMesh mesh, const Material& material, std::span<const Index> pinned, OwnValues own)
    : mesh_(std::move(mesh)),
      material_(material),
      own_(std::move(own)),
      pinned_(mesh_.nodes.size()),
      is_free_(pinned.empty()) {
  for (const Index node : pinned) {
    if (node < 0 || static_cast<std::size_t>(node) >= pinned_.size()) {
      throw std::invalid_argument("there is no node " + std::to_string(node) + " to pin");
    }
    pinned_[node] = true;
  }
  check();
  const std::vector<double> volume = volumes(mesh_);
  body_inertia_ = inertia_of(mesh_, volume, material.density);
  masses_ = own_.masses.empty() ? point_masses(mesh_, volume, material.density, body_inertia_) : own_.masses;
  if (std::ranges::min(masses_) <= 0.0) {
    throw std::invalid_argument("there is a node without tetrahedra");
  }
  find_springs(volume);
  if (is_under_tension()) {
    find_rest(volume);
  }
  inertia_ = inertia_of(mesh_.nodes, masses_);
  const FrequencyBounds bounds = frequency_bounds(mesh_.nodes, springs_, masses_, pinned_, enough_rounds);
  largest_angular_frequency_ = std::sqrt(std::ranges::max(bounds.squares));
}

Contact Lattice::contact_at(const Vector3& point) const {
  const Vector3 direction = point - inertia_.centre;
  double nearest = std::numeric_limits<double>::infinity();  // m, from the point
  Contact contact;
  for (const auto& triangle : mesh_.surface) {
    const double way = distance_to_triangle(inertia_.centre, direction, corners_of(mesh_, triangle));
    if (const double distance = std::abs(way - 1.0) * direction.norm(); way >= 0.0 && distance < nearest) {
      nearest = distance;
      contact = shared_by_distance(mesh_, triangle, inertia_.centre + way * direction);
    }
  }
  for (const auto& triangle : mesh_.surface) {
    for (const Index node : triangle) {
      if (const double distance = (mesh_.nodes[node] - point).norm(); distance < nearest) {
        nearest = distance;
        contact = {.masses = {node, node, node}, .shares = {1.0, 0.0, 0.0}};
      }
    }
  }
  return contact;
}

}  // namespace idiophone::proxies
