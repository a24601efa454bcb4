#include "idiophone/hearing/audio_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace idiophone::hearing {

namespace {

surface::SurfacePressure surface_pressure(const scene::Scene& scene, const std::vector<double>& radii) {
  using Field = surface::SurfacePressure::Field;
  if (!scene.radiation.asks_for_radii()) {
    return {};
  }
  const bool pulsating = scene.radiation.surface_pressure == scene::SurfacePressure::pulsating;
  return {pulsating ? Field::pulsating : Field::oscillating, radii, scene.radiation.air.speed / scene.audio.rate};
}

}  // namespace

AudioPath::AudioPath(const scene::Scene& scene, const source::AudibleSurface& surface, std::int64_t steady,
                     parallel::Stages& stages, MPI_Comm communicator)
    : scene_(scene),
      stages_(stages),
      communicator_(communicator),
      emitter_(surface.triangles, scene.audio.dc_loss, surface_pressure(scene, surface.radii)),
      ears_(scene, steady + 1, surface.triangles.size()),
      emitted_(steady) {
  if (const auto& visibility = scene.radiation.visibility) {
    line_of_sight_.emplace(
        surface,
        LineOfSight::Options{visibility->interval(scene.audio.rate), ears_.ear_count(), ears_.own_body_hides()},
        communicator_);
  }
}

void AudioPath::start(const surface::SurfaceMotion& steady) {
  emitter_.start(steady);
  if (line_of_sight_) {
    line_of_sight_->start(steady, ears_.positions(emitted_));
  }
}

void AudioPath::declare(store::ResultFile& result) const {
  for (const auto& listener : scene_.listeners) {
    store::Series series{"/audio/" + listener.name,
                         std::string(ears_.model().unit()),
                         static_cast<double>(scene_.audio.rate),
                         {},
                         std::string(ears_.model().description()),
                         {}};
    for (const auto& receiver : listener.receivers) {
      series.columns.push_back(receiver.channel);
      series.positions.push_back({receiver.position[0], receiver.position[1], receiver.position[2]});
    }
    result.declare(series);
  }
  for (const auto& reference : scene_.references) {
    result.add_reference(reference.name, reference.frequencies);
  }
}

void AudioPath::hear(const surface::SurfaceMotion& motion) {
  {
    const parallel::Stages::Scope stage(stages_, parallel::Stage::surface);
    emitter_.emit(motion, emission_);
  }
  ++emitted_;
  if (line_of_sight_ && line_of_sight_->due(emitted_)) {
    const parallel::Stages::Scope stage(stages_, parallel::Stage::visibility);
    line_of_sight_->look(motion, ears_.positions(emitted_));
  }
  try {
    const parallel::Stages::Scope stage(stages_, parallel::Stage::radiation);
    ears_.hear(emitted_, emission_, line_of_sight_ ? &*line_of_sight_ : nullptr);
  } catch (const std::runtime_error& error) {
    complaint_ = error.what();  // the others still wait for this rank's nodes: told at the end of the block
  }
}

void AudioPath::write(store::ResultFile& result, std::int64_t most) {
  const std::int64_t final_samples = std::min(ears_.final_before(emitted_), most);
  if (final_samples <= written_) {
    return;
  }
  const std::vector<std::vector<double>> sounds =
      ears_.take(static_cast<std::size_t>(final_samples - written_), communicator_);
  written_ = final_samples;
  for (std::size_t l = 0; l < sounds.size(); ++l) {
    result.append("/audio/" + scene_.listeners[l].name, sounds[l]);
    for (const double value : sounds[l]) {
      loudest_ = std::max(loudest_, std::abs(value));
    }
  }
}

void AudioPath::save(store::CheckpointWriter& checkpoint, const parallel::Rows& triangles) {
  std::vector<double> emitters(emitter_.state_size() * emitter_.triangles());
  emitter_.save(emitters);
  checkpoint.add_rows("surface/emitter", triangles, static_cast<int>(emitter_.state_size()),
                      std::span<const double>(emitters));
  if (line_of_sight_) {
    checkpoint.add_rows("radiation/visibility", triangles, static_cast<int>(line_of_sight_->state_size()),
                        std::span<const double>(line_of_sight_->save()));
  }
  const auto pending = ears_.pending(communicator_);
  for (std::size_t e = 0; e < pending.size(); ++e) {
    checkpoint.add_root(fmt::format("listening/ear_{}", e), std::span<const std::int64_t>(pending[e]));
  }
  if (const std::size_t width = ears_.triangle_state_size(); width > 0) {
    std::vector<double> heads(width * emitter_.triangles());
    ears_.save_triangles(heads);
    checkpoint.add_rows("listening/heads", triangles, static_cast<int>(width), std::span<const double>(heads));
  }
  const std::array<std::int64_t, 2> counts = {written_, emitted_};
  checkpoint.add_root("listening/counts", std::span<const std::int64_t>(counts));
  checkpoint.add_root("listening/loudest", std::span<const double>(&loudest_, 1));
}

void AudioPath::restore(const store::CheckpointReader& checkpoint, const parallel::Rows& triangles) {
  emitter_.restore(checkpoint.read_rows("surface/emitter", triangles, static_cast<int>(emitter_.state_size())));
  if (line_of_sight_) {
    line_of_sight_->restore(
        checkpoint.read_rows("radiation/visibility", triangles, static_cast<int>(line_of_sight_->state_size())));
  }
  std::vector<std::vector<std::int64_t>> pending;
  for (std::size_t e = 0; e < ears_.ear_count(); ++e) {
    pending.push_back(checkpoint.read_integer_root(fmt::format("listening/ear_{}", e)));
  }
  int rank = 0;
  MPI_Comm_rank(communicator_, &rank);
  ears_.restore(pending, rank == 0);
  if (const std::size_t width = ears_.triangle_state_size(); width > 0) {
    ears_.restore_triangles(checkpoint.read_rows("listening/heads", triangles, static_cast<int>(width)));
  }
  const std::vector<std::int64_t> counts = checkpoint.read_integer_root("listening/counts");
  written_ = counts.at(0);
  emitted_ = counts.at(1);
  loudest_ = checkpoint.read_root("listening/loudest").at(0);
}

}  // namespace idiophone::hearing
