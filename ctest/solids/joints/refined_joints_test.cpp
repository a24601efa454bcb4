// Joints between refined meshes, which hold the same parts of the bodies and stretch alike.

#include "idiophone/solids/joints/refined_joints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "joined_blocks.hpp"
#include "ranks.hpp"

namespace idiophone::joints {
namespace {

/// The blocks of JoinedBlocks, refined.
struct RefinedBlocks {
  explicit RefinedBlocks(const JoinedBlocks& given) {
    std::ranges::transform(given.meshes, std::back_inserter(refined_meshes), mesh::refined);
    held = refined(held_parts(given.scene, given.meshes), given.scene, given.meshes, refined_meshes);
    std::ranges::transform(refined_meshes, std::back_inserter(meshes), &mesh::RefinedMesh::mesh);
    joints = find_joints(given.scene, meshes, held);
    act_as(given.meshed, given.scene, given.meshes, refined_meshes, joints);
    part = mesh::distribute(meshes, MPI_COMM_SELF, coupled_nodes(joints));
  }

  /// J, where the nodes move as those of the given blocks.
  [[nodiscard]] double energy_under_motion_of(const JoinedBlocks& given) const {
    std::vector<solid::NodeState> state(part.node_ids.size());
    std::size_t node = 0;
    for (std::size_t b = 0; b < meshes.size(); ++b) {
      for (const std::vector<mesh::Parent>& parents : refined_meshes[b].parents) {
        for (const mesh::Parent& parent : parents) {
          const auto& moved = given.state[given.part.bodies[b].owned_begin + parent.node].displacement;
          for (std::size_t i = 0; i < 3; ++i) {
            state[node].displacement[i] += parent.weight * moved[i];
          }
        }
        ++node;
      }
    }
    ReproducibleSum sum;
    Joints(joints, part).add_energy(state, sum);
    return sum.value();
  }

  std::vector<mesh::RefinedMesh> refined_meshes;
  std::vector<mesh::Mesh> meshes;
  HeldParts held;
  std::vector<MeshedJoint> joints;
  mesh::Part part;
};

ON_RANKS(1);

TEST(RefinedJoints, HoldAllPiecesOfTheElementsAndFaces) {
  const JoinedBlocks blocks(MPI_COMM_SELF, JoinedBlocks::joint_of("spring"));
  const auto [tetrahedra, hexahedra] = held_parts(blocks.scene, blocks.meshes).front();
  const RefinedBlocks refined(blocks);
  EXPECT_EQ(refined.held.front()[0].elements.size(), 8 * tetrahedra.elements.size());
  EXPECT_EQ(refined.held.front()[0].faces.size(), 4 * tetrahedra.faces.size());
  EXPECT_EQ(refined.held.front()[1].elements, hexahedra.elements);
  EXPECT_EQ(refined.held.front()[1].faces.size(), hexahedra.faces.size());
  for (const mesh::ElementFace& face : refined.held.front()[0].faces) {
    for (std::size_t corner = 1; corner < 4; ++corner) {
      EXPECT_NEAR(refined.meshes[0].nodes[face.corners[corner]].x(), 0.1, 1e-12);
    }
  }
}

TEST(RefinedJoints, HaveTheSameEnergyUnderEachMotionOfTheGivenMeshes) {
  for (const char* type : {"stud", "spring", "hinge", "door"}) {
    JoinedBlocks blocks(MPI_COMM_SELF, JoinedBlocks::joint_of(type));
    blocks.move(0.3, 1e-4);
    const double energy = blocks.energy();
    EXPECT_NEAR(RefinedBlocks(blocks).energy_under_motion_of(blocks), energy, 1e-9 * energy) << type;
  }
}

TEST(RefinedJoints, OfVeryManyNodesAreRefused) {
  scene::Joint spring = JoinedBlocks::joint_of("spring");
  JoinedBlocks blocks(MPI_COMM_SELF, spring);
  blocks.meshes[0] = support::block_mesh(element::tet10, {0.1, 0.03, 0.02}, {2, 8, 6});
  const std::vector<mesh::RefinedMesh> refined_meshes = {mesh::refined(blocks.meshes[0]),
                                                         mesh::refined(blocks.meshes[1])};
  try {
    (void)refined(held_parts(blocks.scene, blocks.meshes), blocks.scene, blocks.meshes, refined_meshes);
    ADD_FAILURE() << "no refusal";
  } catch (const deck::DeckError& error) {
    EXPECT_NE(std::string(error.what()).find("at most 2000 are possible: name a smaller surface"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace idiophone::joints
