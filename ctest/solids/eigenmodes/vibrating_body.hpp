#pragma once
// A scene of one body on all ranks, or on each alone, for tests of modes.

#include <gtest/gtest.h>

#include "block_mesh.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/motion/dynamics.hpp"

namespace idiophone::eigenmodes {

/// Fill in the scene, then find().
struct VibratingBody {
  explicit VibratingBody(mesh::Mesh whole) : mesh(std::move(whole)) {
    scene.materials = {{"steel", 2e11, 0.3, 7850, {0, 0}, {}}};
    scene.bodies.resize(1);
    scene.bodies[0].name = "block";
    scene.bodies[0].element = mesh.element;
  }

  void fix(const std::string& group, const scene::Axes& axes = {true, true, true}) {
    scene.bodies[0].fixed.push_back({.group = group, .axes = axes, .hinge = false, .where = {}});
  }

  Modes find(const Options& options, MPI_Comm communicator = MPI_COMM_WORLD) {
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    const std::vector meshes = {mesh};
    attachments =
        motion::broadcast(rank == 0 ? motion::attach(scene, meshes) : motion::Attachments{}, scene, communicator);
    part = mesh::distribute(meshes, communicator);
    return find_modes(scene, part, attachments, options, communicator);
  }

  /// What find() throws; "" when nothing.
  std::string refusal(const Options& options) {
    try {
      (void)find(options);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }

  mesh::Mesh mesh;
  scene::Scene scene;
  motion::Attachments attachments;
  mesh::Part part;
};

inline VibratingBody block(element::Type element, const Vector3& size, const std::array<int, 3>& cells) {
  return VibratingBody(support::block_mesh(element, size, cells));
}

/// Steel, 500 x 20 x 10 mm, elements of 20 mm.
inline VibratingBody bar() {
  return block(element::tet10, {0.5, 0.02, 0.01}, {25, 1, 1});
}

}  // namespace idiophone::eigenmodes
