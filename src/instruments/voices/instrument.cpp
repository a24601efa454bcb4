#include "instrument.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "idiophone/instruments/resonators/bow.hpp"
#include "idiophone/instruments/resonators/mallet.hpp"
#include "idiophone/instruments/resonators/smooth_rise.hpp"
#include "idiophone/instruments/sound_maps/blow.hpp"
#include "map_directivity.hpp"

namespace idiophone::voices {

Instrument::Instrument(std::shared_ptr<const PreparedMap> prepared, int rate)
    : prepared_(std::move(prepared)), rate_(rate) {
  tune({});
}

namespace {

constexpr double slowest_mode = 1e-3;  // rad/s, of a mode that sounds

}  // namespace

void Instrument::tune(const score::Tuning& tuning) {
  size_ = tuning.size;
  resonators_.clear();
  lowest_ = 0.0;
  for (std::size_t mode = 0; mode < map().modes(); ++mode) {
    const double frequency = map().frequency[mode] / size_;
    const double decay = (tuning.friction * map().material_decay[mode] + map().radiation_decay[mode]) / size_;
    const resonators::DampedOscillator oscillator(frequency, decay);
    const bool sounds = frequency < 0.5 * rate_ && oscillator.damped > slowest_mode;
    resonators_.push_back(sounds ? resonators::Resonator(oscillator, rate_) : resonators::Resonator());
    if (sounds && lowest_ == 0.0) {
      lowest_ = oscillator.damped;
    }
  }
}

std::size_t Instrument::modes() const {
  return std::ranges::count_if(resonators_,
                               [](const resonators::Resonator& resonator) { return resonator.turn != 0.0; });
}

resonators::ResonatorBank Instrument::bank() const {
  const modal_bodies::Stretching& stretching = map().stretching;
  if (!stretching.exists()) {
    return resonators::ResonatorBank(turns());
  }
  resonators::StretchingEnergy energy(stretching.linear, stretching.quadratic, map().modes());
  return resonators::ResonatorBank(turns(), resonators::StretchedModes(std::move(energy), stretching.rotation,
                                                                       resonators::in_groups(turns()), rate_));
}

std::vector<resonators::Complex> Instrument::turns() const {
  std::vector<resonators::Complex> turns;
  for (const resonators::Resonator& resonator : resonators_) {
    turns.push_back(resonator.turn);
  }
  return turns;
}

std::vector<double> Instrument::participation(const Vector3& at, const Vector3& direction) const {
  std::vector<double> participation = sound_maps::participation(map(), prepared_->surface.nearest(at), direction);
  for (double& phi : participation) {
    phi *= std::pow(size_, -1.5);
  }
  return participation;
}

std::unique_ptr<ForceCommand> Instrument::excite(const Vector3& at, const Vector3& direction,
                                                 resonators::ForceCurve force) const {
  const std::vector<double> phi = participation(at, direction);
  std::vector<resonators::Complex> by_mean, by_slope;
  for (std::size_t mode = 0; mode < resonators_.size(); ++mode) {
    by_mean.push_back(phi[mode] * resonators_[mode].by_mean);
    by_slope.push_back(phi[mode] * resonators_[mode].by_slope);
  }
  auto excitation = std::make_unique<ForceCommand>();
  excitation->acts_for = static_cast<std::int64_t>(force.size());
  for (const resonators::ForcePiece& piece : force) {
    excitation->strength += std::abs(piece.mean) * direction.norm() / (rate_ * map().mass);
  }
  excitation->force = std::move(force);
  if (lowest_ > 0.0) {
    resonators::add_rise(excitation->force, lowest_, rate_);
  }
  excitation->by_mean = resonators::in_groups(by_mean);
  excitation->by_slope = resonators::in_groups(by_slope);
  return excitation;
}

resonators::ContactPoint Instrument::contact_point(const Vector3& at, const Vector3& direction) const {
  const std::vector<double> phi = participation(at, direction);
  std::vector<resonators::Complex> displacement, by_mean;
  for (std::size_t mode = 0; mode < resonators_.size(); ++mode) {
    displacement.push_back(phi[mode] * resonators_[mode].displacement);
    by_mean.push_back(phi[mode] * resonators_[mode].by_mean);
  }
  resonators::ContactPoint point{.displacement = resonators::in_groups(displacement),
                                 .by_mean = resonators::in_groups(by_mean),
                                 .by_slope = {},
                                 .lowest = lowest_};
  point.by_slope.resize(point.by_mean.size());
  return point;
}

void Instrument::require_modes() const {
  if (lowest_ == 0.0) {
    throw std::runtime_error(map().body + " has no mode that sounds at this rate, so nothing can touch it");
  }
}

std::unique_ptr<TouchCommand> Instrument::touch_at(const Vector3& at, const Vector3& direction) const {
  require_modes();
  auto command = std::make_unique<TouchCommand>();
  command->rest = static_cast<std::int64_t>(resonators::samples_of_rise(lowest_, rate_));
  command->point = contact_point(at, direction);
  return command;
}

std::unique_ptr<TouchCommand> Instrument::touch(const score::Bow& bow) const {
  constexpr std::int64_t endless = std::numeric_limits<std::int64_t>::max() / 4;
  std::unique_ptr<TouchCommand> command = touch_at(bow.at, bow.direction);
  command->length = std::isfinite(bow.duration) ? std::llround(bow.duration * rate_) : endless;
  command->strength = bow.load.largest() * bow.friction.sliding * std::min(bow.duration, 1.0) / map().mass;
  command->contact = std::make_unique<resonators::Bow>(bow, rate_);
  return command;
}

std::unique_ptr<TouchCommand> Instrument::touch(const score::MalletBlow& mallet) const {
  const score::Hammer& hammer = mallet.blow.hammer;
  const double longest = std::max(0.25, 4.0 * hammer.contact_duration());  // s, until it has left for good
  std::unique_ptr<TouchCommand> command = touch_at(mallet.blow.at, mallet.blow.direction);
  command->length = std::llround(longest * rate_);
  command->strength = 2.0 * hammer.mass * hammer.speed / map().mass;
  command->contact = std::make_unique<resonators::Mallet>(hammer, mallet.loss, rate_);
  return command;
}

Reception Instrument::reception(std::span<const std::vector<resonators::Complex>> pressure,
                                std::span<const double> delay) const {
  const double scale = 1.0 / std::sqrt(size_);
  Reception reception;
  for (std::size_t r = 0; r < pressure.size(); ++r) {
    std::vector<resonators::Complex> gains;
    for (std::size_t mode = 0; mode < resonators_.size(); ++mode) {
      gains.push_back(scale * pressure[r][mode] * resonators_[mode].velocity);
    }
    const std::vector<resonators::ModeGroup> groups = resonators::in_groups(gains);
    reception.gains.insert(reception.gains.end(), groups.begin(), groups.end());
    reception.delay[r] = delay[r] * rate_;
  }
  return reception;
}

Reception Instrument::at_listeners() const {
  std::vector<std::vector<resonators::Complex>> pressure;
  std::vector<double> delay;
  for (const sound_maps::MapListener& listener : map().listeners) {
    pressure.push_back(listener.pressure);
    delay.push_back(listener.delay);
  }
  return reception(pressure, delay);
}

Reception Instrument::at(std::span<const HearingPoint> points) const {
  std::vector<std::vector<resonators::Complex>> pressure;
  std::vector<double> delay;
  for (const HearingPoint& point : points) {
    const Vector3 way = point.position - map().centre;
    const double distance = std::max(way.norm(), size_ * prepared_->radius);
    const Vector3 direction = way.norm() > 0.0 ? Vector3(way.normalized()) : Vector3::UnitZ();
    const double sensitivity = 1.0 - point.directivity - point.directivity * direction.dot(point.axis);
    std::vector<resonators::Complex>& heard = pressure.emplace_back(pressure_in_direction(map(), direction));
    for (resonators::Complex& mode : heard) {
      mode *= sensitivity * map().sphere.distance / distance;
    }
    delay.push_back(distance / map().air_speed);
  }
  return reception(pressure, delay);
}

}  // namespace idiophone::voices
