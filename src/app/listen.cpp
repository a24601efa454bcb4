// Listening again: sound of a recorded surface motion, at the listeners of a deck.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "blocks.hpp"
#include "commands.hpp"
#include "idiophone/hearing/audio_path.hpp"
#include "idiophone/parallel/on_root.hpp"
#include "idiophone/record/surface_recorder.hpp"
#include "idiophone/scene/listening.hpp"
#include "idiophone/source/recorded_motion.hpp"
#include "idiophone/store/surface_motion_reader.hpp"
#include "progress.hpp"
#include "stop.hpp"
#include "wav_files.hpp"

namespace idiophone::app {

namespace {

/// The recording beside a result, or the recording itself.
store::SurfaceMotionReader open_recording(const std::filesystem::path& file) {
  const auto beside = record::recording_of(file);
  if (!std::filesystem::exists(file) || !std::filesystem::exists(beside)) {
    try {
      return store::SurfaceMotionReader(file);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(
          fmt::format("{}; there is no {} either: runs write it if their deck says output: {{surface_motion: true}}",
                      error.what(), beside.string()));
    }
  }
  return store::SurfaceMotionReader(beside);
}

scene::Scene read_scene(const ListenOptions& options, const store::RecordingHeader& header) {
  return scene::read_listening({options.recording,
                                header.origin.name,
                                header.origin.deck_text,
                                header.origin.overrides,
                                static_cast<int>(header.rate),
                                {header.air_density, header.air_speed}},
                               options.deck, options.overrides);
}

void require_new_file(const std::filesystem::path& result, const std::filesystem::path& recording) {
  std::error_code ignored;  // what is not there is not overwritten
  for (const auto& mine : {recording, record::recording_of(recording)}) {
    for (const auto& made : {result, record::recording_of(result)}) {
      if (std::filesystem::equivalent(made, mine, ignored)) {
        throw std::runtime_error(fmt::format(
            "{} belongs to the recording and would be overwritten; give the deck another name, or another --output",
            result.string()));
      }
    }
  }
}

/// Ranks agree on what happened to any of them. @throws std::runtime_error, on all, with the first one's complaint
void share_complaint(std::string complaint, MPI_Comm communicator) {
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &ranks);
  int first = complaint.empty() ? ranks : rank;
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, communicator);
  if (first == ranks) {
    return;
  }
  auto length = static_cast<int>(complaint.size());
  MPI_Bcast(&length, 1, MPI_INT, first, communicator);
  complaint.resize(static_cast<std::size_t>(length));
  MPI_Bcast(complaint.data(), length, MPI_CHAR, first, communicator);
  throw std::runtime_error("the recorded motion can't be heard: " + complaint);
}

class Listening {
 public:
  Listening(const scene::Scene& scene, const store::SurfaceMotionReader& reader, const std::filesystem::path& result,
            MPI_Comm communicator)
      : reader_(reader),
        communicator_(communicator),
        rank_(rank_of(communicator)),
        motion_(reader, rank_, ranks_of(communicator)),
        audio_path_(scene, motion_.surface(scene.radiation.asks_for_radii()), reader.header().first_sample, stages_,
                    communicator),
        result_(store::ResultFile::create(result, {scene.name, IDIOPHONE_VERSION, scene.deck_text, scene.overrides},
                                          communicator)) {
    audio_path_.declare(result_);
    motion_.take(moving_);
    audio_path_.start(moving_);
  }

  /// To the end of the recording, or until it is told to stop. @return the exit status
  int listen(bool progress_line) {
    const std::int64_t last = reader_.rows() - 1;
    const auto rate = static_cast<int>(reader_.header().rate);
    Progress progress({last, rate, 1, "audio samples"}, 0, progress_line, rank_ == 0);
    std::int64_t block = first_block;
    int signal = 0;
    std::int64_t heard = 0;
    while (heard < last && signal == 0) {
      const double start = MPI_Wtime();
      const std::int64_t length = std::min(block, last - heard);
      hear(length);
      heard += length;
      signal = noted_signal();
      MPI_Allreduce(MPI_IN_PLACE, &signal, 1, MPI_INT, MPI_MAX, communicator_);
      block = next_block(block, MPI_Wtime() - start, longest_block);
      MPI_Bcast(&block, 1, MPI_INT64_T, 0, communicator_);
      progress.tell(heard, fmt::format("loudest {:.3g}", audio_path_.loudest()));
    }
    if (heard < last) {
      spdlog::info("stopped by signal {}: the sound up to here is in the result; listening begins anew next time",
                   signal);
      return exit_resumable;
    }
    progress.conclude(fmt::format("{:.3g} times as long as the sound",
                                  progress.elapsed() * rate / static_cast<double>(std::max<std::int64_t>(last, 1))),
                      stages_);
    return exit_finished;
  }

