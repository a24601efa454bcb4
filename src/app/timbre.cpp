#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "commands.hpp"
#include "idiophone/hearing/ears.hpp"
#include "idiophone/parallel/communicator.hpp"
#include "idiophone/scene/sonic_scene.hpp"
#include "idiophone/timbre/music.hpp"
#include "idiophone/timbre/soundtrack.hpp"
#include "progress.hpp"
#include "stop.hpp"
#include "wav_files.hpp"

namespace idiophone::app {

namespace {

/// NAME.wav for a single listener, NAME_LISTENER.wav for several.
std::filesystem::path sound_file(const std::filesystem::path& file, const std::vector<timbre::TrackSound>& sounds,
                                 const timbre::TrackSound& sound) {
  std::filesystem::path path = file;
  if (sounds.size() > 1) {
    path.replace_filename(file.stem().string() + "_" + sound.listener + file.extension().string());
  }
  return path;
}

void write_track(const std::filesystem::path& file, const std::vector<timbre::TrackSound>& sounds,
                 const scene::Scene& scene) {
  for (const timbre::TrackSound& sound : sounds) {
    write_wav(sound_file(file, sounds, sound), sound.samples,
              {.rate = scene.audio.rate,
               .channels = static_cast<int>(sound.channels),
               .format = scene.output.wav,
               .full_scale = scene.output.wav_full_scale,
               .full_scale_key = "wav_full_scale"});
  }
}

void write_music(const scene::Music& music, const timbre::MotionChannels& motion, double duration,
                 std::filesystem::path file) {
  const std::vector<timbre::ScorePart> parts = timbre::compose(music, motion, duration);
  std::size_t notes = 0;
  for (const timbre::ScorePart& part : parts) {
    notes += part.notes.size();
  }
  file.replace_extension(".mid");
  timbre::write_midi(file, parts);
  spdlog::info("{}: {} notes in {} parts", file.string(), notes, parts.size());
}

}  // namespace

int timbre(const TimbreOptions& options) {
  if (parallel::size_of(MPI_COMM_WORLD) > 1) {
    throw std::runtime_error("timbre uses one process; start it without mpirun");
  }
  const scene::SonicScene scene = scene::read_sonic_scene(options.scene, options.overrides);
  hearing::check_heads(scene.scene);
  const timbre::MotionChannels motion(options.result.empty() ? std::nullopt : std::optional(options.result));
  const std::filesystem::path file =
      options.output.empty() ? std::filesystem::path(scene.scene.name + ".wav") : options.output;
  timbre::Soundtrack track(scene.scene, scene.seed);
  timbre::add_sounds(track, scene, motion);
  if (scene.music) {
    write_music(*scene.music, motion, scene.duration, file);
  }
  const int rate = scene.scene.audio.rate;
  Progress progress({.samples = std::llround(scene.duration * rate), .rate = rate, .parts_name = "samples"}, 0,
                    progress_style("auto", 0));
  const auto sounds =
      track.render(scene.duration, scene.reverberation, [&](std::int64_t done) { progress.report(done, ""); });
  write_track(file, sounds, scene.scene);
  spdlog::info("{} sounds started; {:.4g} s of sound in {:.3g} s, {:.3g} times as fast as real time", track.starts(),
               scene.duration, progress.elapsed(), scene.duration / progress.elapsed());
  return exit_finished;
}

}  // namespace idiophone::app
