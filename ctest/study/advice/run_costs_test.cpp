#include "idiophone/study/advice/run_costs.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "ranks.hpp"

namespace idiophone::advice {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

ON_RANKS(1);

TEST(ModalProposal, NamesBodiesWhereItSavesTenMinutes) {
  scene::Scene scene;
  scene.bodies.resize(4);
  scene.bodies[0].name = "plate";
  scene.bodies[1].name = "bracket";
  scene.bodies[1].fixed.resize(1);
  scene.bodies[2].name = "hinged";
  scene.bodies[2].fixed.resize(1);
  scene.bodies[2].fixed[0].hinge = true;
  scene.bodies[3].name = "table";
  std::vector<motion::StableStep> steps(4);
  std::ranges::for_each(std::span(steps).first(3), [](auto& limit) { limit.step = 1e-7; });  // the table is held
  scene.audio.max_frequency = 12000;
  EXPECT_THAT(
      modal_proposal(scene, steps, 5 * 3600.0),
      AllOf(HasSubstr("takes 5.0 h"), HasSubstr("up_to: 12000} for plate, bracket saves"), Not(HasSubstr("hinged"))));
  EXPECT_NE(modal_proposal(scene, steps, 601.0), "");
  EXPECT_EQ(modal_proposal(scene, steps, 599.0), "");
  scene.bodies[0].modal.emplace();
  scene.bodies[1].modal.emplace();
  EXPECT_EQ(modal_proposal(scene, steps, 5 * 3600.0), "") << "nothing is left to propose";
}

TEST(RunCosts, LieBetweenLittleAndAllContact) {
  EXPECT_DOUBLE_EQ((RunCosts{.least = 4, .most = 25}).seconds(), 10.0);
}

TEST(RunCosts, AreNotEstimatedWhereNothingWasPlayed) {
  scene::Scene scene;
  const nlohmann::json facts = facts_of({.least = 4, .most = 4, .is_played = false}, scene, {});
  EXPECT_FALSE(facts.at("played"));
  EXPECT_EQ(facts.at("least_seconds"), 4);
  for (const char* unknown : {"seconds", "most_seconds", "contact_seconds"}) {
    EXPECT_TRUE(facts.at(unknown).is_null()) << unknown;
  }
  EXPECT_EQ(facts_of({.least = 4, .most = 25}, scene, {}).at("seconds"), 10);
}

TEST(RunCosts, SayWhyAContactIsNotCounted) {
  scene::Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].name = "fork";
  scene.contacts.resize(2);
  scene.contacts[0].name = "clack";
  scene.contacts[0].other = 0;
  scene.contacts[1].name = "hit";
  scene.contacts[1].other = 1;
  ::testing::internal::CaptureStdout();
  report({.is_played = false}, scene, unknown_costs(scene));
  EXPECT_THAT(::testing::internal::GetCapturedStdout(),
              AllOf(HasSubstr("contact clack: its time is not counted: nobody knows before the run when parts of fork "
                              "touch"),
                    HasSubstr("contact hit: its time is not counted: the run does not fit into this memory")));
}

}  // namespace
}  // namespace idiophone::advice
