// The resolved deck: a deck that says all that was read, and is read as the same.

#include <fstream>
#include <iterator>
#include <set>

#include "deck_fixture.hpp"
#include "every_key.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/scene/listening.hpp"
#include "idiophone/scene/resolved_deck.hpp"

namespace idiophone::scene {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// The keys of a deck's section; empty where there is no such section.
std::set<std::string> keys_at(const std::string& yaml, const std::string& path) {
  deck::Mistakes mistakes;
  const deck::Node tree = deck::read_tree(yaml, "resolved", {}, mistakes);
  const deck::Node* place = &tree;
  for (std::size_t start = 0; start < path.size();) {
    const std::size_t end = std::min(path.find('.', start), path.size());
    const auto found = std::ranges::find(place->children, path.substr(start, end - start), &deck::Node::key);
    if (found == place->children.end()) {
      return {};
    }
    place = &*found;
    start = end + 1;
  }
  std::set<std::string> keys;
  for (const auto& child : place->children) {
    keys.insert(child.key);
  }
  return keys;
}

}  // namespace

class Resolved : public DeckTest {
 protected:
  [[nodiscard]] std::string resolve(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    write("deck.yaml", text);
    return resolved_deck(folder / "deck.yaml", overrides);
  }

  /// Writes a resolved deck to another folder: its files are absolute.
  [[nodiscard]] std::filesystem::path again(const std::string& yaml) const {
    write("shapes/again.yaml", yaml);
    return folder / "shapes/again.yaml";
  }
};

TEST_F(Resolved, SaysOverridesAndDefaults) {
  EXPECT_THAT(resolve(plate, {"time.safety=0.5", "audio.rate=8000"}),
              AllOf(HasSubstr("name: plate\ntime:\n  duration: 1.0\n  safety: 0.5\n"), HasSubstr("rate: 8000"),
                    HasSubstr("max_frequency: 4000"), HasSubstr("dc_corner: 10"), Not(HasSubstr("dc_block")),
                    HasSubstr("mesh: " + (folder / "plate.geo").string()), HasSubstr("gravity: [0, 0, 0]"),
                    HasSubstr("model: kirchhoff"), HasSubstr("speed: 343"), HasSubstr("keep: 3")));
}

TEST_F(Resolved, SaysTheDcBlockOfThePapersModel) {
  EXPECT_THAT(resolve(plate, {"radiation.model=huygens"}),
              AllOf(HasSubstr("dc_block: 0.1"), Not(HasSubstr("dc_corner"))));
}

TEST_F(Resolved, OfAResolvedDeckIsTheSame) {
  for (const std::string& deck :
       {plate, every_key(plate), every_key(plate, in_a_room), every_key(plate, with_screens)}) {
    const std::string once = resolve(deck);
    EXPECT_EQ(resolved_deck(again(once)), once);
  }
}

TEST_F(Resolved, IsReadAsTheSameNumbers) {
  const std::vector<std::string> overrides = {"radiation.air.temperature=-7.3", "audio.dc_corner=12.7"};
  const std::string maple = replaced(plate, "steel: {young: 2.0e11, poisson: 0.3, density: 7850}",
                                     "steel: {from: maple, damping: {loss_factor: table}}");
  const Scene first = read(maple, overrides);
  const Scene second = read_deck(again(resolve(maple, overrides)));
  EXPECT_EQ(second.radiation.air.speed, first.radiation.air.speed);
  EXPECT_EQ(second.radiation.air.density, first.radiation.air.density);
  EXPECT_EQ(second.audio.dc_loss, first.audio.dc_loss);
  EXPECT_EQ(second.materials[0].orthotropy->shear, first.materials[0].orthotropy->shear);
  EXPECT_EQ(second.materials[0].damping.loss->value, first.materials[0].damping.loss->value);
}

TEST_F(Resolved, SaysEveryKeyThatHasADefault) {
  for (const auto& [section, keys] : documented_keys()) {
    const std::string path = every_path().at(section);
    const std::string yaml = resolve(every_key_at(plate, path));
    const std::set<std::string> said = keys_at(yaml, path);
    for (const auto& [key, has_default] : keys) {
      EXPECT_TRUE(!has_default || said.contains(key)) << section << ": " << key << "\n" << yaml;
    }
  }
}

TEST_F(Resolved, OfListeningIsReadAgain) {
  for (const char* radiation : {"", "radiation: {model: rayleigh}\n", "radiation: {model: waves, cell: 0.05}\n",
                                "radiation: {air: {absorption: true, speed: 340}}\n"}) {
    SCOPED_TRACE(radiation);
    const RecordedDeck recorded{
        .recording = folder / "plate.h5", .name = "plate", .text = plate + radiation, .overrides = {}, .air = {}};
    const std::string once = resolved_listening(recorded, {}, {});
    EXPECT_EQ(resolved_listening(recorded, again(once), {}), once);
  }
}

/// Sonic scenes have no bodies (docs/use/timbre.md).
bool is_deck(const std::filesystem::path& path) {
  if (path.extension() != ".yaml") {
    return false;
  }
  std::ifstream file(path);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  return text.find("\nbodies:") != std::string::npos;
}

TEST_F(Resolved, OfEveryShippedDeckIsTheSame) {
  int decks = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(IDIOPHONE_SOURCE_DIR "/inputs")) {
    if (!is_deck(file.path())) {
      continue;
    }
    SCOPED_TRACE(file.path());
    const std::string once = resolved_deck(file.path());
    EXPECT_EQ(resolved_deck(again(once)), once);
    ++decks;
  }
  EXPECT_GT(decks, 10);
}

}  // namespace idiophone::scene
