#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "idiophone/study/bench/cut_drawing.hpp"
#include "triangles_along.hpp"

namespace idiophone::bench {

namespace {

/// The heights between which a section of the body lies, m.
struct Slice {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void extend(double height) {
    low = std::min(low, height);
    high = std::max(high, height);
  }
};

Slice slice_at(const mesh::Mesh& mesh, const TrianglesAlong& surface, const Side& side, double along) {
  Slice slice;
  for (const mesh::Triangle& triangle : surface.at(along)) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3& a = mesh.nodes[triangle.at(k)];
      const Vector3& b = mesh.nodes[triangle.at((k + 1) % 3)];
      const double from = a[side.along] - along, to = b[side.along] - along;
      if (from == 0) {
        slice.extend(a[side.facing]);
      } else if (from * to < 0) {
        slice.extend(a[side.facing] + from / (from - to) * (b[side.facing] - a[side.facing]));
      }
    }
  }
  return slice;
}

/// Refuses a body of which nothing lies between two neighbouring stations.
void require_no_gap(const mesh::Mesh& mesh, const TrianglesAlong& surface, const Side& side,
                    const std::vector<double>& stations) {
  for (std::size_t s = 1; s < stations.size(); ++s) {
    const Slice slice = slice_at(mesh, surface, side, (stations[s - 1] + stations[s]) / 2);
    if (slice.low > slice.high) {
      throw std::runtime_error(
          fmt::format("--dxf draws one outline, but nothing of the body lies between {} = {:.4g} and {:.4g} m: leave "
                      "--dxf out",
                      axis_name(side), stations[s - 1], stations[s]));
    }
  }
}

/// Places where the profile bends or jumps, ascending.
std::vector<double> stations_of(const mesh::Mesh& mesh, const Side& side, const std::vector<Cut>& cuts) {
  constexpr int pieces = 32;  // of a hollow
  constexpr double near = 1e-9;
  std::vector<double> stations;
  for (const mesh::Triangle& triangle : mesh.outer_surface()) {
    for (const Index node : triangle) {
      stations.push_back(mesh.nodes[node][side.along]);
    }
  }
  const auto [low, high] = ends_along(mesh, side);
  for (const Cut& cut : cuts) {
    for (int piece = 0; piece <= pieces; ++piece) {
      const double station = cut.place + cut.tool.radius * (2.0 * piece / pieces - 1);
      if (station > low && station < high) {
        stations.push_back(station);
      }
    }
  }
  std::ranges::sort(stations);
  const auto [first, last] = std::ranges::unique(stations, [](double a, double b) { return b - a < near; });
  stations.erase(first, last);
  return stations;
}

}  // namespace

Profile2 profile_of(const mesh::Mesh& mesh, const Side& side, const std::vector<Cut>& cuts) {
  constexpr double beside = 1e-9;  // m, of both sides of an edge
  const TrianglesAlong surface(mesh, mesh.outer_surface(), side.along);
  Profile2 cut_side, other_side;
  const auto add = [&](const Slice& slice, double station, double depth) {
    const double height = side.sign < 0 ? slice.low + depth : slice.high - depth;
    if (side.sign < 0 ? height >= slice.high : height <= slice.low) {
      throw std::runtime_error(fmt::format("a cut at {} = {:.4g} m goes through the body", axis_name(side), station));
    }
    cut_side.push_back({station, height});
  };
  const std::vector<double> stations = stations_of(mesh, side, cuts);
  require_no_gap(mesh, surface, side, stations);
  for (const double station : stations) {
    const Slice slice = slice_at(mesh, surface, side, station);
    const double before = depth_of(cuts, station - 2 * beside), after = depth_of(cuts, station + 2 * beside);
    add(slice, station, before);
    if (std::abs(after - before) > beside) {
      add(slice, station, after);
    }
    other_side.push_back({station, side.sign < 0 ? slice.high : slice.low});
  }
  std::ranges::reverse(other_side);
  cut_side.insert(cut_side.end(), other_side.begin(), other_side.end());
  return cut_side;
}

}  // namespace idiophone::bench
