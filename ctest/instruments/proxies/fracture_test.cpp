// Lattices that break: where, and what their pieces keep.

#include "idiophone/instruments/proxies/fracture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "breakable_bar.hpp"

namespace idiophone::proxies {
namespace {

Fragment shaken(const std::shared_ptr<const Lattice>& lattice) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  Fragment fragment = stretched(lattice, [](double x) { return 1e-3 * x; });
  for (std::size_t i = 0; i < fragment.velocity.size(); ++i) {
    fragment.displacement[i] += 1e-5 * Vector3(normal(random), normal(random), normal(random));
    fragment.velocity[i] = Vector3(normal(random), 1.0 + normal(random), normal(random));
  }
  return fragment;
}

FragmentSums sum_of(const std::vector<Fragment>& fragments) {
  FragmentSums total;
  for (const Fragment& fragment : fragments) {
    const FragmentSums sums = sums_of(fragment);
    total.mass += sums.mass;
    total.momentum += sums.momentum;
    total.angular_momentum += sums.angular_momentum;
    total.kinetic_energy += sums.kinetic_energy;
    total.elastic_energy += sums.elastic_energy;
  }
  return total;
}

void expect_same_motion(const FragmentSums& found, const FragmentSums& expected) {
  EXPECT_NEAR(found.mass, expected.mass, 1e-10 * expected.mass);
  EXPECT_LT((found.momentum - expected.momentum).norm(), 1e-10 * expected.momentum.norm());
  EXPECT_LT((found.angular_momentum - expected.angular_momentum).norm(), 1e-10 * expected.angular_momentum.norm());
}

TEST(Fracture, ChainBreaksWhereItIsStretchedTooTightly) {
  // Links of 0.03 m are stretched by 0.1 %, that from 0.18 m to 0.21 m by 0.3 %.
  const auto displacement = [](double x) { return 1e-3 * x + 2e-3 * std::clamp(x - 0.18, 0.0, 0.03); };
  const Fragment chain = stretched(bar(), displacement);
  EXPECT_TRUE(overloads(chain, {.tensile = 1e8 * 3.01e-3}).empty());
  const std::vector<Overload> overloaded = overloads(chain, {.tensile = 1e8 * 2.9e-3});
  ASSERT_FALSE(overloaded.empty());
  for (const Index mass : {overloaded.front().a, overloaded.front().b}) {
    EXPECT_NEAR(chain.lattice->mesh().nodes[mass].x(), 0.195, 0.0151);
  }
  EXPECT_NEAR(std::abs(overloaded.front().direction.x()), 1.0, 0.2);
  // Pressed as much, it holds.
  EXPECT_TRUE(overloads(stretched(bar(), [&](double x) { return -displacement(x); }), {.tensile = 1e5}).empty());
}

TEST(Fracture, ChainFallsIntoTwoWhereItsMassesArePulledToBothSides) {
  // Two links are stretched. Only the masses between them are pulled to both sides.
  const auto displacement = [](double x) { return 2e-3 * std::clamp(x - 0.15, 0.0, 0.06); };
  const Fragment chain = stretched(bar(), displacement);
  const std::vector<Fragment> pieces = all_broken(chain, {.tensile = 1e8 * 1e-3, .shortest_spring = 1.0});
  ASSERT_EQ(pieces.size(), 2U);
  std::vector<double> ends;
  for (const Fragment& piece : pieces) {
    const auto [first, last] =
        std::ranges::minmax(piece.lattice->mesh().nodes, {}, [](const Vector3& node) { return node.x(); });
    ends.insert(ends.end(), {first.x(), last.x()});
  }
  std::ranges::sort(ends);
  EXPECT_NEAR(ends[1], 0.18, 1e-12);
  EXPECT_NEAR(ends[2], 0.18, 1e-12);
  EXPECT_NEAR(sum_of(pieces).mass, sums_of(chain).mass, 1e-10 * sums_of(chain).mass);
}

TEST(Fracture, AllThatIsOverloadedMoreThanWhatIsNearBreaksAtOnce) {
  // Two links are stretched near each end. Only the masses between them are pulled to both sides.
  const Fragment chain = stretched(
      bar(), [](double x) { return 2e-3 * (std::clamp(x - 0.03, 0.0, 0.06) + std::clamp(x - 0.21, 0.0, 0.06)); });
  const std::vector<Overload> found = overloads(chain, {.tensile = 1e8 * 1e-3, .shortest_spring = 1.0});
  ASSERT_GE(found.size(), 2U);
  const auto place = [&](const Overload& overload) { return chain.lattice->mesh().nodes[overload.a].x(); };
  const auto [first, last] = std::ranges::minmax(found, {}, place);
  EXPECT_LT(place(first), 0.1);
  EXPECT_GT(place(last), 0.2);
  for (const auto& tetrahedron : chain.lattice->mesh().tetrahedra) {
    EXPECT_LE(std::ranges::count_if(found,
                                    [&](const Overload& overload) {
                                      return std::ranges::find(tetrahedron, overload.a) != tetrahedron.end();
                                    }),
              1);
  }
}

TEST(Fracture, NothingHoldsByAnEdgeOrAPoint) {
  // Two tetrahedra have an edge in common, a third one touches them in a point.
  TetrahedralMesh mesh;
  mesh.nodes = {{0, 0, 0},     {1, 0, 0}, {0, 1, 0.5}, {0, 1, -0.5}, {0, -1, 0.5},
                {0, -1, -0.5}, {2, 0, 0}, {2, 1, 0},   {2, 0, 1}};
  mesh.tetrahedra = {{0, 1, 2, 3}, {0, 1, 4, 5}, {1, 6, 7, 8}};
  mesh.surface = exterior_triangles(mesh.nodes, mesh.tetrahedra);
  const auto lattice = std::make_shared<Lattice>(mesh, rubber);
  const Fragment whole = shaken(lattice);
  const std::vector<Fragment> parts = broken(whole, {});
  EXPECT_EQ(parts.size(), 3U);
  expect_same_motion(sum_of(parts), sums_of(whole));
  EXPECT_NEAR(sum_of(parts).elastic_energy, sums_of(whole).elastic_energy, 1e-9 * sums_of(whole).elastic_energy);
  const Fragment box_of_faces = shaken(bar());
  EXPECT_EQ(broken(box_of_faces, {}).size(), 1U);
}

TEST(Fracture, SplitMassKeepsMotionAndEnergy) {
  const Fragment whole = shaken(bar());
  const Index middle = static_cast<Index>(5 + 11 * 2);
  const std::vector<Fragment> parts =
      broken(whole, std::vector<Overload>{{.a = middle, .b = middle, .direction = Vector3::UnitX()}});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].lattice->masses().size(), whole.lattice->masses().size() + 1);
  const FragmentSums before = sums_of(whole), after = sum_of(parts);
  expect_same_motion(after, before);
  EXPECT_NEAR(after.kinetic_energy, before.kinetic_energy, 1e-12 * before.kinetic_energy);
  EXPECT_NEAR(after.elastic_energy, before.elastic_energy, 1e-9 * before.elastic_energy);
}

