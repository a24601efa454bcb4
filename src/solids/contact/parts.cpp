#include "parts.hpp"

#include <algorithm>
#include <cstdlib>

namespace idiophone::contact {

namespace {

class Parts {
 public:
  Parts(std::span<const FaceShare> faces, Side& side) : faces_(faces), side_(side) {}

  /// Gives a part to each node that hangs together with nodes that have one.
  void spread() {
    for (bool more = true; more;) {
      more = false;
      for (const FaceShare& face : faces_) {
        const int known = sum(face.own_cell) - sum(face.other_cell);
        if (known != 0 && lacks_parts(face)) {
          set(face, known > 0 ? 1 : -1);
          more = true;
        }
      }
    }
  }

  /// Chooses the parts of a face that spread() could not reach, and of all that hangs together with it.
  void begin_at(const FaceShare& face) {
    chosen_.clear();
    set(face, 1);
    spread();
    Vector3 force = Vector3::Zero();  // on the first part, N
    for (const Index node : chosen_) {
      force += side_.bond[node].part * side_.touch[node].pressure * side_.touch[node].area;
    }
    if (force.dot(towards_first) < 0) {
      std::ranges::for_each(chosen_, [&](Index node) { side_.bond[node].part *= -1; });
    }
  }

  [[nodiscard]] bool lacks_parts(const FaceShare& face) const {
    return lacks_parts(face.own_cell) || lacks_parts(face.other_cell);
  }

 private:
  [[nodiscard]] int sum(Index cell) const {
    int parts = 0;
    for (const Index node : side_.skin.cells[cell]) {
      parts += side_.bond[node].part;
    }
    return parts;
  }

  [[nodiscard]] bool lacks_parts(Index cell) const {
    return std::ranges::any_of(side_.skin.cells[cell], [&](Index node) { return side_.bond[node].part == 0; });
  }

  void set(const FaceShare& face, int part_of_own) {
    set(face.own_cell, part_of_own);
    set(face.other_cell, -part_of_own);
  }

  void set(Index cell, int part) {
    for (const Index node : side_.skin.cells[cell]) {
      if (side_.bond[node].part == 0) {
        side_.bond[node].part = part;
        chosen_.push_back(node);
      }
    }
  }

  std::span<const FaceShare> faces_;
  Side& side_;
  std::vector<Index> chosen_;  ///< nodes that got a part
};

}  // namespace

void choose_parts(std::span<const FaceShare> faces, Side& side) {
  Parts parts(faces, side);
  parts.spread();
  for (const FaceShare& face : faces) {
    if (parts.lacks_parts(face)) {
      parts.begin_at(face);
    }
  }
}

}  // namespace idiophone::contact
