// Bodies that a joint ties together, in motion.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "block_mesh.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/motion/body_motion.hpp"
#include "idiophone/solids/motion/measure.hpp"
#include "idiophone/solids/motion/motion.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

scene::Joint glue(const scene::JointStiffness& layer, double damping = 0.0) {
  scene::Joint joint;
  joint.stiffness = layer;
  joint.damping = damping;
  return joint;
}

constexpr scene::JointStiffness soft = {3e7, 1e7};     // the blocks limit the step
constexpr scene::JointStiffness stiff = {3e10, 1e10};  // the joint limits it

scene::Joint spring() {
  scene::Joint joint;
  joint.type = scene::JointType::spring;
  joint.stiffness = {2000, 1000};  // N/m
  return joint;
}

/// It turns about a line across both blocks.
/// @param stiffness  none: rigid
scene::Joint door(std::optional<scene::JointStiffness> stiffness, double damping = 0.0) {
  scene::Joint joint;
  joint.type = scene::JointType::hinge;
  joint.axis = {{0.1005, 0.005, 0.01}, {0.1005, 0.025, 0.01}};
  joint.stiffness = stiffness;
  joint.turning = scene::HingeTurning{0.5, damping};
  return joint;
}

/// A bolt of the blocks' own material that is screwed into both ends.
scene::Joint bolt() {
  scene::Joint joint;
  joint.type = scene::JointType::bolt;
  joint.axis = {{0.1, 0.015, 0.01}, {0.101, 0.015, 0.01}};
  joint.shank = {.radius = 0.002, .washer = 0.02, .young = 1e6, .poisson = 0.3, .preload = 0.2};
  return joint;
}

/// Two blocks of rubber that fly, tumble and vibrate, joined at their ends, 1 mm apart; meshes that do not match.
struct JoinedBlocks {
  explicit JoinedBlocks(scene::Joint joint) {
    meshes.push_back(support::block_mesh(element::tet10, {0.1, 0.03, 0.02}, {2, 2, 1}));
    meshes.push_back(support::block_mesh(element::hex(2, 2), {0.1, 0.03, 0.02}, {2, 1, 1}));
    for (Vector3& node : meshes[1].nodes) {
      node.x() += 0.101;
    }
    scene.materials = {{"rubber", 1e6, 0.3, 1000, {0, 0}, {}}};
    scene.bodies.resize(2);
    for (scene::Body& body : scene.bodies) {
      body.velocity = {1, 2, 3};
      body.spin = {10, 20, 30};  // each about its own centre: the joint has to pull them along
    }
    joint.surfaces = {scene::JoinedSurface{0, "x1", {}}, scene::JoinedSurface{1, "x0", {}}};
    scene.joints = {joint};
    attachments = attach(scene, meshes);
    part = mesh::distribute(meshes, MPI_COMM_SELF);
  }

  void begin(double step) {
    motion = std::make_unique<Motion>(scene, part, attachments, contact::ContactSurfaces{}, step, 16, MPI_COMM_SELF);
    initial_state = mass_properties(motion->dynamics(), part);
    motion->start(initial_state.centres, {});
  }

  [[nodiscard]] double energy() const {
    ReproducibleSum sum;
    motion->dynamics().joints().add_energy(motion->state(), sum);
    double total = sum.value();
    for (std::size_t b = 0; b < 2; ++b) {
      const BodyMotion body = body_motion(measure(*motion, initial_state)[b], initial_state, b);
      total += body.kinetic + body.elastic;
    }
    return total;
  }

  struct Momenta {
    Vector3 linear = Vector3::Zero();
    Vector3 angular = Vector3::Zero();  ///< about the origin
  };
  [[nodiscard]] Momenta momenta() const {
    Momenta sum;
    for (std::size_t b = 0; b < 2; ++b) {
      const std::span<const double> masses = motion->dynamics().model(b).masses();
      for (std::size_t n = 0; n < masses.size(); ++n) {
        const std::size_t node = part.bodies[b].owned_begin + n;
        const NodeState& state = motion->state()[node];
        const Vector3 velocity(state.velocity);
        const Vector3 place = part.reference[node] + Vector3(state.displacement);
        sum.linear += masses[n] * velocity;
        sum.angular += masses[n] * place.cross(velocity);
      }
    }
    return sum;
  }

