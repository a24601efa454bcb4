#include "blocks.hpp"

#include <map>

namespace idiophone::waves {

radiation::Solid of_blocks(const Grating& planes, const std::function<bool(const Vector3&)>& is_solid) {
  radiation::Solid solid;
  std::map<std::array<int, 3>, Index> numbers;
  const auto number = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = numbers.try_emplace(at, static_cast<Index>(solid.vertices.size()));
    if (is_new) {
      solid.vertices.emplace_back(planes[0][at[0]], planes[1][at[1]], planes[2][at[2]]);
    }
    return found->second;
  };
  const auto solid_at = [&](const std::array<int, 3>& block) {
    Vector3 middle;
    for (int axis = 0; axis < 3; ++axis) {
      if (block[axis] < 0 || block[axis] + 1 >= std::ssize(planes[axis])) {
        return false;
      }
      middle[axis] = (planes[axis][block[axis]] + planes[axis][block[axis] + 1]) / 2.0;
    }
    return is_solid(middle);
  };
  const auto add_face = [&](std::array<int, 3> corner, int axis, bool upper) {
    corner[axis] += upper ? 1 : 0;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    auto b = corner, c = corner, d = corner;
    ++b[u];
    ++c[u], ++c[v];
    ++d[v];
    const std::array around = {number(corner), number(upper ? b : d), number(c), number(upper ? d : b)};
    solid.triangles.push_back({around[0], around[1], around[2]});
    solid.triangles.push_back({around[0], around[2], around[3]});
  };
  for (int x = 0; x + 1 < std::ssize(planes[0]); ++x) {
    for (int y = 0; y + 1 < std::ssize(planes[1]); ++y) {
      for (int z = 0; z + 1 < std::ssize(planes[2]); ++z) {
        const std::array block = {x, y, z};
        for (int face = 0; face < 6 && solid_at(block); ++face) {
          auto next = block;
          next[face / 2] += face % 2 == 1 ? 1 : -1;
          if (!solid_at(next)) {
            add_face(block, face / 2, face % 2 == 1);
          }
        }
      }
    }
  }
  return solid;
}

}  // namespace idiophone::waves
