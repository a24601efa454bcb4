// Bodies of the engine that break while they sound.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <stdexcept>
#include <string>

#include "breakable_bar.hpp"
#include "idiophone/instruments/proxies/engine.hpp"

namespace idiophone::proxies {
namespace {

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
}  // namespace
}  // namespace idiophone::proxies
