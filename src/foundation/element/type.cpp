#include "idiophone/foundation/element/type.hpp"

#include <array>
#include <stdexcept>

#include "idiophone/foundation/element/tetrahedra.hpp"

namespace idiophone::element {

std::span<const Type> types() {
  static constexpr std::array all = {tet4, tet10, hex(4, 4)};
  return all;
}

std::string_view name(Type type) {
  switch (type.kind) {
    case Kind::tet4:
      return "tet4";
    case Kind::tet10:
      return "tet10";
    case Kind::hex:
      return "hex";
  }
  unknown_kind();
}

int node_count(Type type) {
  switch (type.kind) {
    case Kind::tet4:
      return Tet4::nodes;
    case Kind::tet10:
      return Tet10::nodes;
    case Kind::hex:
      return (type.plane + 1) * (type.plane + 1) * (type.thickness + 1);
  }
  unknown_kind();
}

Orders orders(Type type) {
  switch (type.kind) {
    case Kind::tet4:
      return {1, 1};
    case Kind::tet10:
      return {2, 2};
    case Kind::hex:
      return {type.plane, type.thickness};
  }
  unknown_kind();
}

bool has_choice_of_orders(Type type) {
  switch (type.kind) {
    case Kind::tet4:
    case Kind::tet10:
      return false;
    case Kind::hex:
      return true;
  }
  unknown_kind();
}

Type with_orders(Type type, Orders orders) {
  return has_choice_of_orders(type) ? hex(orders.plane, orders.thickness) : type;
}

int lines_through(Type type) {
  switch (type.kind) {
    case Kind::tet4:
    case Kind::tet10:
      return 0;
    case Kind::hex:
      return (type.plane + 1) * (type.plane + 1);
  }
  unknown_kind();
}

void unknown_kind() {
  throw std::logic_error("an element type of no known kind");
}

}  // namespace idiophone::element
