// Bolts with a shank: the beam that rigid bodies feel, and how two bodies vibrate on it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "assembly.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/solids/joints/beam_stiffness.hpp"
#include "idiophone/solids/joints/bolt_forces.hpp"
#include "joined_blocks.hpp"
#include "ranks.hpp"

namespace idiophone::joints {
namespace {

using Matrix12 = Eigen::Matrix<double, 12, 12>;
using Vector12 = Eigen::Matrix<double, 12, 1>;

struct Section {
  double young, shear, area, shear_area, inertia, polar;
};

Section section_of(const scene::Shank& shank) {
  const double square = shank.radius * shank.radius, area = std::numbers::pi * square, nu = shank.poisson;
  return {.young = shank.young,
          .shear = shank.young / (2 + 2 * nu),
          .area = area,
          .shear_area = area * 6 * (1 + nu) / (7 + 6 * nu),
          .inertia = area * square / 4,
          .polar = area * square / 2};
}

/// Przemieniecki (1968), eq. 5.116: a beam along x; displacements and rotations of its first end, then of its second.
Matrix12 beam_of_the_books(const scene::Shank& shank, double length) {
  const Section s = section_of(shank);
  const double phi = 12 * s.young * s.inertia / (s.shear * s.shear_area * length * length);
  const double k = s.young * s.inertia / ((1 + phi) * length * length * length);
  Matrix12 matrix = Matrix12::Zero();
  const auto couple = [&](std::array<int, 2> rows, double stiffness) {
    matrix(rows[0], rows[0]) = matrix(rows[1], rows[1]) = stiffness;
    matrix(rows[0], rows[1]) = matrix(rows[1], rows[0]) = -stiffness;
  };
  couple({0, 6}, s.young * s.area / length);
  couple({3, 9}, s.shear * s.polar / length);
  // In the plane x y, a positive rotation about z lifts the second end; in x z, one about y lowers it.
  for (const auto& [rows, sign] : {std::pair(std::array{1, 5, 7, 11}, 1.0), std::pair(std::array{2, 4, 8, 10}, -1.0)}) {
    Eigen::Matrix4d plane;
    const double l = sign * length, same = (4 + phi) * l * l, other = (2 - phi) * l * l;
    plane << 12, 6 * l, -12, 6 * l, 6 * l, same, -6 * l, other, -12, -6 * l, 12, -6 * l, 6 * l, other, -6 * l, same;
    matrix(rows, rows) = k * plane;
  }
  return matrix;
}

struct BoltedBlocks : JoinedBlocks {
  explicit BoltedBlocks(double preload = 0.0) : JoinedBlocks(MPI_COMM_SELF, under(preload)) {}

  static scene::Joint under(double preload) {
    scene::Joint stud = joint_of("stud");
    stud.shank->preload = preload;
    return stud;
  }

  [[nodiscard]] double length() const { return (joint.axis.end - joint.axis.begin).norm(); }

