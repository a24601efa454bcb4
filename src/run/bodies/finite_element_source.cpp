#include "idiophone/run/bodies/finite_element_source.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "body_surfaces.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/run/bodies/prepared_surface.hpp"
#include "idiophone/scene/body_materials.hpp"
#include "idiophone/solids/modal_bodies/rotation_limit.hpp"

namespace idiophone::bodies {

std::int64_t sound_samples(const scene::Scene& scene) {
  return std::max<std::int64_t>(1, std::llround(scene.time.duration * scene.audio.rate));
}

FiniteElementSource::FiniteElementSource(const Preparation& ready, parallel::Stages& stages, MPI_Comm communicator,
                                         accelerator::Accelerator* accelerator)
    : Source(audible_surface(ready, communicator)),
      ready_(ready),
      steps_per_read_(ready.steps_per_read),
      stages_(stages),
      communicator_(communicator),
      rank_(parallel::rank_of(communicator)),
      motion_(ready.scene, ready.part, ready.attachments, ready.contact_surfaces, ready.step(), ready.steps_per_sample,
              communicator, ready.models(), ready.steps_per_read, accelerator),
      surfaces_(std::make_unique<BodySurfaces>(ready, surface(), communicator)),
      stability_(ready),
      bolts_(ready, motion_, communicator),
      warned_(ready.scene.bodies.size()),
      body_channels_(ready, motion_, communicator),
      contact_channels_(ready.scene, motion_, communicator),
      load_channels_(ready.scene, motion_, communicator),
      gauge_channels_(ready, motion_, communicator),
      fracture_channels_(ready, motion_, communicator) {
  motion_.balance_loads(ready.initial_state);
  if (accelerator != nullptr) {
    surfaces_->accelerate(*accelerator, motion_);
  }
}

FiniteElementSource::~FiniteElementSource() = default;

std::int64_t FiniteElementSource::first_sample() const {
  return -surfaces_->sampling().latency();
}

void FiniteElementSource::couple(propagation::AirLoad& air) {
  air_.emplace(ready_, motion_, air, communicator_);
}

void FiniteElementSource::start(surface::SurfaceMotion& motion) {
  motion_.start(ready_.initial_state.centres, ready_.initial_state.displacement);
  if (air_) {
    air_->start();
  }
  check_overlaps();
  surfaces_->start(motion_, motion);
  note_motion();
  stability_.start(observe_now());
}

void FiniteElementSource::advance(surface::SurfaceMotion& motion) {
  for (int read = 0; read < surfaces_->sampling().reads_per_sample(); ++read) {
    {
      const parallel::Stages::Scope stage(stages_, parallel::Stage::motion);
      advance_motion_to(motion_.step_number() + steps_per_read_);
    }
    const parallel::Stages::Scope stage(stages_, parallel::Stage::surface);
    surfaces_->read(motion_);
  }
  stages_.move(parallel::Stage::motion, parallel::Stage::contact, motion_.contacts().take_seconds());
  ++sample_;
  {
    const parallel::Stages::Scope stage(stages_, parallel::Stage::surface);
    surfaces_->take(motion);
  }
  note_motion();
}

void FiniteElementSource::advance_motion_to(std::int64_t end) {
  if (!air_) {
    motion_.advance_to(end);
    return;
  }
  while (motion_.step_number() < end) {
    motion_.advance();
    air_->after_step();
  }
}

void FiniteElementSource::note_motion() {
  if (sample_ <= sound_samples(ready_.scene)) {  // what comes after only completes the sound
    body_channels_.note(sample_);
    contact_channels_.note(sample_);
    load_channels_.note(sample_);
    gauge_channels_.note(sample_);
    fracture_channels_.note(sample_);
    bolts_.note(sample_);
  }
}

const std::vector<solid::NodeState>& FiniteElementSource::node_states() {
  motion_.update_nodes();
  return motion_.state();
}

void FiniteElementSource::check() {
  stability_.check(observe_now(), static_cast<double>(sample_) / ready_.scene.audio.rate, communicator_);
  warn_of_vibrations();
  bolts_.check();
}

void FiniteElementSource::warn_of_vibrations() {
  for (const auto& [b, basis] : ready_.modal_bases) {
    if (warned_[b]) {
      continue;
    }
    const std::string problem = basis.stretching.exists() ? too_large_rotation(b) : too_large_vibration(b);
    warned_[b] = !problem.empty();
    if (warned_[b] && rank_ == 0) {
      spdlog::warn("body {}: {}", ready_.scene.bodies[b].name, problem);
    }
  }
}

std::string FiniteElementSource::too_large_vibration(std::size_t body) const {
  constexpr double largest = 0.1;  // a clamped plate is then 8 cents sharp
  const double thickness = ready_.modal_bases.at(body).thickness;
  const double part = parallel::largest(surfaces_->largest_vibration(body), communicator_) / thickness;
  return part > largest ? fmt::format(
                              "it vibrates by {:.3g} of its thickness, {:.3g} m: modes are right for small "
                              "vibrations, up to a tenth. Hit less hard, add large_amplitudes: true to its "
                              "model, or use model: {{type: finite_elements}}",
                              part, thickness)
                        : "";
}

std::string FiniteElementSource::too_large_rotation(std::size_t body) const {
  const double rotation = parallel::largest(surfaces_->largest_rotation(body), communicator_);
  return rotation > modal_bodies::largest_right_rotation
             ? modal_bodies::too_large_rotation(rotation) + ". Hit less hard, or use model: {type: finite_elements}"
             : "";
}

void FiniteElementSource::archive(parallel::Archive& archive) {
  archive.root("motion/sample", sample_);
  motion_.archive(archive, sample_ * ready_.steps_per_sample);
  if (air_) {
    air_->archive(archive);
  }
  surfaces_->archive(archive);
  stability_.archive(archive);
  bolts_.archive(archive);
  body_channels_.archive(archive);
  contact_channels_.archive(archive);
}

double FiniteElementSource::deepest(std::size_t contact) const {
  return parallel::largest(motion_.contacts().deepest(contact), communicator_);
}

void FiniteElementSource::check_overlaps() const {
  for (std::size_t c = 0; c < motion_.contacts().count(); ++c) {
    const contact::ContactMotion now = motion_.contacts().now(c);
    std::array<double, 4> place = {now.overlap, now.point.x(), now.point.y(), now.point.z()};
    parallel::reduce(place, MPI_SUM, communicator_);  // zero on all ranks but one
    const double depth = deepest(c);
    if (depth == 0) {
      continue;
    }
    const scene::Contact& contact = ready_.scene.contacts[c];
    const bool is_with_itself = contact.other == contact.body;
    const std::string found =
        fmt::format("{}: {} overlap at the start, {:.3g} m3 around ({:.4g}, {:.4g}, {:.4g}), {:.3g} m deep",
                    contact.name, is_with_itself ? "parts of " + ready_.scene.bodies[contact.body].name : "the two",
                    place[0], place[1], place[2], place[3], depth);
    const char* remedy = is_with_itself ? "change the mesh" : "move them";
    const double pressure = ready_.contact_surfaces.stiffness[c] * depth;
    const auto modulus_of = [&](std::size_t body) {
      return scene::softest_modulus(ready_.scene.bodies[body], ready_.scene.materials);
    };
    const double modulus = std::min(modulus_of(contact.body), modulus_of(contact.other.value_or(contact.body)));
    if (pressure > modulus) {
      throw std::runtime_error(fmt::format(
          "{}: a contact pressure of {:.3g} Pa, more than Young's modulus of {:.3g} Pa; {} so that they only "
          "touch",
          found, pressure, modulus, remedy));
    }
    if (rank_ == 0) {
      spdlog::warn("{}, and will fly apart; {} so that they only touch", found, remedy);
    }
  }
}

void FiniteElementSource::report_fracture() const {
  for (const motion::BodyFracture& fracture : motion_.dynamics().fractures()) {
    const double area = parallel::largest(fracture.broken_area(), communicator_);  // zero on all ranks but one
    if (rank_ == 0) {
      spdlog::info("body {}: {}", ready_.scene.bodies[fracture.body()].name,
                   area > 0 ? fmt::format("broken along {:.3g} m2 of its fracture surfaces", area) : "did not break");
    }
  }
}

void FiniteElementSource::report() const {
  report_fracture();
  bolts_.report();
  for (std::size_t c = 0; c < motion_.contacts().count(); ++c) {
    const double depth = deepest(c);
    if (rank_ != 0) {
      continue;
    }
    const scene::Contact& contact = ready_.scene.contacts[c];
    spdlog::info("contact {}: {}", contact.name,
                 depth > 0 ? fmt::format("deepest penetration {:.3g} m", depth) : "never touched");
    double thinnest = ready_.contact_surfaces.skins[contact.body].thinnest;
    if (contact.other) {
      thinnest = std::min(thinnest, ready_.contact_surfaces.skins[*contact.other].thinnest);
    }
    if (depth > thinnest) {
      spdlog::warn(
          "contact {}: deeper than the outer layer of elements is thick, {:.3g} m; contact is weak there, and what is "
          "deeper still falls through. Give it more stiffness (now {:.3g} Pa/m), or hit less hard",
          contact.name, thinnest, ready_.contact_surfaces.stiffness[c]);
    }
  }
}

}  // namespace idiophone::bodies