  std::vector<mesh::Mesh> meshes;
  scene::Scene scene;
  Attachments attachments;
  mesh::Part part;
  InitialState initial_state;
  std::unique_ptr<Motion> motion;
};

double stable_step_of(const JoinedBlocks& blocks) {
  const FiniteElementDynamics dynamics(blocks.scene, blocks.part, blocks.attachments);
  double step = 1.0;
  for (const StableStep& body : find_stable_steps(blocks.part, dynamics)) {
    step = std::min(step, body.step);
  }
  return step;
}

/// The largest change of the energy in 0.05 s, in parts of it; infinity where the motion is not finite.
double largest_drift(const scene::Joint& joint, double step) {
  JoinedBlocks blocks(joint);
  blocks.begin(step);
  const double before = blocks.energy();
  double largest = 0.0;
  for (int n = 0; n * step < 0.05; ++n) {
    blocks.motion->advance();
    if (n % 16 == 0) {
      const double drift = std::abs(blocks.energy() / before - 1);
      largest = std::isfinite(drift) ? std::max(largest, drift) : std::numeric_limits<double>::infinity();
    }
  }
  return largest;
}

ON_RANKS(1);

TEST(JoinedMotion, KeepsMomentumAndAngularMomentum) {
  // The damping of a door, too, although it turns far.
  for (const scene::Joint& joint : {glue(soft), spring(), door({{2000, 2000}}, 1e-3), bolt()}) {
    JoinedBlocks blocks(joint);
    blocks.begin(0.9 * stable_step_of(blocks));
    const JoinedBlocks::Momenta before = blocks.momenta();
    for (int step = 0; step < 1000; ++step) {
      blocks.motion->advance();
    }
    const JoinedBlocks::Momenta after = blocks.momenta();
    EXPECT_LT((after.linear - before.linear).norm(), 1e-12 * before.linear.norm());
    EXPECT_LT((after.angular - before.angular).norm(), 1e-10 * before.angular.norm());
  }
}

TEST(JoinedMotion, KeepsItsEnergyToSecondOrderOfTheStep) {
  for (const scene::Joint& joint : {glue(soft), spring(), door({{2000, 2000}}), bolt()}) {
    JoinedBlocks blocks(joint);
    const double step = 0.5 * stable_step_of(blocks);
    const double coarse = largest_drift(joint, step);
    const double fine = largest_drift(joint, step / 2);
    EXPECT_LT(coarse, 1e-2);
    EXPECT_NEAR(coarse / fine, 4, 1);
  }
}

TEST(JoinedMotion, IsStableUpToTheStepThatIsPredicted) {
  const double step = stable_step_of(JoinedBlocks(glue(stiff)));
  EXPECT_LT(step, 0.2 * stable_step_of(JoinedBlocks(glue(soft))));
  EXPECT_LT(largest_drift(glue(stiff), 0.98 * step), 0.1);
  EXPECT_GT(largest_drift(glue(stiff), 2.0 * step), 0.1);  // nor is it much too short
}

TEST(JoinedMotion, IsStableWithARigidHingeOrAStiffBolt) {
  scene::Joint steel = bolt();
  steel.shank->young = 1e10;
  for (const scene::Joint& joint : {door(std::nullopt), steel}) {
    const double step = stable_step_of(JoinedBlocks(joint));
    EXPECT_LT(largest_drift(joint, 0.98 * step), 0.1);
  }
}

TEST(JoinedMotion, LosesEnergyByDamping) {
  for (const scene::Joint& joint : {glue(soft, 1e-4), door({{2000, 2000}}, 1e-3)}) {
    JoinedBlocks blocks(joint);
    blocks.begin(0.5 * stable_step_of(blocks));
    double before = blocks.energy();
    for (int n = 0; n < 20; ++n) {
      for (int step = 0; step < 50; ++step) {
        blocks.motion->advance();
      }
      const double now = blocks.energy();
      EXPECT_LT(now, before * (1 + 1e-4));
      before = now;
    }
  }
}

}  // namespace
}  // namespace idiophone::motion
