// Joints: what is joined, and the forces of a stretched layer.

#include "idiophone/solids/joints/joints.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>

#include "force_check.hpp"
#include "idiophone/solids/joints/covered_triangles.hpp"
#include "joined_blocks.hpp"
#include "ranks.hpp"

namespace idiophone::joints {
namespace {

using solid::NodeForce;

Vector3 vector(const double* components) {
  return Vector3(components);
}

/// The stiffness of all points about the state, [3 x nodes x 3 x nodes].
Eigen::MatrixXd whole_stiffness(const JoinedBlocks& blocks) {
  const auto size = 3 * static_cast<Eigen::Index>(blocks.state.size());
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t joint = 0; joint < blocks.joints->all().size(); ++joint) {
    blocks.joints->for_each_stiffness(
        joint, blocks.state, [&](std::span<const Index> nodes, const Eigen::MatrixXd& stiffness) {
          for (std::size_t a = 0; a < nodes.size(); ++a) {
            for (std::size_t b = 0; b < nodes.size(); ++b) {
              whole.block<3, 3>(3 * nodes[a], 3 * nodes[b]) +=
                  stiffness.block<3, 3>(3 * static_cast<Eigen::Index>(a), 3 * static_cast<Eigen::Index>(b));
            }
          }
        });
  }
  return whole;
}

/// One number for each component.
Eigen::VectorXd components(std::span<const NodeForce> forces) {
  Eigen::VectorXd all(3 * static_cast<Eigen::Index>(forces.size()));
  for (std::size_t node = 0; node < forces.size(); ++node) {
    all.segment<3>(3 * static_cast<Eigen::Index>(node)) = vector(forces[node].component);
  }
  return all;
}

Eigen::VectorXd wave(Eigen::Index size) {
  return Eigen::VectorXd::NullaryExpr(size, [](Eigen::Index c) { return std::sin(static_cast<double>(c * c)); });
}

/// Area of each block that the joint covers, m2.
std::vector<double> covered_areas(const JoinedBlocks& blocks) {
  const std::vector<char> covered = covered_triangles(blocks.scene, blocks.meshes);
  std::vector<double> areas;
  auto is_covered = covered.begin();
  for (const mesh::Mesh& mesh : blocks.meshes) {
    double& area = areas.emplace_back();
    for (const auto& [a, b, c] : mesh.surface) {
      const Vector3& corner = mesh.nodes[a];
      area += *is_covered++ * (mesh.nodes[b] - corner).cross(mesh.nodes[c] - corner).norm() / 2;
    }
  }
  return areas;
}

ON_RANKS(1);

TEST(Joints, JoinWholeSurfacesThatShareNoNode) {
  const JoinedBlocks blocks;
  EXPECT_NEAR(blocks.meshed[0].area(), 0.03 * 0.02, 1e-15);
  for (const JointPoint& point : blocks.meshed[0].points) {
    EXPECT_NEAR(point.distance, JoinedBlocks::gap, 1e-15);
  }
}

TEST(Joints, CoverTheTrianglesThatFaceEachOther) {
  JoinedBlocks blocks;
  for (const double area : covered_areas(blocks)) {
    EXPECT_NEAR(area, 0.03 * 0.02, 1e-15);
  }
  for (Vector3& node : blocks.meshes[1].nodes) {
    node.y() += 0.015;  // one of its two cells faces the other block
  }
  const std::vector<double> areas = covered_areas(blocks);
  EXPECT_NEAR(areas[0], 0.015 * 0.02, 1e-4);  // to the middle of a triangle
  EXPECT_NEAR(areas[1], 0.015 * 0.02, 1e-15);
}

TEST(Joints, RigidMotionStretchesNothing) {
  for (const scene::Joint& joint : JoinedBlocks::one_of_each()) {
    SCOPED_TRACE(joint.name);
    JoinedBlocks blocks(MPI_COMM_SELF, joint);
    blocks.move(2.0, 0.0);
    const double stiffness = whole_stiffness(blocks).maxCoeff();
    EXPECT_LT(support::largest_component(blocks.forces()), 1e-13 * stiffness);
  }
}

TEST(Joints, ForcesAreMinusTheGradientOfTheEnergy) {
  for (const scene::Joint& joint : JoinedBlocks::one_of_each()) {
    SCOPED_TRACE(joint.name);
    JoinedBlocks blocks(MPI_COMM_SELF, joint);
    blocks.move(2.0, 1e-4);
    support::expect_minus_gradient(blocks.state, blocks.forces(), [&] { return blocks.energy(); },
                                   {.stride = 1, .step = 1e-8, .tolerance = 1e-5});
  }
}

TEST(Joints, ForcesHaveNoResultantAndNoMoment) {
  for (const scene::Joint& joint : JoinedBlocks::one_of_each()) {
    SCOPED_TRACE(joint.name);
    JoinedBlocks blocks(MPI_COMM_SELF, joint);
    blocks.move(2.0, 1e-4);
    const std::vector<NodeForce> forces = blocks.forces();
    Vector3 resultant = Vector3::Zero();
    Vector3 moment = Vector3::Zero();
    for (std::size_t node = 0; node < forces.size(); ++node) {
      const Vector3 force = vector(forces[node].component);
      resultant += force;
      moment += (blocks.part.reference[node] + vector(blocks.state[node].displacement)).cross(force);
    }
    const double largest = support::largest_component(forces);
    EXPECT_LT(resultant.norm(), 1e-12 * largest);
    EXPECT_LT(moment.norm(), 1e-12 * largest * 0.2);  // the blocks are 0.2 m long
  }
}

TEST(Joints, StiffnessIsThatOfTheForces) {
  for (const scene::Joint& joint : JoinedBlocks::one_of_each()) {
    SCOPED_TRACE(joint.name);
    JoinedBlocks blocks(MPI_COMM_SELF, joint);
    const Eigen::MatrixXd stiffness = whole_stiffness(blocks);
    const Eigen::VectorXd moved = 1e-9 * wave(stiffness.rows());
    for (std::size_t node = 0; node < blocks.state.size(); ++node) {
      Vector3::Map(blocks.state[node].displacement) = moved.segment<3>(3 * static_cast<Eigen::Index>(node));
    }
    const Eigen::VectorXd expected = -stiffness * moved;
    EXPECT_LT((components(blocks.forces()) - expected).norm(), 1e-5 * expected.norm());
  }
}

TEST(Joints, StiffnessAboutADeformedStateIsThatOfTheForces) {
  for (const scene::Joint& joint : JoinedBlocks::one_of_each()) {
    SCOPED_TRACE(joint.name);
    JoinedBlocks blocks(MPI_COMM_SELF, joint);
    blocks.move(2.0, 1e-3);
    const Eigen::MatrixXd stiffness = whole_stiffness(blocks);
    const Eigen::VectorXd moved = 1e-7 * wave(stiffness.rows());
    const auto forces_after = [&](double factor) {
      for (std::size_t node = 0; node < blocks.state.size(); ++node) {
        Vector3::Map(blocks.state[node].displacement) += factor * moved.segment<3>(3 * static_cast<Eigen::Index>(node));
      }
      return components(blocks.forces());
    };
    const Eigen::VectorXd ahead = forces_after(1.0), behind = forces_after(-2.0);
    const Eigen::VectorXd expected = -2 * stiffness * moved;
    EXPECT_LT((ahead - behind - expected).norm(), 1e-6 * expected.norm());
    EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-12 * stiffness.norm());
  }
}

