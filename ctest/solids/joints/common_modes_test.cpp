// Joined bodies with large amplitudes, which have the modes of their assembly in common.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "assembly.hpp"
#include "block_mesh.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/solids/eigenmodes/compute_modal_basis.hpp"
#include "idiophone/solids/modal_bodies/modal_models.hpp"
#include "idiophone/solids/motion/body_motion.hpp"
#include "idiophone/solids/motion/motion.hpp"
#include "idiophone/solids/motion/stable_step.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

constexpr scene::JointStiffness stiff{1e14, 4e13};
constexpr scene::JointStiffness soft{7e11, 3e11};  // stretches as much as both strips

/// Two strips of steel end to end, 280 x 10 x 1 mm together, glued and held at their outer ends, with large amplitudes.
/// @param modes  of each strip; 0: finite elements
Assembly glued_strips(int modes, const scene::JointStiffness& glue = stiff) {
  Assembly strips;
  strips.add(support::block_mesh(element::hex(4, 2), {0.12, 0.01, 0.001}, {4, 1, 1}), Vector3::Zero());
  strips.add(support::block_mesh(element::hex(4, 2), {0.16, 0.01, 0.001}, {5, 2, 1}), {0.12, 0, 0});
  strips.join("x1", "x0", glue);
  strips.scene.bodies[0].fixed.push_back({.group = "x0", .axes = {true, true, true}, .hinge = false, .where = {}});
  strips.scene.bodies[1].fixed.push_back({.group = "x1", .axes = {true, true, true}, .hinge = false, .where = {}});
  for (scene::Body& body : strips.scene.bodies) {
    if (modes > 0) {
      body.modal = {.up_to = {}, .count = modes, .where = {"deck.yaml", 3, 5}};
      body.modal->stretching_tolerance = 0.001;
    }
  }
  return strips;
}

modal_bodies::ModalBases bases_of_strips(const Assembly& strips) {
  modal_bodies::ModalBases bases;
  if (strips.scene.bodies.front().modal) {
    auto found = common_bases(strips.scene, {0, 1}, strips.meshes, std::vector<std::vector<Index>>(2));
    bases[0] = std::move(found[0]);
    bases[1] = std::move(found[1]);
  }
  return bases;
}

/// A blow at the joint bends the strips by about three times their thickness.
class HitStrips {
 public:
  static constexpr double blow = 1e-3;  // s

  /// @param modes  of each strip; 0: finite elements
  explicit HitStrips(int modes, const scene::JointStiffness& glue = stiff) : strips_(glued_strips(modes, glue)) {
    scene::ForcePulse pulse;
    pulse.body = 1;
    pulse.force = {0, 0, 60};
    pulse.signal.duration = blow;
    strips_.scene.pulses = {pulse};
    bases_ = bases_of_strips(strips_);
    scene::Scene joined = strips_.scene;
    joined.pulses.clear();
    attachments_ = motion::attach(joined, strips_.meshes);
    std::vector<Index> nodes = strips_.meshes[1].groups.at("x0");
    for (Index& node : nodes) {
      node += static_cast<Index>(strips_.meshes[0].nodes.size());
    }
    attachments_.pulses = {{nodes, std::vector(nodes.size(), 1.0 / static_cast<double>(nodes.size()))}};
    part_ = mesh::distribute(strips_.meshes, MPI_COMM_SELF);
    models_ = modal_bodies::modal_models(strips_.scene, bases_);
  }

  /// s
  [[nodiscard]] double stable_step() const { return eigenmodes::stable_step(strips_, part_, attachments_, models_); }

  /// @param step  s
  void begin(double step) {
    motion_ = std::make_unique<motion::Motion>(strips_.scene, part_, attachments_, contact::ContactSurfaces{}, step, 16,
                                               MPI_COMM_SELF, models_, 16);
    initial_state_ = motion::mass_properties(motion_->dynamics(), part_);
    motion_->start(initial_state_.centres, {});
  }

  /// Of the joint, m, by one of its two sides.
  [[nodiscard]] double height(std::size_t body) {
    motion_->update_nodes();
    const auto& nodes = strips_.meshes[body].groups.at(body == 0 ? "x1" : "x0");
    double sum = 0.0;
    for (const Index node : nodes) {
      sum += motion_->state()[part_.bodies[body].owned_begin + node].displacement[2];
    }
    return sum / static_cast<double>(nodes.size());
  }

  /// Of both strips and what acts between them, J.
  [[nodiscard]] double energy() {
    ReproducibleSum sum;
    motion_->dynamics().acting_joints().add_energy(motion_->state(), sum);
    const auto sums = motion::measure(*motion_, initial_state_);
    double total = sum.value();
    for (std::size_t body = 0; body < 2; ++body) {
      const motion::BodyMotion found = motion::body_motion(sums[body], initial_state_, body);
      total += found.kinetic + found.elastic;
    }
    return total;
  }

  [[nodiscard]] motion::Motion& motion() { return *motion_; }

 private:
  Assembly strips_;
  modal_bodies::ModalBases bases_;
  motion::Attachments attachments_;
  mesh::Part part_;
  motion::ModelMaker models_;
  motion::InitialState initial_state_;
  std::unique_ptr<motion::Motion> motion_;
};

