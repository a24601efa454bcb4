// A body of several materials: packs do not mix them, each element has the law of its own, and the order of the sums
// does not depend on the parts.

#include "regions.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numeric>

#include "block_mesh.hpp"
#include "idiophone/solids/mesh/part_size.hpp"
#include "idiophone/solids/solid/solid.hpp"

namespace idiophone::solid {
namespace {

const Vector3 two_regions_size{0.6, 0.2, 0.1};

scene::Material first_material() {
  return {"steel", 2.0e11, 0.3, 7850, {0, 1e-7}, {}};
}

/// With a loss factor and along the axes of a crystal.
OrientedMaterial second_material() {
  scene::Material spruce{"spruce", 1.2e10, 0.0, 430, {0, 1e-6}, {}};
  spruce.orthotropy = scene::Orthotropy{{1.2e10, 9e8, 5e8}, {0.37, 0.44, 0.42}, {7e8, 4e7, 6e8}};
  spruce.damping.loss = {0.01, {100, 10000}, {}, {}};
  return {spruce, Eigen::Matrix3d(Eigen::AngleAxisd(0.4, Vector3::UnitY()))};
}

/// Two regions that share a face at 0.35 of the length.
mesh::Mesh two_regions(element::Type type) {
  return support::with_regions(support::block_mesh(type, two_regions_size, {12, 3, 1}),
                               [](const Vector3& centre) { return centre.x() < 0.35 * two_regions_size.x() ? 0 : 1; });
}

/// The same elements in one region.
mesh::BodyPart undivided(mesh::BodyPart part) {
  part.regions.clear();
  return part;
}

/// Small displacements and velocities that differ from place to place.
std::vector<NodeState> moved(std::span<const Vector3> reference) {
  std::vector<NodeState> state(reference.size());
  for (std::size_t node = 0; node < state.size(); ++node) {
    const Vector3& x = reference[node];
    for (int i = 0; i < 3; ++i) {
      state[node].displacement[i] = 1e-4 * std::sin(9 * x[i] + 7 * x[(i + 1) % 3] + i);
      state[node].velocity[i] = 3e-2 * std::cos(8 * x[i] - 5 * x[(i + 2) % 3] + i);
    }
  }
  return state;
}

class RegionsTest : public ::testing::TestWithParam<element::Type> {
 protected:
  static constexpr double step = 1e-5;  // s
};

TEST_P(RegionsTest, PacksHoldOneMaterial) {
  const mesh::Part whole = support::whole_part(two_regions(GetParam()));
  const mesh::BodyPart& part = whole.bodies[0];
  const PackLayout layout(part);
  std::size_t elements = 0;
  for (std::size_t pack = 0; pack < layout.pack_count(); ++pack) {
    EXPECT_EQ(layout.first_element(pack), elements);
    const Index region = part.region(elements);
    for (int lane = 0; lane < layout.filled_lanes(pack); ++lane, ++elements) {
      EXPECT_EQ(part.region(elements), region);
      EXPECT_EQ(layout.pack_of(elements), pack);
    }
    const PackRange range = layout.region(static_cast<std::size_t>(region));
    EXPECT_TRUE(range.begin <= pack && pack < range.end);
  }
  EXPECT_EQ(elements, part.element_ids.size());
  EXPECT_EQ(layout.region(0).end, layout.region(1).begin);
}

TEST_P(RegionsTest, EqualMaterialsAreAsOne) {
  const mesh::Mesh mesh = two_regions(GetParam());
  const mesh::Part part = support::whole_part(mesh);
  const std::array materials = {OrientedMaterial{first_material()}, OrientedMaterial{first_material()}};
  const Solid two(part.bodies[0], part.reference, materials);
  const Solid one(undivided(part.bodies[0]), part.reference, first_material());
  const std::vector<NodeState> state = moved(part.reference);
  std::vector<NodeForce> forces(state.size());
  std::vector<NodeForce> expected(state.size());
  two.add_internal_force(state, forces);
  one.add_internal_force(state, expected);
  std::vector<double> masses(state.size());
  std::vector<double> expected_masses(state.size());
  two.add_mass(masses);
  one.add_mass(expected_masses);
  EXPECT_EQ(masses, expected_masses);
  for (std::size_t node = 0; node < state.size(); ++node) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(forces[node].component[i], expected[node].component[i]) << "elements are in the same order";
    }
  }
}