  /// Small displacements and rotations of the two blocks about the two ends.
  void move_ends(const Vector12& ends) {
    for (std::size_t body = 0; body < 2; ++body) {
      const Vector3 shift = ends.segment<3>(body == 0 ? 0 : 6), turn = ends.segment<3>(body == 0 ? 3 : 9);
      for (Index node = part.bodies[body].owned_begin; node < part.bodies[body].owned_end; ++node) {
        const Vector3 arm = part.reference[node] - (body == 0 ? joint.axis.begin : joint.axis.end);
        Vector3::Map(state[node].displacement) = shift + turn.cross(arm);
      }
    }
  }
};

ON_RANKS(1);

TEST(Shank, IsTheBeamOfTheBooks) {
  BoltedBlocks blocks;
  const Matrix12 matrix = beam_of_the_books(*blocks.joint.shank, blocks.length());
  for (int seed = 1; seed <= 12; ++seed) {
    const Vector12 ends = Vector12::NullaryExpr([&](Eigen::Index i) {
      return std::sin(seed * static_cast<double>((i + 1) * (i + 2))) * (i % 6 < 3 ? 1e-9 : 1e-8);  // m, rad
    });
    blocks.move_ends(ends);
    const double expected = ends.dot(matrix * ends) / 2;
    EXPECT_NEAR(blocks.energy(), expected, 1e-5 * expected);
  }
}

TEST(Shank, IsStifferUnderItsPreload) {
  constexpr double pull = 2e4;  // N
  BoltedBlocks slack, taut(pull);
  const auto rise = [&](const Vector12& ends) {
    slack.move_ends(ends);
    taut.move_ends(ends);
    return taut.energy() - slack.energy();
  };
  // Sway of ends that do not turn, and a circular arc; the integrals of pull w'^2/2 along the cubic of the beam.
  const double length = slack.length(), small = 1e-5;
  Vector12 sway = Vector12::Zero(), arc = Vector12::Zero();
  sway[7] = small;
  arc[5] = -small;
  arc[11] = small;
  const double of_sway = 1.2 * pull / length * small * small / 2;
  const double of_arc = pull * length / 12 * 4 * small * small / 2;
  EXPECT_NEAR(rise(sway), of_sway, 1e-4 * of_sway);
  EXPECT_NEAR(rise(arc), of_arc, 1e-4 * of_arc);
}

TEST(Shank, HoldsWhatLiesUnderItsWashers) {
  scene::Joint stud = JoinedBlocks::joint_of("stud");
  stud.axis.begin.z() = stud.axis.end.z() = 0.005;
  stud.shank->washer = 0.004;
  const JoinedBlocks blocks(MPI_COMM_SELF, stud);
  const MeshedJoint& link = blocks.meshed[0];
  EXPECT_EQ(link.points[0].end - link.points[0].second_begin, 75);  // no middle of a face: the nearest hexahedron
  Vector3 middle = Vector3::Zero();
  for (const NodeWeight& weight : std::span(link.weights).first(link.points[0].second_begin)) {
    middle += weight.value * blocks.part.reference[weight.node];
  }
  EXPECT_LT((middle - (stud.axis.begin + stud.axis.end) / 2).norm(), 1e-12);
}

TEST(Shank, RefusesWhatItCannotHold) {
  const auto refusal = [](const scene::Joint& joint) -> std::string {
    JoinedBlocks blocks;
    blocks.scene.joints = {joint};
    try {
      (void)find_joints(blocks.scene, blocks.meshes);
    } catch (const deck::DeckError& error) {
      return error.what();
    }
    return "";
  };
  scene::Joint stud = JoinedBlocks::joint_of("stud");
  EXPECT_EQ(refusal(stud), "");
  stud.surfaces[1].where = {"stud.yaml", 4, 9};
  std::swap(stud.axis.begin, stud.axis.end);
  stud.axis.end.x() = -0.05;
  stud.axis.begin.x() = 0.0;
  EXPECT_THAT(refusal(stud),
              testing::StartsWith("stud.yaml:4:9: joints.stud: the end [-0.05, 0.016, 0.011] of the axis "
                                  "is 0.238 m from 'x1', more than the radius of the washer"));
  stud = JoinedBlocks::joint_of("stud");
  stud.surfaces = {scene::JoinedSurface{1, "x0", {}}, scene::JoinedSurface{1, "rim", {}}};
  stud.shank->washer = 0.005;
  stud.axis = {{0.1005, 0.007, 0.01}, {0.12, 0.0, 0.01}};  // on two faces of one hexahedron
  EXPECT_THAT(refusal(stud), testing::HasSubstr("joints.stud: both ends hold the same elements"));
  stud.axis.end.x() = 0.18;
  EXPECT_EQ(refusal(stud), "");
}

/// Two blocks that a stud presses together, with glue between their end faces.
struct ClampedBlocks : JoinedBlocks {
  ClampedBlocks() : JoinedBlocks(MPI_COMM_WORLD) {
    scene.joints = {joint_of("glue"), joint_of("stud")};
    meshed = find_joints(scene, meshes);
    part = mesh::distribute(parallel::is_root(MPI_COMM_WORLD) ? meshes : std::vector<mesh::Mesh>{}, MPI_COMM_WORLD,
                            coupled_nodes(meshed));
    joints = std::make_unique<Joints>(meshed, part);
    state.resize(part.node_ids.size());
  }