/// Heights of the joint at ten times in 5 ms, m.
std::vector<double> path(int modes, const scene::JointStiffness& glue) {
  HitStrips strips(modes, glue);
  constexpr double interval = 5e-4;  // s
  const int steps = static_cast<int>(std::ceil(interval / (0.8 * strips.stable_step())));
  strips.begin(interval / steps);
  std::vector<double> heights;
  for (int place = 1; place <= 10; ++place) {
    strips.motion().advance_to(std::int64_t{place} * steps);
    heights.push_back(strips.height(1));
  }
  return heights;
}

/// The energy of stretching where two of the three lowest modes have an amplitude of 1, sum over both signs and all
/// pairs, J. The bodies are flat.
double energy_of_pairs(const Assembly& strips) {
  const motion::Attachments attachments = motion::attach(strips.scene, strips.meshes);
  const mesh::Part part = mesh::distribute(strips.meshes, MPI_COMM_SELF);
  const Modes found = find_modes(strips.scene, part, attachments, {.count = 6}, MPI_COMM_SELF);
  const modal_bodies::Stretching stretching = stretching_of(found, strips.scene, part, attachments, 1e-5);
  const auto modes = std::ssize(found.modes);
  double energy = 0.0;
  for (std::size_t term = 0; term < stretching.terms(); ++term) {
    const Eigen::Map<const Eigen::MatrixXd> h(&stretching.quadratic[term * found.modes.size() * found.modes.size()],
                                              modes, modes);
    for (const auto& [i, j] : {std::pair(0, 1), {0, 2}, {1, 2}}) {
      for (const int sign : {1, -1}) {
        const double z = h(i, i) + h(j, j) + 2 * sign * h(i, j);
        energy += z * z / 2;
      }
    }
  }
  return energy;
}

ON_RANKS(1);

TEST(CommonModes, StretchAsABodyOfOnePiece) {
  Assembly whole;
  whole.add(support::block_mesh(element::hex(4, 2), {0.28, 0.01, 0.001}, {9, 1, 1}), Vector3::Zero());
  for (const char* end : {"x0", "x1"}) {
    whole.scene.bodies[0].fixed.push_back({.group = end, .axes = {true, true, true}, .hinge = false, .where = {}});
  }
  EXPECT_NEAR(energy_of_pairs(glued_strips(0)) / energy_of_pairs(whole), 1.0, 0.01);
}

TEST(CommonModes, MoveAsFiniteElementsByLargeAmplitudes) {
  for (const scene::JointStiffness& glue : {stiff, soft}) {
    const std::vector<double> expected = path(0, glue), found = path(10, glue);
    const double largest = *std::ranges::max_element(expected);
    EXPECT_GT(largest, 2.5e-3);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(found[i], expected[i], 0.02 * largest) << glue.normal;
    }
  }
}

/// Their steps resolve their own residual flexibility only, not the joint.
TEST(CommonModes, TakeLongSteps) {
  EXPECT_GT(HitStrips(10).stable_step(), 1e-5);
  EXPECT_LT(HitStrips(0).stable_step(), 1e-7);
}

TEST(CommonModes, KeepTheirEnergyAfterABlow) {
  HitStrips strips(10);
  const auto drift = [&](double step) {
    strips.begin(step);
    strips.motion().advance_to(static_cast<std::int64_t>(std::ceil(HitStrips::blow / step)) + 1);
    const double energy = strips.energy();
    EXPECT_GT(energy, 0.1);
    double largest = 0.0;
    for (int i = 0; i < 40; ++i) {
      strips.motion().advance_to(strips.motion().step_number() + 10);
      largest = std::max(largest, std::abs(strips.energy() / energy - 1));
    }
    return largest;
  };
  const double coarse = drift(1e-5), fine = drift(5e-6);
  EXPECT_LT(coarse, 0.01);
  EXPECT_LT(fine, 0.3 * coarse);
}

/// What is said of strips that can't have common modes.
std::string refusal(const Assembly& strips) {
  try {
    static_cast<void>(bases_of_strips(strips));
  } catch (const deck::DeckError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(CommonModes, NeedBodiesThatNoPrestressDeforms) {
  Assembly strips = glued_strips(4);
  scene::Body& pulled = strips.scene.bodies[1];
  pulled.name = "right";
  pulled.prestress.emplace();
  pulled.prestress->stress(0, 0) = 1e6;
  pulled.prestress->where = {"deck.yaml", 9, 5};
  EXPECT_EQ(refusal(strips),
            "deck.yaml:9:5: bodies.right.prestress: deforms the body, and large_amplitudes are possible about the "
            "undeformed shape only: give a stress that pulls on held faces only, or leave out large_amplitudes");
}

TEST(CommonModes, NeedBodiesThatAreHeld) {
  Assembly strips = glued_strips(4);
  for (scene::Body& body : strips.scene.bodies) {
    body.fixed.clear();
  }
  EXPECT_EQ(refusal(strips),
            "deck.yaml:3:5: body 'block' and those that joints tie to it can move rigidly in 6 ways: joined bodies "
            "with large_amplitudes have to be held by fixed groups. Hold them, or use model: {type: "
            "finite_elements}");
}

}  // namespace
}  // namespace idiophone::eigenmodes