TEST(Joints, DampingIsStiffnessTimesTheRelaxationTime) {
  for (const scene::Joint& joint : JoinedBlocks::one_of_each()) {
    SCOPED_TRACE(joint.name);
    JoinedBlocks blocks(MPI_COMM_SELF, joint);
    const Eigen::MatrixXd stiffness = whole_stiffness(blocks);
    const Eigen::VectorXd rate = wave(stiffness.rows());
    for (std::size_t node = 0; node < blocks.state.size(); ++node) {
      Vector3::Map(blocks.state[node].velocity) = rate.segment<3>(3 * static_cast<Eigen::Index>(node));
    }
    const Eigen::VectorXd expected = -JoinedBlocks::relaxation * stiffness * rate;
    const double largest = JoinedBlocks::relaxation * stiffness.norm() * rate.norm();  // forces that cancel
    const double rounding = std::max(1e-9 * expected.norm(), 1e-12 * largest);
    EXPECT_LT((components(blocks.forces()) - expected).norm(), rounding);
  }
}

TEST(Joints, BoundsAreStiffer) {
  for (const scene::Joint& joint : JoinedBlocks::one_of_each()) {
    SCOPED_TRACE(joint.name);
    const JoinedBlocks blocks(MPI_COMM_SELF, joint);
    const Eigen::MatrixXd stiffness = whole_stiffness(blocks);
    std::vector<double> bound(blocks.state.size());
    std::vector<double> damping(blocks.state.size());
    blocks.joints->add_bounds(bound, damping);
    Eigen::MatrixXd difference = -stiffness;
    for (std::size_t node = 0; node < bound.size(); ++node) {
      difference.diagonal().segment<3>(3 * static_cast<Eigen::Index>(node)).array() += bound[node];
      EXPECT_NEAR(damping[node], JoinedBlocks::relaxation * bound[node], 1e-18 * bound[node]);
    }
    const Eigen::VectorXd pivots = difference.ldlt().vectorD();  // as many below zero as eigenvalues
    EXPECT_GT(pivots.minCoeff(), -1e-12 * pivots.maxCoeff());
  }
}