TEST_P(RegionsTest, MassAndEnergyAreThoseOfTheParts) {
  const mesh::Mesh mesh = two_regions(GetParam());
  const mesh::Part part = support::whole_part(mesh);
  Solid solid(part.bodies[0], part.reference, std::array{OrientedMaterial{first_material()}, second_material()});
  std::vector<double> masses(part.reference.size());
  solid.add_mass(masses);
  const double expected = two_regions_size.prod() * (4 * 7850.0 + 8 * 430.0) / 12;
  EXPECT_NEAR(std::accumulate(masses.begin(), masses.end(), 0.0) / expected, 1.0, 1e-12);

  const std::vector<NodeState> state = moved(part.reference);
  std::vector<double> energy(part.bodies[0].element_ids.size());
  solid.elastic_energy(state, energy);
  const Solid all_steel(undivided(part.bodies[0]), part.reference, first_material());
  const Solid all_spruce(undivided(part.bodies[0]), part.reference, second_material().material, second_material().axes);
  std::vector<double> of_steel(energy.size());
  std::vector<double> of_spruce(energy.size());
  all_steel.elastic_energy(state, of_steel);
  all_spruce.elastic_energy(state, of_spruce);
  for (std::size_t element = 0; element < energy.size(); ++element) {
    EXPECT_EQ(energy[element], part.bodies[0].region(element) == 0 ? of_steel[element] : of_spruce[element]);
  }
}

TEST_P(RegionsTest, ForcesBegunWithoutGhostsHaveTheSameBits) {
  const std::array materials = {OrientedMaterial{first_material()}, second_material()};
  mesh::for_each_part({two_regions(GetParam())}, 3, [&](const mesh::Part& part) {
    Solid whole(part.bodies[0], part.reference, materials);
    Solid divided(part.bodies[0], part.reference, materials);
    divided.divide(part.bodies[0]);
    whole.begin_memory(step);
    divided.begin_memory(step);
    const std::vector<NodeState> state = moved(part.reference);
    for (int time = 0; time < 2; ++time) {
      std::vector<NodeForce> expected(state.size());
      std::vector<NodeForce> force(state.size());
      whole.add_internal_force_and_remember(state, expected);
      divided.begin_internal_force(state, force);
      divided.finish_internal_force(state, force);
      for (Index node = 0; node < part.owned_nodes; ++node) {
        for (int i = 0; i < 3; ++i) {
          ASSERT_EQ(force[node].component[i], expected[node].component[i]) << "node " << node;
        }
      }
    }
  });
}

TEST_P(RegionsTest, RowsOfTheMemoryAreEquallyLong) {
  const mesh::Part part = support::whole_part(two_regions(GetParam()));
  Solid solid(part.bodies[0], part.reference, std::array{OrientedMaterial{first_material()}, second_material()});
  solid.begin_memory(step);
  EXPECT_TRUE(solid.has_memory());
  const std::vector<NodeState> state = moved(part.reference);
  std::vector<NodeForce> force(state.size());
  solid.add_internal_force_and_remember(state, force);
  std::size_t width = 0;
  for (std::size_t element = 0; element < part.bodies[0].element_ids.size(); ++element) {
    parallel::ArchiveRow counted(parallel::ArchiveRow::Action::count);
    solid.archive_memory(element, counted);
    width = element == 0 ? counted.count() : width;
    ASSERT_EQ(counted.count(), width);
    std::vector<double> row(width);
    parallel::ArchiveRow saved(parallel::ArchiveRow::Action::save, row);
    solid.archive_memory(element, saved);
    EXPECT_EQ(std::ranges::all_of(row, [](double number) { return number == 0; }), part.bodies[0].region(element) == 0);
  }
  EXPECT_GT(width, 0U);
}

TEST(Regions, DampingIsThatOfTheMaterialThatDampsMost) {
  const mesh::Part part = support::whole_part(two_regions(element::tet4));
  const OrientedMaterial lossier{{"lossier", 1e9, 0.3, 1000, {0, 1e-5}, {}}};
  const Solid solid(part.bodies[0], part.reference, std::array{OrientedMaterial{first_material()}, lossier});
  EXPECT_DOUBLE_EQ(solid.damping(1e4), 1e-5 * 1e8);
}

INSTANTIATE_TEST_SUITE_P(Elements, RegionsTest, ::testing::Values(element::tet4, element::tet10, element::hex(2, 2)));

}  // namespace
}  // namespace idiophone::solid
