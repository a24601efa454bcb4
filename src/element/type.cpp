#include "idiophone/element/type.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "idiophone/element/tetrahedra.hpp"

namespace idiophone::element {

std::span<const Type> types() {
  static constexpr std::array all = {tet4, tet10};
  return all;
}

std::string_view name(Type type) {
  switch (type.kind) {
    case Kind::tet4:
      return "tet4";
    case Kind::tet10:
      return "tet10";
  }
  unknown_kind();
}

int node_count(Type type) {
  switch (type.kind) {
    case Kind::tet4:
      return Tet4::nodes;
    case Kind::tet10:
      return Tet10::nodes;
  }
  unknown_kind();
}

Type tetrahedron_with(int nodes) {
  const auto found = std::ranges::find(types(), nodes, node_count);
  if (found == types().end()) {
    throw std::invalid_argument("tetrahedra have 4 or 10 nodes, not " + std::to_string(nodes));
  }
  return *found;
}

void unknown_kind() {
  throw std::logic_error("an element type of no known kind");
}

}  // namespace idiophone::element
