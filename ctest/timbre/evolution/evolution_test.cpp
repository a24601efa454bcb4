#include "idiophone/timbre/evolution/evolution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "breeding.hpp"
#include "idiophone/timbre/language/graph.hpp"
#include "ranks.hpp"
#include "sounding.hpp"
#include "temporary_file.hpp"

namespace idiophone::timbre {

namespace {

using support::TemporaryFile;

const std::string modes = "(define f (rvector 12 base max))\n(* amp (combine (* (damp f damp_ratio) (sine f))))\n";

std::string collision(double amp, double base, double max, double damp_ratio) {
  return "(parameter amp " + std::to_string(amp) + ")\n(parameter base " + std::to_string(base) + ")\n(parameter max " +
         std::to_string(max) + ")\n(parameter damp_ratio " + std::to_string(damp_ratio) + ")\n" + modes;
}

}  // namespace

ON_RANKS(1);

TEST(SoundDistance, IsZeroForTheSameSoundAndGrowsWithTheDifference) {
  const Target target{.samples = sound_of(collision(1, 500, 1500, 0.002), 8192)};
  const SoundDistance distance(target);
  EXPECT_EQ(distance(target.samples), 0.0);
  const double near = distance(sound_of(collision(1, 510, 1530, 0.002), 8192));
  const double far = distance(sound_of(collision(1, 800, 2400, 0.002), 8192));
  EXPECT_GT(near, 0.1);
  EXPECT_GT(far, near);
}

TEST(Breeding, KeepsTypesAndIsTheSameForTheSameSeed) {
  const TemporaryFile file("tree.tt",
                           "(parameter f 300)(* (sine (* f (+ 1 (* 0.1 (perlin 3))))) (combine (vector 1 2 3)))");
  const BreedingOptions options{.population = 60, .most_nodes = 40, .seed = 7};
  const auto trees = breed({file.path()}, options, 0.2, 44100);
  ASSERT_GT(trees.size(), 45U);  // the others would sound like one of these
  for (const Descendant& descendant : trees) {
    EXPECT_TRUE(is_valid(parse_tree(descendant.tree, "t.tt"), 44100, 40)) << descendant.tree;
    EXPECT_FALSE(descendant.parents.empty());
  }
  const auto again = breed({file.path()}, options, 0.2, 44100);
  ASSERT_EQ(again.size(), trees.size());
  for (std::size_t i = 0; i < trees.size(); ++i) {
    EXPECT_EQ(again[i].tree, trees[i].tree);
  }
}

TEST(Breeding, MakesChildrenThatSoundDifferent) {
  const std::string bee = "(parameter f 230)(sawtooth (* f (+ 1 (* 0.4 (perlin 100)))))";
  const TemporaryFile file("tree.tt", bee);
  auto family = breed({file.path()}, {.population = 20}, 0.3, 44100);
  EXPECT_EQ(family.size(), 20U);
  family.push_back({.tree = bee});
  std::vector<SoundDistance> sounds;
  for (const Descendant& tree : family) {
    const SoundDistance sound({.samples = sound_of_descendant(tree, ".", 0.3, 44100)});
    for (const SoundDistance& other : sounds) {  // half, because these sounds have what nobody hears below 20 Hz, too
      EXPECT_GT(other.to(sound), 0.5 * audible_distance) << tree.tree;
    }
    sounds.push_back(sound);
  }
}

TEST(Breeding, GivesUpWhereNoChangeCanBeHeard) {
  for (const char* text : {"3", "(white 2)", "(* 0.1 (white 2))"}) {  // constants, seeds of noise and loudness
    const TemporaryFile file("tree.tt", text);
    const auto trees = breed({file.path()}, {.change = Change::constants, .population = 5}, 0.2, 44100);
    EXPECT_TRUE(trees.empty()) << text << " became " << trees.front().tree;
  }
}

TEST(Evolution, RecoversTheParametersOfACollision) {
  const std::array wanted = {0.8, 620.0, 2900.0, 0.003};
  const Target target{.samples = sound_of(collision(wanted[0], wanted[1], wanted[2], wanted[3]), 8192)};
  const TemporaryFile file("tree.tt", collision(1.0, 500.0, 2500.0, 0.002));
  const Evolved evolved =
      evolve({file.path()}, target, {.change = Change::constants, .population = 60, .generations = 80, .seed = 3},
             MPI_COMM_WORLD, [](int /*generation*/, double /*distance*/) {});
  const Tree best = parse_tree(evolved.best.tree, "best.tt");
  ASSERT_EQ(best.parameters.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR(*best.parameters[i].default_value / wanted[i], 1.0, 0.05) << best.parameters[i].name;
  }
}

TEST(Evolution, ComesNearerToTheTargetAndKnowsItsAncestry) {
  const Target target{.samples = sound_of(collision(0.8, 620.0, 2900.0, 0.003), 8192)};
  const TemporaryFile file("tree.tt", collision(1.0, 500.0, 2500.0, 0.002));
  std::vector<double> distances;
  const Evolved evolved =
      evolve({file.path()}, target, {.change = Change::constants, .population = 20, .generations = 10, .seed = 3},
             MPI_COMM_WORLD, [&](int /*generation*/, double distance) { distances.push_back(distance); });
  EXPECT_TRUE(std::ranges::is_sorted(distances, std::greater<>()));
  EXPECT_EQ(evolved.best.distance, distances.back());
  EXPECT_LT(evolved.best.distance, 0.9 * evolved.distance_before);
  ASSERT_EQ(evolved.ancestry.size(), 1U + 20U * 10U);
  EXPECT_EQ(evolved.ancestry.back().generation, 10);
  for (const Descendant& tree : evolved.ancestry) {
    for (const int parent : tree.parents) {
      EXPECT_LT(evolved.ancestry[parent].generation, tree.generation);
    }
  }
}

}  // namespace idiophone::timbre
