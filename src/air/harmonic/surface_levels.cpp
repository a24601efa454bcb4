#include "surface_levels.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "burton_miller.hpp"
#include "idiophone/foundation/each_once.hpp"

namespace idiophone::harmonic {

namespace {

using Quadratic = Eigen::Matrix<double, 6, 1>;  ///< 1, x, y, x^2, x y, y^2 at a point

/// Fits fields around the edges of a surface.
class EdgeFit {
 public:
  explicit EdgeFit(const Boundary& boundary)
      : boundary_(boundary), panels_(panels_of(boundary)), triangles_of_(boundary.vertices.size()) {
    for (std::size_t t = 0; t < boundary.triangles.size(); ++t) {
      for (const Index vertex : boundary.triangles[t]) {
        triangles_of_[vertex].push_back(t);
      }
    }
  }

  /// Adds the shares of the vertices in the middle of an edge, as the surface is around one of its triangles.
  void add_shares(std::size_t triangle, Index from, Index to, double weight, std::vector<VertexShare>& shares) const {
    const Vector3 middle = 0.5 * (boundary_.vertices[from] + boundary_.vertices[to]);
    const Vector3 edge = boundary_.vertices[to] - boundary_.vertices[from];
    const Vector3 across = panels_[triangle].normal.cross(edge);
    const std::vector<Index> vertices = smooth_surroundings(triangle, from, to);
    std::vector<Quadratic> rows;
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    constexpr double stiffness = 1e-8;  // where the points do not tell, the field is linear
    normal.diagonal().tail<3>().setConstant(stiffness);
    for (const Index vertex : vertices) {
      const Vector3 way = (boundary_.vertices[vertex] - middle) / edge.squaredNorm();
      const double x = way.dot(edge), y = way.dot(across);
      rows.emplace_back(Quadratic{1.0, x, y, x * x, x * y, y * y});
      normal += rows.back() * rows.back().transpose();
    }
    const Quadratic at_middle = normal.ldlt().solve(Quadratic::Unit(0));
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      shares.push_back({vertices[i], weight * rows[i].dot(at_middle)});
    }
  }

 private:
  /// Vertices of the triangles at both ends of an edge that look in about the same direction.
  [[nodiscard]] std::vector<Index> smooth_surroundings(std::size_t triangle, Index from, Index to) const {
    constexpr double smooth = 0.8;  // cosine of the angle between normals
    std::vector<Index> vertices;
    for (const Index end : {from, to}) {
      for (const std::size_t other : triangles_of_[end]) {
        if (panels_[other].normal.dot(panels_[triangle].normal) > smooth) {
          vertices.insert(vertices.end(), boundary_.triangles[other].begin(), boundary_.triangles[other].end());
        }
      }
    }
    keep_each_once(vertices);
    return vertices;
  }

  const Boundary& boundary_;
  std::vector<Panel> panels_;
  std::vector<std::vector<std::size_t>> triangles_of_;  // [vertices]
};

/// The triangles at each edge, which is named by its ends, in ascending order.
std::map<std::pair<Index, Index>, std::vector<std::size_t>> triangles_at_edges(const Boundary& boundary) {
  std::map<std::pair<Index, Index>, std::vector<std::size_t>> edges;
  for (std::size_t t = 0; t < boundary.triangles.size(); ++t) {
    const auto& [a, b, c] = boundary.triangles[t];
    for (const auto& edge : {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)}) {
      edges[edge].push_back(t);
    }
  }
  return edges;
}

}  // namespace

RefinedBoundary refined(const Boundary& boundary) {
  RefinedBoundary fine{{boundary.vertices, {}, boundary.floor}, {}};
  const EdgeFit fit(boundary);
  std::map<std::pair<Index, Index>, Index> middles;
  for (const auto& [edge, triangles] : triangles_at_edges(boundary)) {
    const auto& [from, to] = edge;
    middles[edge] = static_cast<Index>(fine.boundary.vertices.size());
    fine.boundary.vertices.emplace_back(0.5 * (boundary.vertices[from] + boundary.vertices[to]));
    auto& shares = fine.shares.emplace_back();
    for (const std::size_t triangle : triangles) {
      fit.add_shares(triangle, from, to, 1.0 / static_cast<double>(triangles.size()), shares);
    }
  }
  for (const auto& [a, b, c] : boundary.triangles) {
    const Index ab = middles[std::minmax(a, b)], bc = middles[std::minmax(b, c)], ca = middles[std::minmax(c, a)];
    for (const auto& part :
         {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}}) {
      fine.boundary.triangles.push_back(part);
    }
  }
  return fine;
}

