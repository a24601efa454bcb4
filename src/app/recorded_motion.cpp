#include "recorded_motion.hpp"

#include <algorithm>
#include <stdexcept>

#include "idiophone/surface/equivalent_radius.hpp"

namespace idiophone::app {

namespace {

constexpr std::int64_t values_kept = 1 << 21;

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

std::vector<double> RecordedMotion::radii() const {
  const auto& bodies = reader_.header().bodies;
  const auto last_triangle = first_triangle_ + static_cast<std::int64_t>(triangles_.size());
  const std::vector<double> reference = reader_.read_reference(0, reader_.vertices());
  const auto corner = [&](Index vertex) -> Vector3 {
    return Vector3::Map(&reference[3 * static_cast<std::size_t>(vertex)]);
  };
  std::vector<double> radii;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::int64_t begin = bodies[b].first_triangle;
    const std::int64_t end = b + 1 < bodies.size() ? bodies[b + 1].first_triangle : reader_.triangles();
    std::vector<Index> here;
    for (auto triangle = std::max(begin, first_triangle_); triangle < std::min(end, last_triangle); ++triangle) {
      here.push_back(static_cast<Index>(triangle - begin));
    }
    if (here.empty()) {
      continue;
    }
    std::vector<std::array<Vector3, 3>> surface;
    for (const auto& [i, j, k] : reader_.read_triangles(begin, end - begin)) {
      surface.push_back({corner(i), corner(j), corner(k)});
    }
    const std::vector<double> found = surface::equivalent_radii(surface, here);
    radii.insert(radii.end(), found.begin(), found.end());
  }
  return radii;
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

}  // namespace idiophone::app
