#include "surface_share.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "idiophone/foundation/each_once.hpp"

namespace idiophone::bodies {

SurfaceShare::SurfaceShare(const std::vector<bool>& left_out, const mesh::Part& part) : part_(part) {
  for (std::size_t t = 0; t < part.surface.size(); ++t) {
    if (!left_out[part.triangle_body[t]]) {
      triangles_.push_back(t);
      vertices_.insert(vertices_.end(), part.surface[t].begin(), part.surface[t].end());
    }
  }
  keep_each_once(vertices_);
}

SurfaceShare SurfaceShare::of_body(std::size_t body, const mesh::Part& part) {
  std::vector<bool> others(part.bodies.size(), true);
  others[body] = false;
  return {others, part};
}

std::vector<mesh::Triangle> SurfaceShare::corners() const {
  std::vector<mesh::Triangle> result;
  for (const std::size_t t : triangles_) {
    mesh::Triangle& triangle = result.emplace_back(part_.surface[t]);
    for (Index& vertex : triangle) {
      const auto place = std::ranges::lower_bound(vertices_, static_cast<std::size_t>(vertex));
      vertex = static_cast<Index>(place - vertices_.begin());
    }
  }
  return result;
}

std::vector<std::size_t> SurfaceShare::nodes() const {
  std::vector<std::size_t> result;
  std::ranges::transform(vertices_, std::back_inserter(result),
                         [this](std::size_t vertex) { return part_.vertices[vertex]; });
  return result;
}

std::vector<Vector3> SurfaceShare::positions() const {
  std::vector<Vector3> result;
  std::ranges::transform(vertices_, std::back_inserter(result),
                         [this](std::size_t vertex) { return part_.reference[part_.vertices[vertex]]; });
  return result;
}

parallel::Rows rows_without(const std::vector<bool>& left_out, const std::vector<Index>& numbers,
                            const std::vector<Index>& first, const std::vector<std::size_t>& places,
                            MPI_Comm communicator) {
  std::vector<Index> before = {0};  // numbers left out up to each body
  for (std::size_t body = 0; body < left_out.size(); ++body) {
    before.push_back(before.back() + (left_out[body] ? first[body + 1] - first[body] : 0));
  }
  std::vector<Index> rows;
  for (const std::size_t place : places) {
    const auto body = std::ranges::upper_bound(first, numbers[place]) - first.begin() - 1;
    rows.push_back(numbers[place] - before[body]);
  }
  return {rows, first.back() - before.back(), communicator};
}

}  // namespace idiophone::bodies
