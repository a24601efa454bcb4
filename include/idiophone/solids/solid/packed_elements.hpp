#pragma once
// One body's elements on this rank in packs, whatever their type.

#include <span>
#include <variant>

#include "idiophone/solids/solid/element_packs.hpp"
#include "idiophone/solids/solid/packed_hexahedra.hpp"
#include "idiophone/solids/solid/packed_tetrahedra.hpp"

namespace idiophone::solid {

using PackedElements = std::variant<PackedTetrahedra<element::Tet4>, PackedTetrahedra<element::Tet10>, PackedHexahedra>;
static_assert(ElementPacks<PackedTetrahedra<element::Tet4>> && ElementPacks<PackedTetrahedra<element::Tet10>> &&
              ElementPacks<PackedHexahedra>);

/// @param part       which elements; nodes are local numbers
/// @param reference  [local nodes] positions X, m
/// @throws std::runtime_error naming the element whose Jacobian is not positive at a quadrature point
[[nodiscard]] PackedElements pack_elements(const mesh::BodyPart& part, std::span<const Vector3> reference);

}  // namespace idiophone::solid