 private:
  static int rank_of(MPI_Comm communicator) {
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    return rank;
  }
  static int ranks_of(MPI_Comm communicator) {
    int ranks = 1;
    MPI_Comm_size(communicator, &ranks);
    return ranks;
  }

  /// One block.
  void hear(std::int64_t length) {
    MPI_Pcontrol(1);  // inside a block nobody waits for all: no collective calls
    for (std::int64_t i = 0; i < length; ++i) {
      {
        const parallel::Stages::Scope stage(stages_, parallel::Stage::store);
        motion_.take(moving_);
      }
      audio_path_.hear(moving_);
    }
    MPI_Pcontrol(0);
    share_complaint(audio_path_.complaint(), communicator_);
    const parallel::Stages::Scope stage(stages_, parallel::Stage::store);
    audio_path_.write(result_, reader_.header().samples);
    result_.flush();
  }

  const store::SurfaceMotionReader& reader_;
  MPI_Comm communicator_;
  int rank_;
  parallel::Stages stages_;
  source::RecordedMotion motion_;
  surface::SurfaceMotion moving_;
  hearing::AudioPath audio_path_;
  store::ResultFile result_;
};

void require_sound(const store::SurfaceMotionReader& reader, const std::filesystem::path& path) {
  if (reader.rows() - 1 + reader.header().first_sample < 1 || reader.header().samples < 1) {
    throw std::runtime_error(fmt::format("{}: {} audio samples from {} on hold no sound yet", path.string(),
                                         reader.rows(), reader.header().first_sample));
  }
}

void report(const scene::Scene& scene, const store::SurfaceMotionReader& reader) {
  const auto& header = reader.header();
  spdlog::info("recording of '{}': {} triangles, {:.6g} s at {} Hz", header.origin.name, reader.triangles(),
               static_cast<double>(reader.rows() - 1) / header.rate, header.rate);
  if (header.origin.code_version != IDIOPHONE_VERSION && !header.origin.code_version.empty()) {
    spdlog::info("  recorded by version {}; this is {}", header.origin.code_version, IDIOPHONE_VERSION);
  }
  if (reader.rows() - 1 + header.first_sample < header.samples) {
    spdlog::warn("  it ends before the sound does: {} of {} audio samples", reader.rows() - 1 + header.first_sample,
                 header.samples);
  }
  for (const auto& listener : scene.listeners) {
    for (const auto& receiver : listener.receivers) {
      spdlog::info("  {} at ({:.4g}, {:.4g}, {:.4g}) m", receiver.channel, receiver.position[0], receiver.position[1],
                   receiver.position[2]);
    }
  }
}

}  // namespace

int listen(const ListenOptions& options) {
  MPI_Comm communicator = MPI_COMM_WORLD;
  watch_signals();
  // Rank 0 answers for file and deck; the others read them only once they are known to be right.
  std::optional<store::SurfaceMotionReader> reader;
  scene::Scene scene;
  const auto read = [&] {
    reader = open_recording(options.recording);
    scene = read_scene(options, reader->header());
  };
  parallel::on_root(communicator, [&] {
    read();
    hearing::check_heads(scene);
    require_sound(*reader, options.recording);
    require_new_file(options.output / (scene.name + ".h5"), options.recording);
    std::filesystem::create_directories(options.output);
    report(scene, *reader);
  });
  if (!reader) {
    read();
  }
  int status = exit_failed;
  {
    Listening listening(scene, *reader, options.output / (scene.name + ".h5"), communicator);
    status = listening.listen(progress_line(options.progress));
  }
  if (status == exit_finished) {
    parallel::on_root(communicator, [&] { write_wavs(scene, options.output); });
  }
  return status;
}

}  // namespace idiophone::app
