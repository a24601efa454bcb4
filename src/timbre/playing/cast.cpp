#include "cast.hpp"

#include <fmt/format.h>
#include <mpi.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "idiophone/foundation/version.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_bodies.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/instruments/voices/buffered_voice.hpp"
#include "idiophone/instruments/voices/sound_map_voices.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/scene/body_materials.hpp"
#include "listener_check.hpp"
#include "staged_proxies.hpp"
#include "tree_voice.hpp"

namespace idiophone::timbre {

namespace {

void require_unique(std::vector<std::string> names) {
  std::ranges::sort(names);
  const auto twice = std::ranges::adjacent_find(names);
  if (twice != names.end()) {
    throw std::runtime_error(fmt::format("there is another body with the name {}; give each file once", *twice));
  }
}

}  // namespace

std::vector<std::string> Cast::names() const {
  std::vector<std::string> names;
  for (const sound_maps::SoundMap& map : maps) {
    names.push_back(map.body);
  }
  for (const scene::Scene& deck : decks) {
    std::ranges::transform(deck.bodies, std::back_inserter(names), &scene::Body::name);
  }
  for (const Tree& tree : trees) {
    names.push_back(tree.file.stem().string());
  }
  return names;
}

Cast read_cast(const PlaySettings& settings) {
  Cast cast;
  for (const std::filesystem::path& file : settings.files) {
    if (file.extension() == ".h5") {
      cast.maps.push_back(sound_maps::read_sound_map(file));
    } else if (file.extension() == ".tt") {
      cast.trees.push_back(read_tree_file(file));
    } else {
      cast.decks.push_back(bodies::read_deck(file, settings.deck_overrides, MPI_COMM_SELF));
    }
  }
  require_unique(cast.names());
  return cast;
}

voices::Audience audience_of(const Cast& cast, const score::Score& score, int rate) {
  if (score.listener) {
    return {*score.listener, rate};
  }
  if (!cast.maps.empty()) {
    return voices::audience_of(cast.maps);
  }
  if (!cast.decks.empty()) {
    return {cast.decks.front().listeners.front(), rate};
  }
  return {};
}

void require_maps(const Cast& cast, std::span<const score::BodyContact> contacts) {
  const std::vector<std::string> names = cast.names();
  const auto require_map = [&](std::size_t body) {
    if (body >= cast.maps.size()) {
      throw std::runtime_error(fmt::format("contacts: only sound maps can touch each other; {} is none", names[body]));
    }
  };
  for (const score::BodyContact& contact : contacts) {
    require_map(contact.point.body);
    if (contact.other) {
      require_map(contact.other->body);
    }
  }
}

std::vector<ProxyLevels> levels_of_all(const scene::Scene& deck, int levels, proxy_bodies::Springs springs) {
  std::vector<ProxyLevels> all;
  for (std::size_t body = 0; body < deck.bodies.size(); ++body) {
    all.push_back(proxy_bodies::proxy_levels(deck, body, levels, springs));
    const scene::Body& described = deck.bodies[body];
    if (!described.springs && scene::is_undamped(described, deck.materials)) {
      spdlog::warn("{}: {}", described.name, scene::undamped_in_words);
    }
    for (std::size_t level = 0; level < all.back().size(); ++level) {
      const proxies::Lattice& lattice = *all.back()[level];
      spdlog::info("{}, level {}: {} masses, {} springs, {} tetrahedra", described.name, level, lattice.masses().size(),
                   lattice.springs().size(), lattice.mesh().tetrahedra.size());
    }
  }
  return all;
}

namespace {

/// If there are both sound maps and proxies, else null. Pieces of proxies that break count, too.
std::shared_ptr<voices::SharedBudget> shared_budget(const Cast& cast) {
  constexpr std::size_t most_pieces = 1000;
  if (cast.maps.empty() || cast.decks.empty()) {
    return {};
  }
  return std::make_shared<voices::SharedBudget>(cast.maps.size(), most_pieces);
}

voices::MapDetail map_detail(const PlaySettings& settings, std::shared_ptr<voices::SharedBudget> shared) {
  voices::MapDetail detail{.speed = settings.proxies.speed,
                           .priority = settings.proxies.engine.priority,
                           .behind = settings.proxies.engine.behind,
                           .shared = std::move(shared),
                           .masking = settings.masking};
  detail.budget = settings.proxies.budget.value_or(detail.budget);
  return detail;
}

Origin origin_of(const Cast& cast, const PlaySettings& settings) {
  const bool has_one_deck = cast.decks.size() == 1;
  return {.name = settings.output.stem().string(),
          .code_version = program_version,
          .deck_text = has_one_deck ? cast.decks.front().deck_text : "",
          .overrides = has_one_deck ? cast.decks.front().overrides : std::vector<std::string>{}};
}

}  // namespace

StagedCast staged(Cast cast, const PlaySettings& settings, const score::Score& score, int rate, bool is_live) {
  StagedCast staged;
  staged.origin = origin_of(cast, settings);
  std::vector<std::vector<ProxyLevels>> levels;
  for (const scene::Scene& deck : cast.decks) {
    levels.push_back(levels_of_all(deck, settings.proxies.levels, settings.proxies.springs));
  }
  check_listener(cast, levels, score);
  require_maps(cast, score.contacts);
  const voices::Audience audience = audience_of(cast, score, rate);
  const std::size_t channels = audience.receivers();
  const std::shared_ptr<voices::SharedBudget> shared = shared_budget(cast);
  std::vector<std::unique_ptr<voices::Voice>> all;
  if (!cast.maps.empty()) {
    auto maps = std::make_unique<voices::SoundMapVoices>(voices::shared_maps(std::move(cast.maps)), audience, rate,
                                                         map_detail(settings, shared), score.contacts);
    staged.maps = maps.get();
    all.push_back(std::move(maps));
  }
  const auto add = [&](std::unique_ptr<voices::Voice> voice) {
    const voices::Buffering buffering{.frames = static_cast<std::size_t>(settings.buffer_frames),
                                      .buffers = static_cast<std::size_t>(settings.buffers)};
    if (is_live) {
      voice = std::make_unique<voices::BufferedVoice>(std::move(voice), channels, rate, buffering);
    }
    all.push_back(std::move(voice));
  };
  if (!cast.decks.empty()) {
    auto proxies = proxy_voices(cast.decks, levels, audience, settings, rate, shared, staged.levels);
    staged.proxies = proxies.get();
    if (settings.proxies.frames_per_second > 0.0) {
      proxies->take_film(settings.proxies.frames_per_second);
    }
    add(std::move(proxies));
  }
  for (Tree& tree : cast.trees) {
    std::string name = tree.file.stem().string();
    add(std::make_unique<TreeVoice>(std::move(tree), std::move(name), audience, score.seed + all.size(), rate));
  }
  staged.stage = std::make_unique<voices::Stage>(audience, std::move(all), channels, rate);
  return staged;
}

}  // namespace idiophone::timbre
