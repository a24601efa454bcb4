#pragma once
// The bodies of a performance, from their files.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/origin.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/instruments/voices/proxy_voices.hpp"
#include "idiophone/instruments/voices/sound_map_voices.hpp"
#include "idiophone/instruments/voices/stage.hpp"
#include "idiophone/timbre/language/timbre_tree.hpp"
#include "idiophone/timbre/playing/playing.hpp"

namespace idiophone::results {
class ResultFile;
}

namespace idiophone::timbre {

using ProxyLevels = std::vector<std::shared_ptr<const proxies::Lattice>>;

/// Sound maps, then the bodies of decks, then trees.
struct Cast {
  std::vector<sound_maps::SoundMap> maps;
  std::vector<scene::Scene> decks;
  std::vector<Tree> trees;

  /// Of all bodies, in the order in which the stage has them. A tree has the name of its file.
  [[nodiscard]] std::vector<std::string> names() const;
};

/// @throws std::runtime_error for files that can't be read, and bodies of the same name
[[nodiscard]] Cast read_cast(const PlaySettings& settings);

/// @throws std::runtime_error when others than sound maps are to touch each other
void require_maps(const Cast& cast, std::span<const score::BodyContact> contacts);

/// The listener of the score, else of the maps, else of the first deck, else nobody.
[[nodiscard]] voices::Audience audience_of(const Cast& cast, const score::Score& score, int rate);

/// The levels of all bodies of a deck, with their sizes in the log.
[[nodiscard]] std::vector<ProxyLevels> levels_of_all(const scene::Scene& deck, int levels,
                                                     proxy_bodies::Springs springs);

/// A stage with the whole cast.
struct StagedCast {
  std::unique_ptr<voices::Stage> stage;
  voices::SoundMapVoices* maps = nullptr;  ///< on the stage; null if there are none
  voices::ProxyVoices* proxies = nullptr;  ///< on the stage; null if there are none
  std::vector<LevelSize> levels;           ///< of the proxies
  Origin origin;                           ///< of a result: the name of its file, and the deck if there is only one
};

/// @param cast     is moved from
/// @param is_live  voices that allocate are computed ahead
[[nodiscard]] StagedCast staged(Cast cast, const PlaySettings& settings, const score::Score& score, int rate,
                                bool is_live);

/// Meshes and frames. @throws std::runtime_error when they can't be written
void write_film(const voices::ProxyFilm& film, results::ResultFile& result);

/// What was heard of the sound maps, if they had a budget: a line in the log, and the file of the settings.
[[nodiscard]] std::optional<MapFacts> report_detail(voices::SoundMapVoices& maps, const PlaySettings& settings,
                                                    int rate);

/// What happened to the proxies, without their levels: lines in the log, and the file of the settings.
[[nodiscard]] ProxyFacts report_choices(voices::ProxyVoices& proxies, const ProxySettings& settings, int rate);

}  // namespace idiophone::timbre
