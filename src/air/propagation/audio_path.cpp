#include "idiophone/air/propagation/audio_path.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "coupled_air.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "straight_air.hpp"
#include "wave_air.hpp"

namespace idiophone::propagation {

namespace {

surface::SurfacePressure surface_pressure(const scene::Acoustics& acoustics, const std::vector<double>& radii) {
  using Field = surface::SurfacePressure::Field;
  if (!acoustics.radiation.needs_radii()) {
    return {};
  }
  const bool pulsating = acoustics.radiation.surface_pressure == scene::SurfacePressureModel::pulsating;
  return {pulsating ? Field::pulsating : Field::oscillating, radii,
          acoustics.radiation.air.speed / acoustics.audio.rate};
}

std::unique_ptr<Air> make_air(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface,
                              std::int64_t steady, parallel::Stages& stages, MPI_Comm communicator,
                              accelerator::Accelerator* accelerator) {
  if (acoustics.radiation.grid.back) {
    return std::make_unique<CoupledAir>(acoustics, surface, steady, stages, communicator, accelerator);
  }
  if (acoustics.radiation.model == scene::RadiationModel::waves) {
    return std::make_unique<WaveAir>(acoustics, surface, steady, stages, communicator, accelerator);
  }
  return std::make_unique<StraightAir>(acoustics, surface, steady, stages, communicator);
}

}  // namespace

AudioPath::AudioPath(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface, std::int64_t steady,
                     parallel::Stages& stages, MPI_Comm communicator, accelerator::Accelerator* accelerator)
    : acoustics_(acoustics),
      stages_(stages),
      communicator_(communicator),
      triangle_rows_(surface.triangle_ids, surface.global_triangles(), communicator),
      emitter_(surface.triangles, acoustics.audio.dc_loss, surface_pressure(acoustics, surface.radii),
               surface.fade_step),
      air_(make_air(acoustics, surface, steady, stages, communicator, accelerator)),
      emitted_(steady) {}

template <class Action>
void AudioPath::note_problem(const Action& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    if (problem_.empty()) {
      problem_ = error.what();
    }
  }
}

void AudioPath::start(const surface::SurfaceMotion& steady) {
  emitter_.start(steady);
  air_->start(emitted_, steady);
}

void AudioPath::hear(const surface::SurfaceMotion& motion) {
  {
    const parallel::Stages::Scope stage(stages_, parallel::Stage::surface);
    emitter_.emit(motion, emission_);
  }
  ++emitted_;
  note_problem([this, &motion] { air_->propagate(emitted_, emission_, motion); });
}

void AudioPath::finish() {
  note_problem([this] { air_->finish(); });
}

void AudioPath::check() {
  finish();
  parallel::agree(communicator_, problem_.empty() ? "" : "the motion can't be heard: " + problem_);
}

std::vector<std::vector<double>> AudioPath::take(std::int64_t most) {
  const std::int64_t final_samples = std::min(air_->final_before(emitted_), most);
  if (final_samples <= taken_) {
    return {};
  }
  finish();
  std::vector<std::vector<double>> sounds = air_->take(final_samples - taken_);
  taken_ = final_samples;
  for (const std::vector<double>& sound : sounds) {
    for (const double value : sound) {
      loudest_ = std::max(loudest_, std::abs(value));
    }
  }
  return sounds;
}

void AudioPath::archive(parallel::Archive& archive) {
  finish();
  emitter_.archive(archive, triangle_rows_);
  air_->archive(archive);
  archive.root("listening/emitted", emitted_);
  archive.root("listening/written", taken_);
  archive.root("listening/loudest", loudest_);
}

}  // namespace idiophone::propagation
