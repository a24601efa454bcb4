#include "idiophone/study/advice/thickness.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "idiophone/solids/mesh/line_crossing.hpp"

namespace idiophone::advice {

namespace {

constexpr std::size_t most_rays = 400;    // from the surface inwards
constexpr int sideways = 8;               // directions across the thickness
constexpr double smallest_part = 0.05;    // of the surface
constexpr double decibels = 9.0;          // where a cell is as large as the section
constexpr double thickest_sheet = 0.625;  // cells: what is thinner has two sides in a cell, and only its edges are off
constexpr double slack = 1e-9;            // a ray through an edge hits

using Corners = mesh::TrianglePoints;

/// The nearest surface along a ray that is farther away than `least`, m.
double distance_to(const std::vector<Corners>& surface, const Vector3& from, const Vector3& direction, double least) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Corners& triangle : surface) {
    const std::optional<double> distance = mesh::line_crossing(triangle, from, direction, slack);
    nearest = distance && *distance > least ? std::min(nearest, *distance) : nearest;
  }
  return nearest;
}

CrossSection section_at(const std::vector<Corners>& surface, const Corners& triangle, const Vector3& inwards,
                        double size) {
  const Vector3 centre = (triangle[0] + triangle[1] + triangle[2]) / 3;
  CrossSection section{.thickness = distance_to(surface, centre, inwards, 1e-6 * size), .width = size};
  const Vector3 middle = centre + section.thickness / 2 * inwards;
  const Vector3 u = inwards.unitOrthogonal(), v = inwards.cross(u);
  for (int i = 0; i < sideways && std::isfinite(section.thickness); ++i) {
    const double angle = std::numbers::pi * i / sideways;
    const Vector3 aside = std::cos(angle) * u + std::sin(angle) * v;
    section.width =
        std::min(section.width, distance_to(surface, middle, aside, 0) + distance_to(surface, middle, -aside, 0));
  }
  return {std::min(section.thickness, section.width), std::max(section.thickness, section.width)};
}

}  // namespace

CrossSection smallest_cross_section(std::span<const mesh::Triangle> triangles, std::span<const Vector3> nodes) {
  std::vector<Corners> surface;
  Eigen::AlignedBox3d box;
  for (const auto& [a, b, c] : triangles) {
    surface.push_back({nodes[a], nodes[b], nodes[c]});
    box.extend(nodes[a]).extend(nodes[b]).extend(nodes[c]);
  }
  struct Sample {
    CrossSection section;
    double area;
  };
  std::vector<Sample> samples;
  double whole = 0.0;
  for (std::size_t t = 0; t < surface.size(); t += 1 + surface.size() / most_rays) {
    const auto& [a, b, c] = surface[t];
    const Vector3 twice = (b - a).cross(c - a);
    samples.push_back({section_at(surface, surface[t], -twice.normalized(), box.sizes().norm()), twice.norm() / 2});
    whole += samples.back().area;
  }
  const auto size = [](const Sample& sample) { return sample.section.thickness * sample.section.width; };
  std::ranges::sort(samples, {}, size);
  double smaller = 0.0;
  const auto smallest = std::ranges::find_if(samples, [&](const Sample& sample) {
    smaller += sample.area;
    return smaller > smallest_part * whole;
  });
  return smallest->section;
}

double level_error(const CrossSection& section, double cell) {
  return decibels * cell * cell / (std::max(section.thickness, thickest_sheet * cell) * section.width);
}

double opposite_parts_from(const CrossSection& section, double cell, double speed) {
  const auto part = [](double level) { return std::pow(10.0, level / 20.0) - 1.0; };
  return speed * part(level_error(section, cell)) /
         (2.0 * std::numbers::pi * part(3.0) * std::max(section.thickness, thickest_sheet * cell));
}

double fine_cell(const CrossSection& section) {
  const double of_solids = std::sqrt(small_level_error / decibels * section.thickness * section.width);
  const double of_sheets = small_level_error / decibels * thickest_sheet * section.width;
  return std::max(of_solids, of_sheets);
}

}  // namespace idiophone::advice
