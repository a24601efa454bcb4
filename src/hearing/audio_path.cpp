#include "idiophone/hearing/audio_path.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "coupled_air.hpp"
#include "idiophone/parallel/errors.hpp"
#include "straight_air.hpp"
#include "wave_air.hpp"

namespace idiophone::hearing {

namespace {

surface::SurfacePressure surface_pressure(const scene::Scene& scene, const std::vector<double>& radii) {
  using Field = surface::SurfacePressure::Field;
  if (!scene.radiation.needs_radii()) {
    return {};
  }
  const bool pulsating = scene.radiation.surface_pressure == scene::SurfacePressureModel::pulsating;
  return {pulsating ? Field::pulsating : Field::oscillating, radii, scene.radiation.air.speed / scene.audio.rate};
}

std::unique_ptr<Air> make_air(const scene::Scene& scene, const source::AudibleSurface& surface, std::int64_t steady,
                              parallel::Stages& stages, MPI_Comm communicator) {
  if (scene.radiation.grid.back) {
    return std::make_unique<CoupledAir>(scene, surface, steady, stages, communicator);
  }
  if (scene.radiation.model == scene::RadiationModel::waves) {
    return std::make_unique<WaveAir>(scene, surface, steady, stages, communicator);
  }
  return std::make_unique<StraightAir>(scene, surface, steady, stages, communicator);
}

}  // namespace

AudioPath::AudioPath(const scene::Scene& scene, const source::AudibleSurface& surface, std::int64_t steady,
                     parallel::Stages& stages, MPI_Comm communicator)
    : scene_(scene),
      stages_(stages),
      communicator_(communicator),
      triangle_rows_(surface.triangle_ids, surface.global_triangles(), communicator),
      emitter_(surface.triangles, scene.audio.dc_loss, surface_pressure(scene, surface.radii)),
      air_(make_air(scene, surface, steady, stages, communicator)),
      emitted_(steady) {}

void AudioPath::declare(store::ResultFile& result) const {
  for (const auto& listener : scene_.listeners) {
    store::Series series{"/audio/" + listener.name, air_->unit(), static_cast<double>(scene_.audio.rate), {},
                         air_->description(),       {},           listener.attached.value_or("")};
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
  try {
    air_->propagate(emitted_, emission_, motion);
  } catch (const std::runtime_error& error) {
    problem_ = error.what();
  }
}

void AudioPath::check() const {
  parallel::agree(communicator_, problem_.empty() ? "" : "the motion can't be heard: " + problem_);
}

void AudioPath::write(store::ResultFile& result, std::int64_t most) {
  const std::int64_t final_samples = std::min(air_->final_before(emitted_), most);
  if (final_samples <= written_) {
    return;
  }
  const std::vector<std::vector<double>> sounds = air_->take(final_samples - written_);
  written_ = final_samples;
  for (std::size_t l = 0; l < sounds.size(); ++l) {
    result.append("/audio/" + scene_.listeners[l].name, sounds[l]);
    for (const double value : sounds[l]) {
      loudest_ = std::max(loudest_, std::abs(value));
    }
  }
}

void AudioPath::archive(parallel::Archive& archive) {
  emitter_.archive(archive, triangle_rows_);
  air_->archive(archive);
  archive.root("listening/emitted", emitted_);
  archive.root("listening/written", written_);
  archive.root("listening/loudest", loudest_);
}

}  // namespace idiophone::hearing
