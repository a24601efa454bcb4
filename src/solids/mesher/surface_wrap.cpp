#include "surface_wrap.hpp"

// CGAL 6 (Debian 13) has new names for the trees and warns of the old ones, the only ones that CGAL 5 (Debian 12)
// knows.
#define CGAL_NO_DEPRECATION_WARNINGS
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace idiophone::mesher {

namespace {

namespace processing = CGAL::Polygon_mesh_processing;
namespace simplification = CGAL::Surface_mesh_simplification;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using ClosedSurface = CGAL::Surface_mesh<Point>;
using Corners = std::array<std::size_t, 3>;

struct Soup {
  std::vector<Point> points;
  std::vector<Corners> triangles;
};

Soup soup_of(const Surface& surface) {
  Soup soup;
  for (std::size_t i = 0; i < surface.coordinates.size(); i += 3) {
    soup.points.emplace_back(surface.coordinates[i], surface.coordinates[i + 1], surface.coordinates[i + 2]);
  }
  for (std::size_t i = 0; i < surface.triangles.size(); i += 3) {
    soup.triangles.push_back({surface.triangles[i], surface.triangles[i + 1], surface.triangles[i + 2]});
  }
  return soup;
}

Surface surface_of(const ClosedSurface& mesh) {
  Surface surface;
  for (const auto vertex : mesh.vertices()) {
    const Point& place = mesh.point(vertex);
    surface.coordinates.insert(surface.coordinates.end(), {place.x(), place.y(), place.z()});
  }
  for (const auto face : mesh.faces()) {
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
      surface.triangles.push_back(vertex.idx());
    }
  }
  return surface;
}

/// A wrap through an opening is a shell around the triangles, twice as thick as the offset.
bool is_empty_shell(const ClosedSurface& wrap, double offset) {
  return processing::volume(wrap) < 2.0 * offset * processing::area(wrap);
}

/// Every vertex of a wrap is at the distance of the offset from the triangles.
void pull_onto(const Soup& soup, ClosedSurface& wrap) {
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  Triangles triangles;
  for (const auto& [a, b, c] : soup.triangles) {
    const Kernel::Triangle_3 triangle(soup.points[a], soup.points[b], soup.points[c]);
    if (!triangle.is_degenerate()) {
      triangles.push_back(triangle);
    }
  }
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(triangles.cbegin(), triangles.cend());
  for (const auto vertex : wrap.vertices()) {
    wrap.point(vertex) = tree.closest_point(wrap.point(vertex));
  }
}

void collapse_edges_shorter_than(double length, ClosedSurface& mesh) {
  using Placement = simplification::LindstromTurk_placement<ClosedSurface>;
  const simplification::Edge_length_stop_predicate<double> enough(length);
  simplification::edge_collapse(
      mesh, enough,
      CGAL::parameters::get_cost(simplification::Edge_length_cost<double>())
          .get_placement(simplification::Bounded_normal_change_placement<Placement>()));  // folds no triangle over
  mesh.collect_garbage();
}

/// 0 for a flat triangle, 0.87 for a regular one.
double height_over_base(const Point& a, const Point& b, const Point& c) {
  const double base =
      std::max({CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)});
  return std::sqrt(CGAL::cross_product(b - a, c - a).squared_length()) / base;
}

/// Whether the other diagonal of the two triangles at an edge makes better ones in almost the same place.
bool is_better_flipped(const ClosedSurface& mesh, ClosedSurface::Halfedge_index edge) {
  constexpr double least_gain = 1.01;  // more than rounding, so that flips come to an end
  constexpr double most_shift = 0.1;   // of the surface, in lengths of the new diagonal
  const auto left = mesh.target(mesh.next(edge)), right = mesh.target(mesh.next(mesh.opposite(edge)));
  if (mesh.halfedge(left, right).is_valid()) {
    return false;
  }
  const Point &a = mesh.point(mesh.source(edge)), &b = mesh.point(mesh.target(edge)), &c = mesh.point(left),
              &d = mesh.point(right);
  const auto side = CGAL::cross_product(b - a, c - a) + CGAL::cross_product(a - b, d - b);
  if (CGAL::cross_product(d - a, c - a) * side <= 0.0 || CGAL::cross_product(c - b, d - b) * side <= 0.0) {
    return false;
  }
  const auto across = CGAL::cross_product(b - a, d - c);
  const double shift = std::abs(across * (c - a)) / std::sqrt(across.squared_length());
  const double worst = std::min(height_over_base(a, b, c), height_over_base(b, a, d));
  return shift < most_shift * std::sqrt(CGAL::squared_distance(c, d)) &&
         std::min(height_over_base(a, d, c), height_over_base(b, c, d)) > least_gain * worst;
}

/// The collapse can leave flat triangles.
void flip_edges_of_flat_triangles(ClosedSurface& mesh) {
  for (bool changes = true; changes;) {
    changes = false;
    for (const auto edge : mesh.edges()) {
      if (is_better_flipped(mesh, mesh.halfedge(edge))) {
        CGAL::Euler::flip_edge(mesh.halfedge(edge), mesh);
        changes = true;
      }
    }
  }
}

}  // namespace

Surface wrapped(const Surface& damaged, const WrapLengths& lengths) {
  const Soup soup = soup_of(damaged);
  const double radius = lengths.gap / 2.0;  // of the ball that rolls around the triangles: alpha
  const double offset = radius / 25.0;      // smaller ones take longer, larger ones round edges off
  ClosedSurface wrap;
  CGAL::alpha_wrap_3(soup.points, soup.triangles, radius, offset, wrap);
  if (is_empty_shell(wrap, offset)) {
    return {};
  }
  pull_onto(soup, wrap);
  collapse_edges_shorter_than(lengths.edge, wrap);
  flip_edges_of_flat_triangles(wrap);
  return surface_of(wrap);
}

std::optional<std::array<double, 3>> crossing(const Surface& surface) {
  Soup soup = soup_of(surface);
  processing::orient_polygon_soup(soup.points, soup.triangles);
  ClosedSurface mesh;
  processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  std::vector<std::pair<ClosedSurface::Face_index, ClosedSurface::Face_index>> pairs;
  processing::self_intersections(mesh, std::back_inserter(pairs));
  if (pairs.empty()) {
    return std::nullopt;
  }
  const auto& [a, b, c] = soup.triangles[std::ranges::min(pairs).first.idx()];  // CGAL finds them in any order
  const Point place = CGAL::centroid(soup.points[a], soup.points[b], soup.points[c]);
  return {{place.x(), place.y(), place.z()}};
}

}  // namespace idiophone::mesher
