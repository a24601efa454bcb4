#include "same_body.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace idiophone::report {
namespace {

nlohmann::json facts(const std::string& deck, const std::string& hash = "0123456789abcdef") {
  return {{"deck", deck}, {"bodies", {{"bar", {{"mesh_hash", hash}}}}}};
}

const std::string deck_of_run =
    "time: {duration: 1}\n"
    "materials: {steel: {young: 2e11, density: 7850}, wood: {young: 1e10}}\n"
    "bodies:\n"
    "  bar: {mesh: /there/bar.geo, material: steel, fixed: [rim], velocity: [0, 0, 1]}\n"
    "  ball: {mesh: ball.geo, material: wood}\n";

std::string with(const std::string& old, const std::string& by) {
  std::string text = deck_of_run;
  return text.replace(text.find(old), old.size(), by);
}

TEST(SameBody, WhatDoesNotChangeItsModesMayDiffer) {
  for (const auto& [old, by] : {std::pair{"duration: 1", "duration: 2"},
                                {"/there/bar.geo", "/here/bar.geo"},
                                {"[0, 0, 1]", "[3, 0, 0]"},
                                {"young: 1e10", "young: 2e10"},
                                {"young: 2e11, density: 7850", "density: 7850, young: 2e11"}}) {
    EXPECT_EQ(difference_of_body(facts(deck_of_run), facts(with(old, by)), "bar"), "") << by;
  }
}

TEST(SameBody, OtherMaterialsConstraintsAndMeshesAreToldApart) {
  const auto difference = [](const std::string& old, const std::string& by) {
    return difference_of_body(facts(deck_of_run), facts(with(old, by)), "bar");
  };
  EXPECT_EQ(difference("young: 2e11", "young: 1.9e11"), "materials.steel.young has another value in their deck");
  EXPECT_EQ(difference("density: 7850", "density: 7850, loss: 1"),
            "materials.steel.loss has another value in their deck");
  EXPECT_EQ(difference("material: steel", "material: wood"), "bodies.bar.material has another value in their deck");
  EXPECT_EQ(difference("fixed: [rim]", "fixed: [rim, top]"), "bodies.bar.fixed.1 has another value in their deck");
  EXPECT_EQ(difference_of_body(facts(deck_of_run), facts(deck_of_run, "another"), "bar"), "they are of another mesh");
}

TEST(SameBody, EachOfSeveralMaterialsCounts) {
  for (const std::string& keys : {std::string("materials: {core: steel, head: {material: wood}}"),
                                  std::string("layers: [{material: steel}, {material: wood}]")}) {
    const std::string run = with("material: steel", keys);
    std::string modes = run;
    modes.replace(modes.find("1e10"), 4, "2e10");
    EXPECT_EQ(difference_of_body(facts(run), facts(run), "bar"), "");
    EXPECT_EQ(difference_of_body(facts(run), facts(modes), "bar"),
              "materials.wood.young has another value in their deck");
  }
}

TEST(SameBody, FilesThatDoNotSayWhatTheyAreOfAreOfNoBody) {
  const std::string old =
      "an older version of the program wrote one of the files, which does not say which mesh it is about";
  EXPECT_EQ(difference_of_body(facts(deck_of_run), nlohmann::json::object(), "bar"), old);
  EXPECT_EQ(difference_of_body(facts(deck_of_run), facts(deck_of_run), "ball"), old);
}

}  // namespace
}  // namespace idiophone::report
