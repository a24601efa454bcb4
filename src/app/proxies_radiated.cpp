#include "proxies_radiated.hpp"

#include <spdlog/spdlog.h>

#include <ctime>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "idiophone/foundation/version.hpp"
#include "idiophone/run/bodies/finite_element_source.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/loop/progress.hpp"
#include "idiophone/run/loop/run_loop.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/loop/wav_files.hpp"
#include "idiophone/scene/resolved_deck.hpp"

namespace idiophone::app {

namespace {

nlohmann::json proxy_facts(const scene::Scene& scene, const std::vector<proxy_bodies::ProxyBody>& bodies) {
  nlohmann::json facts = {{"deck", scene::resolved_deck(scene.deck, scene.overrides)}};
  for (const proxy_bodies::ProxyBody& body : bodies) {
    facts["bodies"][body.name] = {{"masses", body.lattice->masses().size()},
                                  {"springs", body.lattice->springs().size()},
                                  {"triangles", body.lattice->mesh().surface.size()}};
  }
  return facts;
}

void hear_as_the_score_says(scene::Scene& scene, const score::Score& score) {
  for (const score::ScoreEvent& event : score.events) {
    if (std::holds_alternative<score::Tuning>(event.action)) {
      throw std::runtime_error("--output-folder can't tune a body; leave out the events of type tune, or use --output");
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

int radiate_proxies(scene::Scene scene, const score::Score& score, const std::vector<proxy_bodies::ProxyBody>& bodies,
                    std::vector<proxies::Force> forces, const proxies::ProxyOptions& options,
                    const std::filesystem::path& folder) {
  MPI_Comm communicator = MPI_COMM_WORLD;
  hear_as_the_score_says(scene, score);
  if (!scene.obstacles.empty()) {
    spdlog::warn("obstacles do not reflect or hide the sound of proxies");
  }
  const loop::OutputLock lock(folder, scene.name, communicator);
  proxy_bodies::ProxySource source(bodies, std::move(forces), scene, options);
  parallel::Stages stages;
  propagation::AudioPath audio_path(scene, source.surface(), source.first_sample(), stages, communicator);
  auto result = results::ResultFile::create(
      folder / (scene.name + ".h5"), {scene.name, program_version, scene.deck_text, scene.overrides}, communicator);
  result.note("/run", proxy_facts(scene, bodies));
  record::Recorders recorders;
  const std::int64_t sound = bodies::sound_samples(scene);
  const std::int64_t samples = audio_path.completing_sample(sound) - source.first_sample();
  loop::RunLoop loop({source, audio_path, recorders, result, stages}, {.sound_samples = sound, .samples = samples},
                     communicator);
  loop::watch_signals(loop::OnSignal::note);
  loop.start();
  const std::string job = result.add_job(loop::job_facts(0, 1));
  loop::Progress progress({samples, scene.audio.rate, 1, "audio samples"}, 0, loop::ProgressStyle::silent);
  const std::clock_t begin = std::clock();
  const bool finished = loop.run(std::nullopt, nullptr, progress);
  const double taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  result.note(job, loop::end_facts({loop.advanced(), std::nullopt, progress.elapsed(), progress.processor_time(),
                                    loop::memory_peaks(communicator)},
                                   stages));
  result.flush();
  if (!finished) {
    spdlog::info("the sound up to here is in the result");
    return loop::exit_resumable;
  }
  spdlog::info("{:.4g} s of sound in {:.3g} s of processor time", scene.time.duration, taken);
  loop::watch_signals(loop::OnSignal::end_wavs);
  loop::write_wavs(scene, folder);
  return loop::exit_finished;
}

}  // namespace idiophone::app