  /// The blocks move apart.
  void part_by(double distance) {
    for (std::size_t node = 0; node < state.size(); ++node) {
      state[node].displacement[0] = part.reference[node].x() > 0.1 + gap / 2 ? distance : 0.0;
    }
  }

  [[nodiscard]] const scene::Shank& shank() const { return *scene.joints[1].shank; }
};

/// Over all ranks.
double sum_over_ranks(const ReproducibleSum& share) {
  ReproducibleSum::Words words = share.words();
  parallel::reduce(words, MPI_SUM, MPI_COMM_WORLD);
  return ReproducibleSum::from_words(words).value();
}

ON_RANKS(1, 3);

TEST(BoltForces, AreThoseOfSpringsBetweenBlocksThatMoveApart) {
  ClampedBlocks blocks;
  const BoltForces forces(blocks.scene, *blocks.joints, blocks.part, MPI_COMM_WORLD);
  ASSERT_THAT(forces.all(), testing::ElementsAre(BoltForce{1, 0}, BoltForce{1, 1}));
  constexpr double distance = 1e-7, preload = 5e4;
  blocks.part_by(distance);
  const std::vector<ReproducibleSum> taken = forces.taken(blocks.state);
  const double of_glue = 3e12 * 0.03 * 0.02 * distance / preload;
  EXPECT_NEAR(sum_over_ranks(taken[0]), of_glue, 1e-9 * of_glue);
  const double of_shank = beam_stiffness(blocks.shank(), 0.2 + JoinedBlocks::gap).axial * distance / preload;
  EXPECT_NEAR(sum_over_ranks(taken[1]), -of_shank, 1e-9 * of_shank);
}

TEST(BoltForces, AreThoseOfLayersInTheConesOfTheWashers) {
  ClampedBlocks blocks;
  scene::Joint& stud = blocks.scene.joints[1];
  stud.axis = {{0.096, 0.015, 0.01}, {0.104, 0.015, 0.01}};  // the cones are 7 mm wide at the glue
  stud.shank->washer = 0.003;
  const auto part_in_cones = [&] {
    const BoltForces forces(blocks.scene, *blocks.joints, blocks.part, MPI_COMM_WORLD);
    blocks.part_by(1e-7);
    return sum_over_ranks(forces.taken(blocks.state).front()) * stud.shank->preload / (3e12 * 1e-7);
  };
  EXPECT_NEAR(part_in_cones(), std::numbers::pi * 0.007 * 0.007, 0.15 * std::numbers::pi * 0.007 * 0.007);
  stud.axis = {{0.09, 0.015, 0.01}, {0.099, 0.015, 0.01}};  // the glue is not between its ends
  EXPECT_LT(part_in_cones(), 0.0);                          // the stud alone
  stud.shank->preload = 0.0;
  EXPECT_THAT(BoltForces(blocks.scene, *blocks.joints, blocks.part, MPI_COMM_WORLD).all(), testing::IsEmpty());
}

TEST(BoltForces, OfAPointInTwoConesBelongToTheNearerBolt) {
  ClampedBlocks blocks;
  scene::Joint second = blocks.scene.joints[1];
  second.axis.begin.y() = second.axis.end.y() = 0.004;
  blocks.scene.joints.push_back(second);
  const BoltForces forces(blocks.scene, *blocks.joints, blocks.part, MPI_COMM_WORLD);
  blocks.part_by(1e-7);
  const std::vector<ReproducibleSum> taken = forces.taken(blocks.state);
  ASSERT_THAT(forces.all(), testing::ElementsAre(BoltForce{1, 0}, BoltForce{1, 1}, BoltForce{2, 0}));
  const double nearer = sum_over_ranks(taken[0]), farther = sum_over_ranks(taken[2]),
               whole = 3e12 * 0.03 * 0.02 * 1e-7 / 5e4;
  EXPECT_NEAR(nearer + farther, whole, 1e-9 * whole);
  EXPECT_NEAR(farther, whole / 3, 0.05 * whole);  // up to y = 0.01, of 0.03 m
}

}  // namespace
}  // namespace idiophone::joints