std::vector<ComplexVector> at_vertices(const RefinedBoundary& fine, const std::vector<ComplexVector>& velocity) {
  std::vector<ComplexVector> values = velocity;
  for (const auto& shares : fine.shares) {
    ComplexVector value = ComplexVector::Zero();
    for (const auto& [vertex, share] : shares) {
      value += share * velocity[vertex];
    }
    values.push_back(value);
  }
  return values;
}

std::vector<Complex> normal_velocity(const Boundary& boundary, const RefinedBoundary& finer,
                                     const std::vector<ComplexVector>& velocity) {
  const std::vector<Panel> panels = panels_of(boundary);
  const std::vector<ComplexVector> all = at_vertices(finer, velocity);
  const auto sum_of = [&](const std::array<Index, 3>& places) -> ComplexVector {
    return all[places[0]] + all[places[1]] + all[places[2]];
  };
  std::vector<Complex> values;
  for (std::size_t t = 0; t < panels.size(); ++t) {
    const auto& middles = finer.boundary.triangles[4 * t + 3];  // their mean is that of a quadratic function
    const ComplexVector missing = (sum_of(middles) - sum_of(boundary.triangles[t])) / 3.0;
    for (const Index vertex : boundary.triangles[t]) {
      values.emplace_back(panels[t].normal.cast<Complex>().dot(velocity[vertex] + missing));
    }
  }
  return values;
}

SurfaceLevels::SurfaceLevels(const Boundary& boundary, const QuietAir& air, std::size_t most_vertices)
    : most_vertices_(most_vertices) {
  levels_.push_back({{boundary, air}, refined(boundary)});
}

const SurfaceLevels::Level* SurfaceLevels::level(std::size_t number) {
  if (number > 0 && number == levels_.size()) {
    const Boundary& fine = levels_.back().finer.boundary;
    if (fine.vertices.size() > most_vertices_) {
      return nullptr;
    }
    levels_.push_back({{fine, coarsest().air()}, refined(fine)});
  }
  return &levels_[number];
}

RefinedSolution solve_refined(SurfaceLevels& levels, double wave_number,
                              std::vector<std::vector<ComplexVector>> velocities, double tolerance) {
  const auto solve = [&](const SurfaceLevels::Level& level) {
    std::vector<std::vector<Complex>> normal;
    for (const auto& velocity : velocities) {
      normal.push_back(normal_velocity(level.elements.boundary(), level.finer, velocity));
    }
    return level.elements.solve(wave_number, normal);
  };
  const SurfaceLevels::Level* level = levels.level(0);
  RefinedSolution solution{.elements = &level->elements,
                           .fields = solve(*level),
                           .level_error = std::vector(velocities.size(), std::numeric_limits<double>::quiet_NaN())};
  const auto is_good = [&](double error) { return error <= tolerance; };
  for (std::size_t number = 1; tolerance > 0.0 && !std::ranges::all_of(solution.level_error, is_good); ++number) {
    const SurfaceLevels::Level* finer = levels.level(number);
    if (finer == nullptr) {
      break;
    }
    for (auto& velocity : velocities) {
      velocity = at_vertices(level->finer, velocity);
    }
    level = finer;
    std::vector<BoundaryField> fields = solve(*level);
    for (std::size_t m = 0; m < fields.size(); ++m) {
      solution.level_error[m] = std::abs(10.0 * std::log10(fields[m].power / solution.fields[m].power));
    }
    solution.elements = &level->elements;
    solution.refinements = number;
    solution.fields = std::move(fields);
  }
  return solution;
}

}  // namespace idiophone::harmonic
