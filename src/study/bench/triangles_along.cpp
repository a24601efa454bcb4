#include "triangles_along.hpp"

#include <algorithm>

namespace idiophone::bench {

TrianglesAlong::TrianglesAlong(const mesh::Mesh& mesh, std::span<const mesh::Triangle> triangles, int axis) {
  constexpr std::size_t count = 256;
  constexpr double nothing = 1e-6;  // of the length
  strips_.resize(count);
  const auto along = [&](const Vector3& node) { return node[axis]; };
  const auto [low, high] = std::ranges::minmax(mesh.nodes, {}, along);
  const double slack = nothing * (high[axis] - low[axis]);
  low_ = low[axis];
  width_ = std::max(slack, (high[axis] - low[axis]) / count);
  for (const mesh::Triangle& triangle : triangles) {
    const auto [first, last] = std::ranges::minmax(
        {mesh.nodes[triangle[0]][axis], mesh.nodes[triangle[1]][axis], mesh.nodes[triangle[2]][axis]});
    for (std::size_t strip = strip_of(first - slack); strip <= strip_of(last + slack); ++strip) {
      strips_[strip].push_back(triangle);
    }
  }
}

const std::vector<mesh::Triangle>& TrianglesAlong::at(double coordinate) const {
  return strips_[strip_of(coordinate)];
}

std::size_t TrianglesAlong::strip_of(double coordinate) const {
  return static_cast<std::size_t>(
      std::clamp((coordinate - low_) / width_, 0.0, static_cast<double>(strips_.size() - 1)));
}

}  // namespace idiophone::bench
