// From a deck to bodies that are ready to move, and mistakes that only the mesh shows.

#include "idiophone/run/bodies/preparation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <numeric>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
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

TEST(Preparation, GivesTheShapesOfModesToTheRankThatHasTheBody) {
  const Preparation ready = prepared("touching.yaml", {"bodies.block.model={type: modal, count: 4}"});
  const auto& [body, basis] = *ready.modal_bases.begin();
  const mesh::BodyPart& here = ready.part.bodies[body];
  const bool is_here = here.owned_begin < here.owned_end;
  EXPECT_EQ(basis.shapes.size(), is_here ? 3 * basis.modes() * basis.nodes() : 0U);
  EXPECT_GT(basis.nodes(), 0U);
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

/// All numbers of the initial state, and those that follow from it.
std::vector<double> numbers_of(const Preparation& ready) {
  const motion::InitialState& state = ready.initial_state;
  std::vector<double> numbers = {static_cast<double>(ready.steps_per_sample)};
  const auto add = [&](const auto& values) { numbers.insert(numbers.end(), values.begin(), values.end()); };
  for (std::size_t b = 0; b < state.steps.size(); ++b) {
    const motion::StableStep& step = state.steps[b];
    add(std::array{step.largest_frequency, step.damping, step.step, step.highest_loss,
                   static_cast<double>(step.element), state.scaling[b].gain, state.scaling[b].shift});
    add(step.centre);
    add(state.centres[b]);
    add(state.moments[b].reshaped());
  }
  for (const motion::Piece& piece : state.pieces) {
    numbers.push_back(piece.mass);
    add(piece.centre);
    add(piece.moments.reshaped());
  }
  add(state.masses);
  add(state.surface_densities);
  add(state.displacement);
  add(ready.contact_surfaces.stiffness);
  return numbers;
}

ON_RANKS(3);

TEST(Preparation, FindsTheSameInitialStateOnAnyNumberOfRanks) {
  for (const char* deck : {"touching", "joined", "hexahedra", "breaking", "materials", "taut", "rich"}) {
    const std::string name = std::string(deck) + ".yaml";
    const std::vector<double> together = numbers_of(prepared(name));
    std::vector<double> alone;
    scene::Scene scene = read_deck(decks + name, {}, MPI_COMM_WORLD);
    parallel::on_root(MPI_COMM_WORLD, [&] { alone = numbers_of(prepare(std::move(scene), MPI_COMM_SELF)); });
    parallel::broadcast(alone, MPI_COMM_WORLD);
    EXPECT_EQ(together, alone) << deck;
  }
}

}  // namespace
}  // namespace idiophone::bodies
