// From a deck to bodies that are ready to move, and mistakes that only the mesh shows.

#include "idiophone/run/bodies/preparation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "ranks.hpp"
#include "recorded.hpp"
#include "shared_folder.hpp"

namespace idiophone::bodies {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

const std::string decks = IDIOPHONE_SOURCE_DIR "/ctest/app/decks/";

Preparation prepared(const std::string& deck, const std::vector<std::string>& overrides = {}) {
  return prepare(read_deck(decks + deck, overrides, MPI_COMM_WORLD), MPI_COMM_WORLD);
}

/// What rank 0 says is also known on the others, as a failure elsewhere.
void expect_mistake(const std::string& deck, const std::vector<std::string>& overrides, const std::string& text) {
  try {
    static_cast<void>(prepared(deck, overrides));
    ADD_FAILURE() << "no mistake: " << text;
  } catch (const deck::DeckError& error) {
    EXPECT_EQ(support::rank(), 0);
    EXPECT_THAT(error.what(), HasSubstr(text));
  } catch (const parallel::RemoteFailure&) {
    EXPECT_NE(support::rank(), 0);
  }
}

ON_RANKS(1, 3);

TEST(Preparation, KnowsTheWholeOnEveryRankAndThePartOfEach) {
  const Preparation ready = prepared("touching.yaml");
  ASSERT_THAT(ready.initial_state.masses, SizeIs(2));
  EXPECT_NEAR(ready.initial_state.masses[0], 1100 * 0.12 * 0.06 * 0.03, 1e-9);
  EXPECT_LT(ready.initial_state.masses[1], 400 * 4.0 / 3.0 * 3.1416 * 0.04 * 0.04 * 0.04);  // a polyhedron inside
  EXPECT_EQ(ready.offsets.nodes.back(), ready.part.global_nodes);
  auto owned = static_cast<int>(ready.part.owned_nodes);
  MPI_Allreduce(MPI_IN_PLACE, &owned, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_EQ(owned, ready.part.global_nodes);
  EXPECT_THAT(ready.statistics, SizeIs(support::rank() == 0 ? 2U : 0U));
  EXPECT_THAT(ready.contact_surfaces.stiffness, SizeIs(2));
  EXPECT_FALSE(ready.mesh_hash.empty());
}

TEST(Preparation, ChoosesAStepThatIsSafeAndDividesASample) {
  const Preparation ready = prepared("simple.yaml");
  EXPECT_LE(ready.step(), ready.scene.time.safety * ready.initial_state.stable_step() * (1 + 1e-12));
  EXPECT_EQ(ready.steps_per_sample % ready.steps_per_read, 0);
  EXPECT_NEAR(ready.step() * ready.steps_per_sample * 8000, 1.0, 1e-15);
}

TEST(Preparation, TakesTheStepsOfTheDeck) {
  const int chosen = prepared("simple.yaml").steps_per_sample;
  EXPECT_EQ(prepared("simple.yaml", {"time.steps_per_sample=" + std::to_string(3 * chosen)}).steps_per_sample,
            3 * chosen);
}

TEST(Preparation, HasRadiiOnlyWhereRadiationAsksForThem) {
  for (const char* model : {"rayleigh", "kirchhoff"}) {
    const Preparation ready = prepared("free.yaml", {std::string("radiation.model=") + model});
    EXPECT_THAT(ready.radii, SizeIs(ready.scene.radiation.needs_radii() ? ready.part.surface.size() : 0U)) << model;
  }
}

TEST(Preparation, RefusesModesThatTheMeshCannotHave) {
  expect_mistake("touching.yaml", {"bodies.block.model={type: modal, up_to: 3900}", "materials.rubber.young=1e5"},
                 "bodies.block.model.up_to: waves of 3900 Hz are");
}

TEST(Preparation, RefusesGroupsThatTheMeshDoesNotHave) {
  expect_mistake("simple.yaml", {"bodies.plate.fixed=[edge]"}, "edge");
}

TEST(RunDecks, OfWhichRankZeroIsToldTheMistakeFailEverywhere) {
  expect_mistake("simple.yaml", {"audio.rate=-1"}, "audio.rate");
}

TEST(RunDecks, NeedTheRecordingsThatTheyName) {
  const support::Folder folder;
  expect_mistake("free.yaml", {"bodies.bell.recording=" + (folder / "nothing.h5").string()}, "bodies.bell.recording");
}

}  // namespace
}  // namespace idiophone::bodies
