#include "polyhedron.hpp"

#include <algorithm>

namespace idiophone::contact {

void Polyhedron::become(const Tetrahedron& tetrahedron) {
  faces_.clear();
  corners_.clear();
  double extent = 0.0;
  double far = 0.0;
  for (const Vector3& corner : tetrahedron.corners) {
    extent = std::max(extent, (corner - tetrahedron.corners[0]).lpNorm<Eigen::Infinity>());
    far = std::max(far, corner.lpNorm<Eigen::Infinity>());
  }
  tiny_ = 1e-12 * extent + 1e-14 * far;
  for (std::size_t f = 0; f < 4; ++f) {
    const std::size_t first = corners_.size();
    const auto corners = tetrahedron.face(f);
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    faces_.push_back({static_cast<int>(f), first, corners_.size()});
  }
}

void Polyhedron::clip(const Plane& plane, int face) {
  distances_.clear();
  bool some_outside = false;
  bool some_inside = false;
  for (const Vector3& corner : corners_) {
    // A corner on the plane but for round-off is on it: else noise would cut a face that lies in the plane to pieces.
    const double distance = plane.distance(corner);
    distances_.push_back(distance > tiny_ ? distance : std::min(distance, 0.0));
    (distance > tiny_ ? some_outside : some_inside) = true;
  }
  if (!some_outside) {
    return;
  }
  new_faces_.clear();
  new_corners_.clear();
  cut_edges_.clear();
  if (some_inside) {
    for (const CornerRange& range : faces_) {
      clip_face(range);
    }
    close(face);
  }
  faces_.swap(new_faces_);
  corners_.swap(new_corners_);
}

void Polyhedron::clip_face(const CornerRange& face) {
  const std::size_t first = new_corners_.size();
  std::array<Vector3, 2> edge;  // of the cut: from where the face's boundary comes back in to where it leaves
  bool cut = false;
  for (std::size_t i = face.first; i < face.last; ++i) {
    const std::size_t next = i + 1 < face.last ? i + 1 : face.first;
    const bool inside = distances_[i] <= 0;
    if (inside) {
      new_corners_.push_back(corners_[i]);
    }
    if (inside != (distances_[next] <= 0)) {
      // Always from the inside out, so that both faces at an edge find the same point to the bit.
      const std::size_t in = inside ? i : next;
      const std::size_t out = inside ? next : i;
      const double part = distances_[in] / (distances_[in] - distances_[out]);
      const Vector3 point = corners_[in] + part * (corners_[out] - corners_[in]);
      new_corners_.push_back(point);
      edge[inside ? 1 : 0] = point;
      cut = true;
    }
  }
  if (cut && (edge[1] - edge[0]).squaredNorm() > tiny_ * tiny_) {
    cut_edges_.push_back(edge);
  }
  if (new_corners_.size() - first >= 3) {
    new_faces_.push_back({face.number, first, new_corners_.size()});
  } else {
    new_corners_.resize(first);
  }
}

void Polyhedron::close(int number) {
  if (cut_edges_.size() < 3) {
    return;
  }
  // Edge after edge, each the one that begins nearest to the last one's end: edges that round-off may have lost leave
  // gaps no longer than tiny_.
  const std::size_t first = new_corners_.size();
  for (std::size_t edge = 0; edge < cut_edges_.size(); ++edge) {
    const auto rest = cut_edges_.begin() + static_cast<std::ptrdiff_t>(edge);
    if (edge > 0) {
      const Vector3 end = (rest - 1)->back();
      const auto distance = [&](const std::array<Vector3, 2>& next) { return (next[0] - end).squaredNorm(); };
      std::iter_swap(rest, std::ranges::min_element(rest, cut_edges_.end(), {}, distance));
    }
    new_corners_.push_back(rest->front());
  }
  new_faces_.push_back({number, first, new_corners_.size()});
}

Polyhedron::Moments Polyhedron::moments() const {
  Moments moments;
  if (empty()) {
    return moments;
  }
  // Tetrahedra from one corner to the triangles of every face.
  const Vector3 apex = corners_.front();
  for (const CornerRange& face : faces_) {
    const Vector3 a = corners_[face.first] - apex;
    for (std::size_t i = face.first + 2; i < face.last; ++i) {
      const Vector3 b = corners_[i - 1] - apex;
      const Vector3 c = corners_[i] - apex;
      const double volume = a.dot(b.cross(c)) / 6;
      moments.volume += volume;
      moments.first += volume / 4 * (a + b + c);
    }
  }
  moments.first += moments.volume * apex;
  return moments;
}

Polyhedron::Polygon Polyhedron::face(std::size_t place) const {
  const CornerRange& range = faces_[place];
  return {range.number, std::span(corners_).subspan(range.first, range.last - range.first)};
}

}  // namespace idiophone::contact
