#pragma once
// Bodies that joints tie together, for tests of modes.

#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/joints/meshed_joint.hpp"

namespace idiophone::eigenmodes {

/// Blocks of steel, and joints between them. Add blocks and joints, then find().
struct Assembly {
  Assembly() { scene.materials = {{"steel", 2e11, 0.3, 7850, {0, 0}, {}}}; }

  void add(mesh::Mesh block, const Vector3& shift) {
    for (Vector3& node : block.nodes) {
      node += shift;
    }
    scene::Body& body = scene.bodies.emplace_back();
    body.name = "block";
    body.element = block.element;
    meshes.push_back(std::move(block));
  }

  /// The first body to the second one.
  void join(const std::string& first, const std::string& second, std::optional<scene::JointStiffness> stiffness,
            double damping = 0.0) {
    scene::Joint& joint = scene.joints.emplace_back();
    joint.name = "joint";
    joint.surfaces = {scene::JoinedSurface{0, first, {}}, scene::JoinedSurface{1, second, {}}};
    joint.stiffness = stiffness;
    joint.damping = damping;
  }

  [[nodiscard]] Modes find(int count, MPI_Comm communicator = MPI_COMM_WORLD) const {
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    const motion::Attachments attachments =
        motion::broadcast(rank == 0 ? motion::attach(scene, meshes) : motion::Attachments{}, scene, communicator);
    const mesh::Part part = mesh::distribute(meshes, communicator, joints::coupled_nodes(attachments.joints));
    return find_modes(scene, part, attachments, {.count = count}, communicator);
  }

  std::vector<mesh::Mesh> meshes;
  scene::Scene scene;
};

}  // namespace idiophone::eigenmodes
