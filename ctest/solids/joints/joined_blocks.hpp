#pragma once
// Two blocks whose end faces a joint of any type ties together, of different elements that share no node.

#include <Eigen/Geometry>

#include "block_mesh.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/joints/joints.hpp"

namespace idiophone::joints {

/// Tetrahedra from x = 0 to 0.1 m, then a gap of 0.5 mm, then hexahedra; 0.03 m wide and 0.02 m high.
struct JoinedBlocks {
  explicit JoinedBlocks(MPI_Comm communicator = MPI_COMM_SELF, const scene::Joint& the_joint = joint_of("glue"))
      : joint(the_joint) {
    meshes.push_back(support::block_mesh(element::tet10, {0.1, 0.03, 0.02}, {2, 3, 2}));
    meshes.push_back(support::block_mesh(element::hex(4, 2), {0.1, 0.03, 0.02}, {2, 2, 1}));
    for (Vector3& node : meshes[1].nodes) {
      node.x() += 0.1 + gap;
    }
    scene.materials = {{"steel", 2e11, 0.3, 7850, {0, 0}, {}}};
    scene.bodies.resize(2);
    scene.joints = {joint};
    meshed = find_joints(scene, meshes);
    part = mesh::distribute(parallel::is_root(communicator) ? meshes : std::vector<mesh::Mesh>{}, communicator,
                            coupled_nodes(meshed));
    joints = std::make_unique<Joints>(meshed, part);
    state.resize(part.node_ids.size());
  }

  /// @param type  glue, bolt, stud: a bolt with a shank through both blocks, spring, hinge, or door: a hinge that
  /// resists
  ///              turning
  static scene::Joint joint_of(const std::string& type) {
    scene::Joint joint;
    joint.name = type;
    joint.surfaces = {scene::JoinedSurface{0, "x1", {}}, scene::JoinedSurface{1, "x0", {}}};
    joint.stiffness = {3e12, 1e12};
    joint.damping = relaxation;
    if (type == "bolt") {
      joint.type = scene::JointType::bolt;
      joint.place = scene::PatchPlace{{0.1, 0.015, 0.01}, 0.008, {}};
    } else if (type == "stud") {
      joint.type = scene::JointType::bolt;
      joint.surfaces = {scene::JoinedSurface{0, "x0", {}}, scene::JoinedSurface{1, "x1", {}}};
      joint.stiffness.reset();
      joint.axis = {{0.0, 0.016, 0.011}, {0.2 + gap, 0.016, 0.011}};
      joint.shank = {.radius = 0.004, .washer = 0.01, .young = 2e11, .poisson = 0.3, .preload = 5e4};
    } else if (type == "spring") {
      joint.type = scene::JointType::spring;
      joint.stiffness = {3e8, 1e8};
    } else if (type != "glue") {
      joint.type = scene::JointType::hinge;
      joint.axis = {{0.1, 0.005, 0.012}, {0.1, 0.025, 0.012}};
      joint.stiffness = {2e8, 2e8};
    }
    if (type == "door") {
      joint.turning = scene::HingeTurning{1e4, relaxation};
    }
    return joint;
  }
  static std::vector<scene::Joint> one_of_each() {
    return {joint_of("glue"),   joint_of("bolt"),  joint_of("stud"),
            joint_of("spring"), joint_of("hinge"), joint_of("door")};
  }

  /// A rotation about an axis through the origin, by an angle (rad), then strains that no two nodes share.
  void move(double angle, double strain) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vector3(1, 2, 3).normalized()).toRotationMatrix();
    for (std::size_t node = 0; node < state.size(); ++node) {
      const Vector3& place = part.reference[node];
      const double number = part.node_ids[node];
      const Vector3 bent = place + strain * Vector3(std::sin(number), std::cos(2 * number), std::sin(3 * number));
      Vector3::Map(state[node].displacement) = turn * bent - place;
    }
  }

  /// [local nodes] N
  [[nodiscard]] std::vector<solid::NodeForce> forces() const {
    std::vector<solid::NodeForce> force(state.size());
    joints->add_force(state, force);
    return force;
  }

  [[nodiscard]] double energy() const {
    ReproducibleSum sum;
    joints->add_energy(state, sum);
    return sum.value();
  }

  static constexpr double gap = 5e-4;         // m
  static constexpr double relaxation = 1e-6;  // s
  std::vector<mesh::Mesh> meshes;
  scene::Scene scene;
  scene::Joint joint;
  std::vector<MeshedJoint> meshed;
  mesh::Part part;
  std::unique_ptr<Joints> joints;
  std::vector<solid::NodeState> state;
};

}  // namespace idiophone::joints