TEST(Fracture, SplitSpringKeepsMotion) {
  const Fragment whole = shaken(bar());
  const Spring& spring = whole.lattice->springs()[whole.lattice->springs().size() / 2];
  const std::vector<Fragment> parts = broken(whole, std::vector<Overload>{{.a = spring.a, .b = spring.b}});
  const FragmentSums before = sums_of(whole), after = sum_of(parts);
  std::size_t masses = 0;
  for (const Fragment& part : parts) {
    masses += part.lattice->masses().size();
  }
  EXPECT_GE(masses, whole.lattice->masses().size() + 2);
  expect_same_motion(after, before);
  // The middle masses move with the mean of the ends: what the ends moved against each other is lost in part.
  EXPECT_LT(after.kinetic_energy, before.kinetic_energy);
  EXPECT_GT(after.kinetic_energy, 0.9 * before.kinetic_energy);
}

TEST(Fracture, PiecesKeepMassAndMomentum) {
  const Fragment whole = shaken(bar());
  std::vector<Fragment> pieces = all_broken(whole, {.tensile = 1e8 * 0.2e-3, .shortest_spring = 0.01});
  ASSERT_GE(pieces.size(), 2U);
  expect_same_motion(sum_of(pieces), sums_of(whole));
  Vector3 momentum = Vector3::Zero();
  for (Fragment& piece : pieces) {
    momentum += piece.lattice->inertia().mass * take_rigid_motion(piece).velocity;
    EXPECT_LT(sums_of(piece).momentum.norm(), 1e-12);  // what is left only vibrates
  }
  EXPECT_LT((momentum - sums_of(whole).momentum).norm(), 1e-10 * momentum.norm());
}
/// Sum of k l^2, which is that of the tetrahedra, however they hang together, J.
double spring_energy(const std::vector<Fragment>& fragments) {
  double sum = 0.0;
  for (const Fragment& fragment : fragments) {
    for (const Spring& spring : fragment.lattice->springs()) {
      sum += spring.stiffness * spring.natural * spring.natural;
    }
  }
  return sum;
}

TEST(Fracture, PiecesKeepTheFactorsOfTheirSprings) {
  OwnValues own;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0.1, 1.0);
  for (std::size_t t = 0; t < bar()->mesh().tetrahedra.size(); ++t) {
    std::ranges::generate(own.edges.emplace_back(), [&] { return uniform(random); });
  }
  const auto soft = std::make_shared<Lattice>(bar()->mesh(), bar()->material(), std::vector<Index>{}, own);
  const auto displacement = [](double x) { return 2e-3 * std::clamp(x - 0.15, 0.0, 0.06); };
  const Fragment chain = stretched(soft, displacement);
  const std::vector<Fragment> pieces = all_broken(chain, {.tensile = 1e8 * 1e-4, .shortest_spring = 1.0});
  ASSERT_GT(pieces.size(), 1U);
  EXPECT_NEAR(spring_energy(pieces) / spring_energy({chain}), 1.0, 1e-12);
  EXPECT_LT(spring_energy({chain}), 0.7 * spring_energy({stretched(bar(), displacement)}));
}

}  // namespace
}  // namespace idiophone::proxies