TEST(Joints, RefuseWhatTheyCannotJoin) {
  const auto refusal = [](const std::string& group, double reach) -> std::string {
    JoinedBlocks blocks;
    blocks.scene.joints[0].surfaces[0].group = group;
    blocks.scene.joints[0].reach = reach;
    try {
      (void)find_joints(blocks.scene, blocks.meshes);
    } catch (const deck::DeckError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal("x1", 0.002), "");
  EXPECT_THAT(refusal("end", 0.002), testing::HasSubstr("the mesh has no group 'end'"));
  EXPECT_THAT(refusal("x1", 0.0002), testing::HasSubstr("joints.glue: no part of the two surfaces faces the other "
                                                        "within 0.0002 m"));
  EXPECT_THAT(refusal("x0", 0.002), testing::HasSubstr("no part of the two surfaces"));  // they turn away
}

ON_RANKS(1, 3);

TEST(Joints, ForcesHaveTheSameBitsOnAnyNumberOfRanks) {
  for (const scene::Joint& joint : JoinedBlocks::one_of_each()) {
    SCOPED_TRACE(joint.name);
    JoinedBlocks shared(MPI_COMM_WORLD, joint);
    JoinedBlocks alone(MPI_COMM_SELF, joint);
    shared.move(0.5, 1e-5);
    alone.move(0.5, 1e-5);
    const std::vector<NodeForce> forces = shared.forces();
    const std::vector<NodeForce> expected = alone.forces();
    for (Index node = 0; node < shared.part.owned_nodes; ++node) {
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(forces[node].component[axis], expected[shared.part.node_ids[node]].component[axis]);
      }
    }
  }
}

TEST(Joints, RanksShareTheEnergy) {
  for (const scene::Joint& joint : JoinedBlocks::one_of_each()) {
    SCOPED_TRACE(joint.name);
    JoinedBlocks shared(MPI_COMM_WORLD, joint);
    JoinedBlocks alone(MPI_COMM_SELF, joint);
    shared.move(0.5, 1e-5);
    alone.move(0.5, 1e-5);
    double energy = shared.energy();
    MPI_Allreduce(MPI_IN_PLACE, &energy, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    EXPECT_NEAR(energy, alone.energy(), 1e-14 * alone.energy());
  }
}

}  // namespace
}  // namespace idiophone::joints
