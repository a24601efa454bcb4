#include "proxies_radiated.hpp"

#include <spdlog/spdlog.h>

#include <ctime>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "commands.hpp"
#include "facts.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "idiophone/source/finite_element_source.hpp"
#include "output_lock.hpp"
#include "progress.hpp"
#include "run_loop.hpp"
#include "stop.hpp"
#include "wav_files.hpp"

namespace idiophone::app {

namespace {

nlohmann::json proxy_facts(const scene::Scene& scene, const std::vector<source::ProxyBody>& bodies) {
  nlohmann::json facts = {{"deck", scene::resolved_deck(scene.deck, scene.overrides)}};
  for (const source::ProxyBody& body : bodies) {
    facts["bodies"][body.name] = {{"masses", body.lattice->masses().size()},
                                  {"springs", body.lattice->springs().size()},
                                  {"triangles", body.lattice->mesh().surface.size()}};
  }
  return facts;
}

void hear_as_the_score_says(scene::Scene& scene, const scene::Score& score) {
  for (const scene::ScoreEvent& event : score.events) {
    if (std::holds_alternative<scene::Tuning>(event.action)) {
      throw std::runtime_error("--result can't tune a body; leave out the events of type tune, or use --output");
    }
  }
  scene.time.duration = score.duration;
  if (scene.radiation.grid.back) {
    throw std::runtime_error("the air cannot act on proxies; leave radiation.back out of the deck");
  }
  if (score.listener) {
    scene.listeners.assign(1, *score.listener);
    scene.listeners.front().name = "listener";
  }
}

}  // namespace

int radiate_proxies(scene::Scene scene, const scene::Score& score, const std::vector<source::ProxyBody>& bodies,
                    std::vector<proxies::Force> forces, const proxies::ProxyOptions& options,
                    const std::filesystem::path& folder) {
  MPI_Comm communicator = MPI_COMM_WORLD;
  hear_as_the_score_says(scene, score);
  if (!scene.obstacles.empty()) {
    spdlog::warn("obstacles do not reflect or hide the sound of proxies");
  }
  const OutputLock lock(folder, scene.name, communicator);
  source::ProxySource source(bodies, std::move(forces), scene, options);
  parallel::Stages stages;
  hearing::AudioPath audio_path(scene, source.surface(), source.first_sample(), stages, communicator);
  auto result = store::ResultFile::create(
      folder / (scene.name + ".h5"), {scene.name, IDIOPHONE_VERSION, scene.deck_text, scene.overrides}, communicator);
  result.note("/run", proxy_facts(scene, bodies));
  record::Recorders recorders;
  const std::int64_t sound = source::sound_samples(scene);
  const std::int64_t samples = audio_path.completing_sample(sound) - source.first_sample();
  RunLoop loop({source, audio_path, recorders, result, stages}, {.sound_samples = sound, .samples = samples},
               communicator);
  watch_signals(OnSignal::note);
  loop.start();
  const std::string job = result.add_job(job_facts(0, 1));
  Progress progress({samples, scene.audio.rate, 1, "audio samples"}, 0, ProgressStyle::silent);
  const std::clock_t begin = std::clock();
  const bool finished = loop.run(std::nullopt, nullptr, progress);
  const double taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  result.note(job, end_facts({loop.advanced(), std::nullopt, progress.elapsed(), progress.processor_time(),
                              memory_peaks(communicator)},
                             stages));
  result.flush();
  if (!finished) {
    spdlog::info("the sound up to here is in the result");
    return exit_resumable;
  }
  spdlog::info("{:.4g} s of sound in {:.3g} s of processor time", scene.time.duration, taken);
  watch_signals(OnSignal::end_wavs);
  write_wavs(scene, folder);
  return exit_finished;
}

}  // namespace idiophone::app
