#include "idiophone/source/recorded_motion.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "spread_radii.hpp"

namespace idiophone::source {

namespace {

constexpr std::int64_t values_kept = 1 << 21;

/// Rows x y z.
std::vector<Vector3> points(const std::vector<double>& rows) {
  std::vector<Vector3> all;
  for (std::size_t i = 0; i + 2 < rows.size(); i += 3) {
    all.emplace_back(rows[i], rows[i + 1], rows[i + 2]);
  }
  return all;
}

}  // namespace

RecordedMotion::RecordedMotion(const store::SurfaceMotionReader& reader, int rank, int ranks)
    : reader_(reader), first_triangle_(reader.triangles() * rank / ranks) {
  const std::int64_t count = reader.triangles() * (rank + 1) / ranks - first_triangle_;
  triangles_ = reader.read_triangles(first_triangle_, count);
  if (triangles_.empty()) {
    return;  // more ranks than triangles
  }
  Index lowest = triangles_[0][0];
  Index highest = lowest;
  for (const mesh::Triangle& triangle : triangles_) {
    const auto [low, high] = std::ranges::minmax(triangle);
    lowest = std::min(lowest, low);
    highest = std::max(highest, high);
  }
  first_vertex_ = lowest;
  vertices_ = highest - lowest + 1;
  for (mesh::Triangle& triangle : triangles_) {
    for (Index& vertex : triangle) {
      vertex -= lowest;
    }
  }
}

AudibleSurface RecordedMotion::surface(bool with_radii) const {
  AudibleSurface surface{.triangles = triangles_,
                         .triangle_ids = std::vector<Index>(triangles_.size()),
                         .vertex_ids = std::vector<Index>(static_cast<std::size_t>(vertices_)),
                         .reference = points(reader_.read_reference(first_vertex_, vertices_)),
                         .radii = {},
                         .first_triangle = {},
                         .obstacles = {},
                         .half_spaces = {}};
  std::iota(surface.triangle_ids.begin(), surface.triangle_ids.end(), static_cast<Index>(first_triangle_));
  std::iota(surface.vertex_ids.begin(), surface.vertex_ids.end(), static_cast<Index>(first_vertex_));
  for (const store::RecordedBody& body : reader_.header().bodies) {
    surface.first_triangle.push_back(body.first_triangle);
  }
  surface.first_triangle.push_back(static_cast<Index>(reader_.triangles()));
  if (with_radii) {
    const std::vector<Vector3> reference = points(reader_.read_reference(0, reader_.vertices()));
    surface.radii = spread_radii(surface.triangle_ids, surface.first_triangle, [&](std::size_t body) {
      const Index begin = surface.first_triangle[body];
      std::vector<std::array<Vector3, 3>> whole;
      for (const auto& [i, j, k] : reader_.read_triangles(begin, surface.first_triangle[body + 1] - begin)) {
        whole.push_back({reference[static_cast<std::size_t>(i)], reference[static_cast<std::size_t>(j)],
                         reference[static_cast<std::size_t>(k)]});
      }
      return whole;
    });
  }
  const std::vector<Vector3> corners = points(reader_.header().obstacle_triangles);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    surface.obstacles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  }
  const std::vector<Vector3> planes = points(reader_.header().half_spaces);
  for (std::size_t i = 0; i + 1 < planes.size(); i += 2) {
    surface.half_spaces.push_back({planes[i], planes[i + 1]});
  }
  return surface;
}

void RecordedMotion::take(surface::SurfaceMotion& motion) {
  if (row_ == end_) {
    read_rows();
  }
  const auto copy = [&](const std::vector<double>& rows, std::size_t width, std::size_t length,
                        std::vector<double>& values) {
    values.resize(length);
    std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>((row_ - begin_) * static_cast<std::int64_t>(width)), width,
                values.begin());
  };
  const auto vertices = static_cast<std::size_t>(vertices_);
  copy(pressure_, triangles_.size(), padded(triangles_.size()), motion.pressure);
  copy(position_, 3 * vertices, surface::SurfaceMotion::position_length(vertices), motion.position);
  ++row_;
}

void RecordedMotion::read_rows() {
  if (row_ == reader_.rows()) {
    throw std::runtime_error("the recording has no more audio samples");
  }
  const auto triangles = static_cast<std::int64_t>(triangles_.size());
  const std::int64_t rows = std::clamp<std::int64_t>(values_kept / std::max<std::int64_t>(triangles + 3 * vertices_, 1),
                                                     1, reader_.rows() - row_);
  begin_ = row_;
  end_ = row_ + rows;
  pressure_ = reader_.read_pressure(row_, rows, first_triangle_, triangles);
  position_ = reader_.read_position(row_, rows, first_vertex_, vertices_);
}

}  // namespace idiophone::source
