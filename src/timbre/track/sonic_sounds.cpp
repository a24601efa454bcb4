#include "idiophone/timbre/track/sonic_sounds.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "idiophone/air/propagation/ears.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/run/loop/progress.hpp"
#include "music.hpp"

namespace idiophone::timbre {

std::vector<timbre::TrackSound> rendered_sounds(const timbre::SonicScene& scene, const timbre::MotionChannels& motion,
                                                loop::ProgressWish progress) {
  timbre::Soundtrack track(scene.scene, scene.seed);
  timbre::add_sounds(track, scene, motion);
  const int rate = scene.scene.audio.rate;
  loop::Progress shown({.samples = std::llround(scene.duration * rate), .rate = rate, .parts_name = "samples"}, 0,
                       loop::progress_style(progress, 0));
  std::vector<timbre::TrackSound> sounds =
      track.render(scene.duration, scene.reverberation, [&](std::int64_t done) { shown.report(done, ""); });
  const std::size_t late = track.starts_from(scene.duration);
  spdlog::info("{} sounds started; {:.4g} s of sound in {:.3g} s, {:.3g} times as fast as real time",
               track.starts() - late, scene.duration, shown.elapsed(), scene.duration / shown.elapsed());
  if (late > 0) {
    spdlog::warn("{} sounds start after the end of the scene and are left out; its duration is {:.4g} s", late,
                 scene.duration);
  }
  return sounds;
}

void write_music(const timbre::SonicScene& scene, const timbre::MotionChannels& motion, std::filesystem::path file) {
  if (!scene.music) {
    return;
  }
  const MusicScore score = compose(scene, motion, scene.duration);
  std::size_t notes = 0;
  for (const ScorePart& part : score.parts) {
    notes += part.notes.size();
  }
  write_midi(file.replace_extension(".mid"), score);
  spdlog::info("{}: {} notes in {} parts", file.string(), notes, score.parts.size());
  write_musicxml(file.replace_extension(".musicxml"), score);
}

SceneOfRun::SceneOfRun(const std::filesystem::path& scene, MPI_Comm communicator) : communicator_(communicator) {
  parallel::on_root(communicator, [&] {
    scene_ = timbre::read_sonic_scene(scene, {});
    propagation::check_heads(scene_.scene);
  });
  if (!parallel::is_root(communicator)) {
    scene_ = timbre::read_sonic_scene(scene, {});
  }
}

std::string SceneOfRun::text() const {
  std::string text = scene_.scene.deck_text;
  for (const timbre::SoundClass& sound_class : scene_.classes) {
    text += deck::read_text(sound_class.tree);
  }
  return text;
}

std::vector<spectra::Series> SceneOfRun::tables() const {
  const scene::Scene& scene = scene_.scene;
  const std::string path = "/audio/" + scene.name;
  const std::string description = "sound of the sonic scene " + scene.name + ", bound to the motion of this run";
  const auto rate = static_cast<double>(scene.audio.rate);
  if (scene.listeners.empty()) {
    return {{path, "Pa", rate, {scene.name}, description, {}}};
  }
  std::vector<spectra::Series> tables;
  for (const scene::Listener& listener : scene.listeners) {
    spectra::Series& table =
        tables.emplace_back(spectra::Series{path + "_" + listener.name, "Pa", rate, {}, description, {}});
    for (const scene::Receiver& receiver : listener.receivers) {
      table.columns.push_back(scene.name + "_" + receiver.channel);
      table.positions.push_back({receiver.position[0], receiver.position[1], receiver.position[2]});
    }
  }
  return tables;
}

void SceneOfRun::declare(results::ResultFile& result) const {
  for (const spectra::Series& table : tables()) {
    result.declare(table);
  }
  result.note("/run", {{"sonic_scene", scene_.scene.deck_text}});
}

namespace {

/// The channels that a scene needs.
/// @throws deck::DeckError if the run does not have them
std::set<std::string> channels_of(const SonicScene& scene, const std::vector<spectra::Series>& channels) {
  std::set<std::string> named;
  const MotionChannels motion(channels, named);
  Soundtrack track(scene.scene, scene.seed);
  add_sounds(track, scene, motion);
  if (scene.music) {
    static_cast<void>(compose(scene, motion, 0.0));
  }
  return named;
}

}  // namespace

void SceneOfRun::bind(bodies::Channels& channels, results::ResultFile& result, const std::filesystem::path& path) {
  result.flush();  // so that it can be read
  parallel::on_root(communicator_, [&] {
    channels_ = channels.all();
    const results::SeriesReader earlier(path);
    for (const std::string& name : channels_of(scene_, channels_)) {
      const spectra::Series& series = earlier.find(name);
      if (earlier.rows(series) > 0) {
        earlier.require_intact(series);
      }
      rows_[name] = earlier.read(series);
      channels.subscribe(name, [this](const spectra::Series& channel, std::span<const double> rows) {
        std::vector<double>& kept = rows_[channel.path];
        kept.insert(kept.end(), rows.begin(), rows.end());
      });
    }
  });
}

void SceneOfRun::render(results::ResultFile& result, const std::filesystem::path& path,
                        loop::ProgressWish progress) const {
  const std::vector<spectra::Series> all = tables();
  std::vector<timbre::TrackSound> sounds(all.size());
  parallel::on_root(communicator_, [&] {
    spdlog::info("sounds of the sonic scene {}", scene_.scene.name);
    const timbre::MotionChannels motion(channels_, rows_);
    sounds = rendered_sounds(scene_, motion, progress);
    write_music(scene_, motion, path.parent_path() / (path.stem().string() + "_" + scene_.scene.name + ".mid"));
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    result.append(all[i].path, sounds[i].samples);
  }
  result.flush();
}

}  // namespace idiophone::timbre
