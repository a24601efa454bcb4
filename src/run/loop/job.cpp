#include "idiophone/run/loop/job.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/version.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/resources.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/loop/wav_files.hpp"
#include "idiophone/run/results/checkpoint_archive.hpp"

namespace idiophone::loop {

namespace {

/// @throws std::runtime_error with advice when a file of the job is not what the checkpoint needs
template <class Restore>
auto with_advice(const Restore& restore) {
  try {
    return restore();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(
        fmt::format("{}; resuming goes on with this file, so bring it back, or, to start again from the beginning, "
                    "leave --resume out",
                    error.what()));
  }
}

/// A job between its first and its last audio sample.
class RunningJob {
 public:
  /// Assembles the parts, and begins or resumes. Collective.
  RunningJob(const Job& parts, MPI_Comm communicator)
      : parts_(parts),
        communicator_(communicator),
        audio_path_(parts.scene, parts.source.surface(), parts.source.first_sample(), parts.stages, communicator,
                    parts.accelerator),
        checkpoints_(make_checkpoints()),
        checkpoint_(find_checkpoint()),
        result_(make_result()),
        recorders_(parts.recorders ? parts.recorders(result_) : record::Recorders()),
        loop_({parts.source, audio_path_, recorders_, result_, parts.stages}, extent(), communicator) {
    if (propagation::AirLoad* const air = audio_path_.load()) {
      parts.source.couple(*air);
    }
    checkpoint_ ? restore() : loop_.start();
  }

  /// Collective.
  JobEnding perform() {
    const std::int64_t begun_at = loop_.advanced();
    const std::string job = result_.add_job(facts_of_beginning());
    const RunLoop::Extent whole = extent();
    Progress progress(
        {whole.samples, parts_.scene.audio.rate, whole.steps_per_sample, parts_.step ? "steps" : "audio samples"},
        begun_at, parts_.progress);
    const bool is_finished = loop_.run(parts_.wall_clock_limit, checkpoints_ ? &*checkpoints_ : nullptr, progress);
    const double processor_time = progress.processor_time();
    parts_.source.report();
    const std::optional<double> element_steps = element_steps_since(begun_at);
    result_.note(job, end_facts({loop_.advanced(), element_steps, progress.elapsed(), processor_time,
                                 memory_peaks(communicator_)},
                                parts_.stages));
    result_.flush();
    if (is_finished || checkpoints_) {
      progress.conclude(speed_text(element_steps, progress.elapsed()), parts_.stages);
    }
    if (is_finished) {
      for (const auto& recorder : recorders_) {
        recorder->finish();
      }
    }
    return {is_finished ? exit_finished : exit_resumable, processor_time};
  }

 private:
  [[nodiscard]] std::filesystem::path result_path() const { return parts_.folder / (parts_.scene.name + ".h5"); }

  [[nodiscard]] std::optional<CheckpointSchedule> make_checkpoints() const {
    if (!parts_.checkpoints) {
      return {};
    }
    return CheckpointSchedule(parts_.folder / (parts_.scene.name + "_checkpoints"), parts_.checkpoints->identity,
                              parts_.scene.output, communicator_);
  }

  [[nodiscard]] std::optional<results::CheckpointReader> find_checkpoint() const {
    return parts_.checkpoints && parts_.checkpoints->resume ? checkpoints_->find(parts_.checkpoints->continued)
                                                            : std::nullopt;
  }

  [[nodiscard]] results::ResultFile make_result() const {
    watch_signals(OnSignal::note);  // from here on there is something to lose
    if (checkpoint_) {
      return with_advice([&] { return results::ResultFile::open(result_path(), communicator_); });
    }
    const scene::Scene& scene = parts_.scene;
    auto result = results::ResultFile::create(
        result_path(), {scene.name, program_version, scene.deck_text, scene.overrides}, communicator_);
    result.note("/run", parts_.facts());
    return result;
  }

  [[nodiscard]] RunLoop::Extent extent() const {
    const StepSize step = parts_.step.value_or(StepSize{});
    return {parts_.sound_samples,
            parts_.samples.value_or(audio_path_.completing_sample(parts_.sound_samples) - parts_.source.first_sample()),
            step.steps_per_sample, step.nodes};
  }

  void restore() {
    results::RestoringArchive archive(*checkpoint_, communicator_);
    with_advice([&] { loop_.archive(archive); });
    if (parallel::is_root(communicator_)) {
      spdlog::info("resuming from {} at {:.6g} s", checkpoint_->path().string(),
                   static_cast<double>(checkpoint_->moment().sample) / parts_.scene.audio.rate);
    }
  }

  [[nodiscard]] nlohmann::json facts_of_beginning() const {
    nlohmann::json facts = job_facts(loop_.advanced(), parallel::size_of(communicator_));
    if (parts_.job_facts) {
      facts.update(parts_.job_facts());
    }
    return facts;
  }

  /// Elements times steps that this job did; none where the motion is given.
  [[nodiscard]] std::optional<double> element_steps_since(std::int64_t begun_at) const {
    if (!parts_.step) {
      return {};
    }
    return static_cast<double>(loop_.advanced() - begun_at) * parts_.step->steps_per_sample * parts_.step->elements;
  }

  [[nodiscard]] std::string speed_text(const std::optional<double>& element_steps, double elapsed) const {
    if (element_steps) {
      return fmt::format("{:.4g} million elements a second and core, everything included",
                         *element_steps / elapsed / parallel::size_of(communicator_) / 1e6);
    }
    const auto samples = static_cast<double>(std::max<std::int64_t>(extent().samples, 1));
    return fmt::format("{:.3g} times as long as the sound", elapsed * parts_.scene.audio.rate / samples);
  }

  const Job& parts_;
  MPI_Comm communicator_;
  propagation::AudioPath audio_path_;
  std::optional<CheckpointSchedule> checkpoints_;
  std::optional<results::CheckpointReader> checkpoint_;  ///< that it is resumed from
  results::ResultFile result_;
  record::Recorders recorders_;
  RunLoop loop_;
};

}  // namespace

JobEnding perform(const Job& job, MPI_Comm communicator) {
  warn_of_bound_ranks(communicator);
  const JobEnding ending = RunningJob(job, communicator).perform();  // the result is closed now
  if (ending.status == exit_finished) {
    watch_signals(OnSignal::end_wavs);  // the result is complete but for its WAV files
    parallel::on_root(communicator, [&] { write_wavs(job.scene, job.folder); });
  }
  return ending;
}

}  // namespace idiophone::loop
