#pragma once
// The two surfaces of a joint: their faces, and which points of one face the other.

#include <optional>
#include <string>
#include <vector>

#include "idiophone/scene/joint_section.hpp"
#include "surface_face.hpp"

namespace idiophone::joints {

using Faces = std::vector<SurfaceFace>;

/// The faces of a surface that a joint names.
/// @param joint  its name, for messages
/// @throws deck::DeckError where the group has no face on the outside of the body
[[nodiscard]] std::vector<mesh::ElementFace> element_faces_of(const scene::JoinedSurface& surface,
                                                              const std::string& joint, const mesh::Mesh& mesh);

/// The same as curved faces.
/// @param first_node  global number of the first node of the mesh
[[nodiscard]] Faces faces_of(const scene::JoinedSurface& surface, const std::string& joint, const mesh::Mesh& mesh,
                             Index first_node);

/// The root of the mean area, m.
[[nodiscard]] double mean_width(const Faces& faces);

/// Up to which distance the two surfaces of a joint are joined, m.
[[nodiscard]] double reach_of(const scene::Joint& joint, const Faces& one, const Faces& other);

/// One surface, as the points of the other one see it.
class FacingSurface {
 public:
  /// @param faces  must outlive this object
  /// @param reach  up to which distance points are joined, m
  FacingSurface(const Faces& faces, double reach) : faces_(faces), reach_(reach) {}

  [[nodiscard]] double reach() const { return reach_; }

  /// The faces that points within a sphere may face.
  /// @param radius  of the sphere, m
  [[nodiscard]] std::vector<const SurfaceFace*> close_to(const Vector3& centre, double radius) const;

  struct Partner {
    const SurfaceFace* face;
    SurfaceFace::Crossing crossing;
  };
  /// The nearest point of some faces that lies on a normal within the reach and faces it. Of equally near ones, the
  /// first.
  [[nodiscard]] std::optional<Partner> partner_of(const Vector3& position, const Vector3& normal,
                                                  const std::vector<const SurfaceFace*>& faces) const;

 private:
  const Faces& faces_;
  double reach_;
};

}  // namespace idiophone::joints