namespace idiophone::eigenmodes {
namespace {

/// Two equal blocks of steel, nearly rigid beside the bolt that goes from the end of one to the end of the other.
struct BlocksOnABolt {
  explicit BlocksOnABolt(double preload) : shank{.radius = 0.001, .washer = 1.0, .young = 2e9, .poisson = 0.3} {
    shank.preload = preload;
    const mesh::Mesh block = support::block_mesh(element::hex(2, 2), {0.02, 0.02, 0.02}, {1, 2, 1});
    blocks.add(block, Vector3::Zero());
    blocks.add(block, {0.02 + length, 0, 0});
    scene::Joint& joint = blocks.scene.joints.emplace_back();
    joint.type = scene::JointType::bolt;
    joint.surfaces = {scene::JoinedSurface{0, "x1", {}}, scene::JoinedSurface{1, "x0", {}}};
    joint.axis = {{0.02, 0.01, 0.01}, {0.02 + length, 0.01, 0.01}};
    joint.shank = shank;
    joint.damping = relaxation;
  }

  static constexpr double side = 0.02, length = 0.08;  // m
  static constexpr double relaxation = 1e-6;           // s
  scene::Shank shank;
  Assembly blocks;
};

struct Expected {
  double arc, torsion, sway, axial;  ///< rad/s
};

/// Two rigid cubes of mass m and moment of inertia J on a beam from face to face, d = (length + side)/2: both turn
/// against each other (arc), w^2 = 2 k/J; or one goes up as the other one goes down and both turn alike (sway), w^2 = 2
/// k (1/m + d^2/J).
Expected rigid_cubes(const BlocksOnABolt& bolted) {
  const double side = BlocksOnABolt::side, distance = (BlocksOnABolt::length + side) / 2;
  const double mass = 7850 * side * side * side, inertia = mass * side * side / 6;
  const joints::BeamStiffness beam = joints::beam_stiffness(bolted.shank, BlocksOnABolt::length);
  return {.arc = std::sqrt(2 * beam.bending / inertia),
          .torsion = std::sqrt(2 * beam.torsion / inertia),
          .sway = std::sqrt(2 * beam.lateral * (1 / mass + distance * distance / inertia)),
          .axial = std::sqrt(2 * beam.axial / mass)};
}

void expect_rigid_cubes(const BlocksOnABolt& bolted) {
  const Expected expected = rigid_cubes(bolted);
  const Modes found = bolted.blocks.find(6);
  EXPECT_EQ(found.rigid_motions, 6);
  std::vector<double> frequencies = {expected.arc,  expected.arc,  expected.torsion,
                                     expected.sway, expected.sway, expected.axial};
  std::ranges::sort(frequencies);
  for (std::size_t mode = 0; mode < frequencies.size(); ++mode) {
    const double frequency = frequencies[mode];
    EXPECT_NEAR(2 * std::numbers::pi * found.modes[mode].frequency, frequency, 2e-4 * frequency);
    const double ratio = BlocksOnABolt::relaxation * frequency / 2;
    EXPECT_NEAR(found.modes[mode].damping_ratio, ratio, 4e-4 * ratio);
  }
}

ON_RANKS(1, 3);

TEST(BoltedModes, AreThoseOfTwoRigidCubesOnABeam) {
  expect_rigid_cubes(BlocksOnABolt(0.0));
}

TEST(BoltedModes, RiseWithThePreload) {
  const BlocksOnABolt slack(0.0), taut(1.0);
  expect_rigid_cubes(taut);
  EXPECT_GT(rigid_cubes(taut).sway, 1.1 * rigid_cubes(slack).sway);
}

}  // namespace
}  // namespace idiophone::eigenmodes
