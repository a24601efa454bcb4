#pragma once
// Which faces of elements lie on a physical group of surfaces.

#include <set>
#include <string>
#include <vector>

#include "idiophone/solids/mesh/faces.hpp"

namespace idiophone::mesh {

class GroupFaces {
 public:
  /// @param mesh  must outlive this object
  /// @throws as find_group()
  GroupFaces(const Mesh& mesh, const std::string& group, const deck::Location& where);

  [[nodiscard]] bool has(const ElementFace& face) const;

 private:
  const Mesh& mesh_;
  std::vector<char> nodes_;       // [nodes] 1 where the group has it
  std::set<Triangle> triangles_;  // of linear tetrahedra, ascending corners
};

}  // namespace idiophone::mesh
