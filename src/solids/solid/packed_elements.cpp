#include "idiophone/solids/solid/packed_elements.hpp"

namespace idiophone::solid {

PackedElements pack_elements(const mesh::BodyPart& part, std::span<const Vector3> reference) {
  switch (part.element.kind) {
    case element::Kind::tet4:
      return PackedTetrahedra<element::Tet4>(part, reference);
    case element::Kind::tet10:
      return PackedTetrahedra<element::Tet10>(part, reference);
    case element::Kind::hex:
      return PackedHexahedra(part, reference);
  }
  element::unknown_kind();
}

}  // namespace idiophone::solid
