#include "idiophone/instruments/proxies/fracture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "bodies.hpp"
#include "idiophone/instruments/proxies/engine.hpp"

namespace idiophone::proxies {
namespace {

constexpr double bar_length = 0.3, bar_width = 0.03;  // m

/// A bar along x. @param neck  how thin it is in the middle, of its bar_width
std::shared_ptr<const Lattice> bar(double neck = 1.0, const Damping& damping = {}) {
  const auto place = [neck](const Vector3& at) {
    const double thickness = std::abs(at[0] - 0.5) < 0.04 ? neck : 1.0;
    return Vector3(bar_length * at[0], bar_width * thickness * (at[1] - 0.5), bar_width * thickness * (at[2] - 0.5));
  };
  return std::make_shared<Lattice>(grid_mesh({10, 1, 1}, place),
                                   Material{.young = 1e8, .density = 1000.0, .damping = damping});
}

/// A state in which every cross-section has moved along x.
template <class Displacement>
Fragment stretched(const std::shared_ptr<const Lattice>& lattice, const Displacement& displacement) {
  Fragment fragment{.lattice = lattice, .displacement = {}, .velocity = {}};
  for (const Vector3& node : lattice->mesh().nodes) {
    fragment.displacement.emplace_back(displacement(node.x()), 0.0, 0.0);
    fragment.velocity.emplace_back(Vector3::Zero());
  }
  return fragment;
}

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

/// Everything that is overloaded breaks, while it does not move.
std::vector<Fragment> all_broken(const Fragment& whole, const Strength& strength) {
  std::vector<Fragment> left = {whole}, held;
  for (int breaks = 0; !left.empty() && breaks < 5000; ++breaks) {
    const Fragment next = left.back();
    left.pop_back();
    const std::vector<Overload> overloaded = overloads(next, strength);
    std::vector<Fragment> parts = overloaded.empty() ? std::vector{next} : broken(next, overloaded);
    auto& place = overloaded.empty() ? held : left;
    place.insert(place.end(), parts.begin(), parts.end());
  }
  held.insert(held.end(), left.begin(), left.end());
  return held;
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

/// The root of the mean square of the differences between samples, over that of the samples.
double brightness(std::span<const double> sound) {
  double change = 0.0, level = 0.0;
  for (std::size_t i = 1; i < sound.size(); ++i) {
    change += std::pow(sound[i] - sound[i - 1], 2);
    level += std::pow(sound[i], 2);
  }
  return std::sqrt(change / level);
}

/// A bar with a neck, which is struck along its axis: the wave comes back from the other end as a pull.
Engine struck_bar(double tensile) {
  Engine engine({.significant_distance = 1e-7, .sound = Sound::deviation});
  engine.add({.name = "bar",
              .levels = {bar(0.6, {.mass = 20.0, .stiffness = 2e-6})},
              .strength = {.tensile = tensile, .shortest_spring = 0.1}});
  engine.add(impact(0, 0, {0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, 2e-4, 44100));
  return engine;
}

TEST(Fracture, BodyOfTheEngineBreaksIntoPieces) {
  std::vector<double> whole(8000), broken(8000);
  struck_bar(1e12).render(whole);
  Engine engine = struck_bar(1e5);
  engine.render(broken);
  const std::vector<Fracture> fractures = engine.take_fractures();
  ASSERT_GE(fractures.size(), 1U);
  const Fracture& first = fractures.front();
  EXPECT_EQ(first.body, 0U);
  ASSERT_GE(first.pieces.size(), 2U);
  double mass = 0.0;
  Vector3 momentum = Vector3::Zero();
  for (const Piece& piece : first.pieces) {
    mass += piece.mass;
    momentum += piece.mass * piece.motion.velocity;
  }
  EXPECT_NEAR(mass, bar(0.6)->inertia().mass, 1e-9 * mass);
  EXPECT_LT(momentum.norm(), 1e-3 * mass * first.pieces[0].motion.velocity.norm() + 1e-7);
  EXPECT_TRUE(std::ranges::all_of(broken, [](double sample) { return std::isfinite(sample); }));
  EXPECT_NE(broken, whole);
}

/// A pane of glass of 0.3 m in a frame, which a stone hits.
struct StruckPane {
  Engine engine{{.significant_distance = 1e-8, .most_active = 200}};
  std::size_t parts = 1;

  explicit StruckPane(double tensile) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(-0.2, 0.2);
    constexpr int cells = 12;
    std::array<std::array<Vector3, cells + 1>, cells + 1> moved;
    for (auto& row : moved) {
      std::ranges::generate(row, [&] { return Vector3(uniform(random) / cells, uniform(random) / cells, 0.0); });
    }
    const TetrahedralMesh mesh = grid_mesh({cells, cells, 1}, [&](const Vector3& at) {
      const auto i = static_cast<std::size_t>(std::lround(at.x() * cells));
      const auto j = static_cast<std::size_t>(std::lround(at.y() * cells));
      const bool is_inside = i > 0 && i < cells && j > 0 && j < cells;
      return Vector3((at + (is_inside ? moved[i][j] : Vector3::Zero())).cwiseProduct(Vector3(0.3, 0.3, 0.006)));
    });
    std::vector<Index> frame;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
      const Vector3& at = mesh.nodes[node];
      if (std::min({at.x(), at.y(), 0.3 - at.x(), 0.3 - at.y()}) < 1e-9) {
        frame.push_back(static_cast<Index>(node));
      }
    }
    const Material glass{.young = 7e10, .density = 2500.0, .damping = {.mass = 20.0, .stiffness = 1e-7}};
    engine.add({.name = "pane",
                .levels = {std::make_shared<Lattice>(mesh, glass, frame)},
                .strength = {.tensile = tensile, .shortest_spring = 1.0}});
    engine.add(impact(0, 0, {0.17, 0.16, 0.006}, {0.0, 0.0, -1.5}, 3e-4, 44100));
  }

  std::vector<double> sound(std::size_t samples) {
    std::vector<double> heard(samples);
    engine.render(heard);
    for (const Fracture& fracture : engine.take_fractures()) {
      parts += fracture.pieces.size() - 1;
    }
    return heard;
  }
};

TEST(Fracture, PaneOfGlassFallsApart) {
  StruckPane whole(1e12), broken(2e7);
  const std::vector<double> unbroken = whole.sound(300);
  EXPECT_EQ(whole.parts, 1U);
  const std::vector<double> first = broken.sound(150);
  const std::size_t parts = broken.parts;
  EXPECT_GE(parts, 5U);
  const std::vector<double> second = broken.sound(150);
  EXPECT_GE(broken.parts, parts);
  RecordProperty("parts", std::to_string(broken.parts));
  double loudest = 0.0, difference = 0.0;
  for (std::size_t i = 0; i < 150; ++i) {
    ASSERT_TRUE(std::isfinite(first[i]) && std::isfinite(second[i]));
    loudest = std::max({loudest, std::abs(first[i]), std::abs(second[i])});
    difference = std::max(difference, std::abs(second[i] - unbroken[150 + i]));
  }
  const double peak = std::abs(std::ranges::max(unbroken, {}, [](double value) { return std::abs(value); }));
  EXPECT_LT(loudest, 5.0 * peak);
  EXPECT_GT(difference, 0.1 * peak);
}

/// Of a body that is struck along x at its end, once its higher modes have decayed.
double pitch_of(const std::shared_ptr<const Lattice>& lattice) {
  Engine engine({.sound = Sound::deviation});
  engine.add({.name = "bar", .levels = {lattice}});
  const Vector3 end = std::ranges::min(lattice->mesh().nodes, {}, [](const Vector3& node) { return node.x(); });
  engine.add(impact(0, 0, {end.x(), 0.0, 0.0}, {0.01, 0.0, 0.0}, 2e-4, 44100));
  std::vector<double> sound(1500);
  engine.render(sound);
  return brightness(std::span(sound).subspan(500));
}

TEST(Fracture, PiecesSoundHigherThanTheWhole) {
  const auto displacement = [](double x) { return 2e-3 * std::clamp(x - 0.15, 0.0, 0.06); };
  const Fragment chain = stretched(bar(1.0, {.mass = 0.0, .stiffness = 2e-5}), displacement);
  const std::vector<Fragment> pieces = all_broken(chain, {.tensile = 1e8 * 1e-3, .shortest_spring = 1.0});
  ASSERT_EQ(pieces.size(), 2U);
  for (const Fragment& piece : pieces) {  // 0.18 m and 0.12 m of 0.3 m
    EXPECT_GT(pitch_of(piece.lattice), 1.4 * pitch_of(chain.lattice));
  }
}

TEST(Fracture, PiecesAreStruckInsteadOfTheBody) {
  Engine engine = struck_bar(1e5), other = struck_bar(1e5);
  std::vector<double> sound(4000), without(4000);
  engine.render(sound);
  other.render(without);
  ASSERT_GE(engine.take_fractures().size(), 1U);
  EXPECT_THROW(engine.remove(0), std::invalid_argument);
  static_cast<void>(engine.take_choices());
  engine.add(impact(0, engine.now(), {0.3, 0.0, 0.0}, {0.0, 0.0, 1e-3}, 2e-4, 44100));
  engine.render(sound);
  other.render(without);
  EXPECT_NE(sound, without);
  for (const Choice& choice : engine.take_choices()) {
    EXPECT_NE(choice.body, 0U);
  }
}

TEST(Fracture, ForceOnAPieceHasTheShareOfItsMass) {
  Engine engine = struck_bar(1e5), other = struck_bar(1e5);
  std::vector<double> sound(4000), directly(4000);
  engine.render(sound);
  other.render(sound);
  std::size_t piece = 0;  // at the end
  double nearest = std::numeric_limits<double>::infinity();
  for (const Fracture& fracture : engine.take_fractures()) {
    for (const Piece& each : fracture.pieces) {
      for (const Vector3& node : engine.body(each.body.value()).levels.front()->mesh().nodes) {
        if (const double distance = (node - Vector3(0.3, 0.0, 0.0)).norm();
            engine.is_whole(*each.body) && distance < nearest) {
          piece = *each.body;
          nearest = distance;
        }
      }
    }
  }
  ASSERT_GT(piece, 0U);
  const double share = engine.body(piece).levels.front()->inertia().mass / bar(0.6)->inertia().mass;
  EXPECT_LT(share, 0.9);
  Force force = impact(0, engine.now(), {0.3, 0.0, 0.0}, {0.0, 0.0, 1e-3}, 2e-4, 44100);
  engine.add(force);
  force.body = piece;
  force.direction *= share;
  other.add(force);
  engine.render(sound);
  other.render(directly);
  for (std::size_t i = 0; i < sound.size(); ++i) {
    ASSERT_NEAR(sound[i], directly[i], 1e-12 + 1e-5 * std::abs(directly[i]));
  }
}

TEST(Fracture, SameBitsForAnyBlocks) {
  std::vector<double> whole(4000), parts(4000);
  struck_bar(1e5).render(whole);
  Engine other = struck_bar(1e5);
  for (std::size_t first = 0; first < parts.size(); first += 250) {
    other.render(std::span(parts).subspan(first, 250));
  }
  EXPECT_EQ(whole, parts);
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
