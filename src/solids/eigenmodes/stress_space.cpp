#include "stress_space.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <span>
#include <stdexcept>

#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/solids/mesh/faces.hpp"
#include "idiophone/solids/mesh/refined.hpp"

namespace idiophone::eigenmodes {

namespace {

std::vector<mesh::ElementFace> outer_faces(const mesh::Mesh& mesh) {
  std::vector<mesh::ElementFace> outer;
  mesh::for_each_shared_face(mesh, [&](std::span<const mesh::ElementFace> sharing) {
    if (sharing.size() == 1) {
      outer.push_back(sharing.front());
    }
  });
  return outer;
}

/// Unit normals of a face of an element at places of the reference element.
/// @param face  of the reference element
std::vector<Vector3> normals(const mesh::Mesh& mesh, Index element, const element::Face& face,
                             const std::vector<Vector3>& places) {
  const auto nodes = mesh.element_nodes(element);
  const element::ReferenceElement& reference = element::reference(mesh.element);
  Vector3 middle = Vector3::Zero();  // of the face: the outward unit vector in the reference cube
  for (const int corner : face.corners) {
    middle += reference.nodes[corner] / static_cast<double>(face.corners.size());
  }
  std::vector<Vector3> result;
  for (const Vector3& place : places) {
    const Eigen::MatrixX3d gradients = element::shape_gradients(mesh.element, place);
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      jacobian += mesh.nodes[nodes[a]] * gradients.row(static_cast<Eigen::Index>(a));
    }
    result.push_back((jacobian.inverse().transpose() * middle).normalized());
  }
  return result;
}

void require_flat(const std::vector<Vector3>& normals) {
  constexpr double rounding = 1e-7;
  for (const Vector3& normal : normals) {
    if ((normal - normals.front()).norm() > rounding) {
      throw std::runtime_error(
          "--bounds needs flat free faces, and this body has a curved one: its stress can't be made free of traction "
          "there. Use the estimated error of the mesh (--estimate)");
    }
  }
}

}  // namespace

StressSpace::StressSpace(const mesh::Mesh& mesh, const std::vector<bool>& held) : refined_(mesh::refined(mesh).mesh) {
  const element::ReferenceElement& given = element::reference(mesh.element);
  const element::ReferenceElement& refined = element::reference(refined_.element);
  std::vector<dense::Matrix6> conditions(refined_.nodes.size(), dense::Matrix6::Zero());  // sum of squares of tractions
  std::vector<bool> on_held_face(held.size());
  for (const auto& [corners, element, side] : outer_faces(mesh)) {
    std::vector<Vector3> places;
    for (const int node : refined.faces[side].nodes) {
      places.push_back(refined.nodes[node]);
    }
    const std::vector<Vector3> normal = normals(mesh, element, given.faces[side], places);
    for (int axis = 0; axis < 3; ++axis) {
      const auto component = [axis, of_element = mesh.element_nodes(element)](int node) {
        return 3 * of_element[node] + axis;
      };
      const auto& nodes = given.faces[side].nodes;
      if (std::ranges::all_of(nodes, [&](int node) { return held[component(node)]; })) {
        std::ranges::for_each(nodes, [&](int node) { on_held_face[component(node)] = true; });
        continue;
      }
      require_flat(normal);
      for (std::size_t a = 0; a < places.size(); ++a) {
        dense::Vector6 traction = dense::Vector6::Zero();
        for (int k = 0; k < 3; ++k) {
          traction[stress_component(axis, k)] = normal[a][k];
        }
        const Index node = element_nodes(element)[refined.faces[side].nodes[a]];
        conditions[node] += traction * traction.transpose();
      }
    }
  }
  if (on_held_face != held) {
    throw std::runtime_error(
        "--bounds needs supports that hold whole faces of elements: an elastic solid can't be held at points or lines");
  }
  first_.push_back(0);
  for (const dense::Matrix6& condition : conditions) {
    const auto [values, vectors] = dense::eigenpairs(condition);
    const NodeBasis basis{.vectors = vectors, .count = (values.array() < 1e-9).count()};  // values ascend
    bases_.push_back(basis);
    first_.push_back(first_.back() + static_cast<PetscInt>(basis.count));
  }
}

}  // namespace idiophone::eigenmodes
