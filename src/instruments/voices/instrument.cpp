#include "instrument.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "idiophone/instruments/resonators/bow.hpp"
#include "idiophone/instruments/resonators/mallet.hpp"
#include "idiophone/instruments/resonators/smooth_rise.hpp"
#include "idiophone/instruments/sound_maps/blow.hpp"

namespace idiophone::voices {

Instrument::Instrument(std::shared_ptr<const sound_maps::SoundMap> map, int rate) : map_(std::move(map)), rate_(rate) {
  for (const Vector3& vertex : map_->vertices) {
    radius_ = std::max(radius_, (vertex - map_->centre).norm());
  }
  tune({});
}

namespace {

constexpr double slowest_mode = 1e-3;  // rad/s, of a mode that sounds

}  // namespace

void Instrument::tune(const score::Tuning& tuning) {
  size_ = tuning.size;
  resonators_.clear();
  lowest_ = 0.0;
  for (std::size_t mode = 0; mode < map_->modes(); ++mode) {
    const double frequency = map_->frequency[mode] / size_;
    const double decay = (tuning.friction * map_->material_decay[mode] + map_->radiation_decay[mode]) / size_;
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
  const modal_bodies::Stretching& stretching = map_->stretching;
  if (!stretching.exists()) {
    return resonators::ResonatorBank(turns());
  }
  resonators::StretchingEnergy energy(stretching.linear, stretching.quadratic, map_->modes());
  return resonators::ResonatorBank(
      turns(), resonators::StretchedModes(std::move(energy), resonators::in_groups(turns()), rate_));
}

std::vector<resonators::Complex> Instrument::turns() const {
  std::vector<resonators::Complex> turns;
  for (const resonators::Resonator& resonator : resonators_) {
    turns.push_back(resonator.turn);
  }
  return turns;
}

std::vector<double> Instrument::participation(const Vector3& at, const Vector3& direction) const {
  std::vector<double> participation = sound_maps::participation(*map_, at, direction);
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
    excitation->strength += std::abs(piece.mean) * direction.norm() / (rate_ * map_->mass);
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
    throw std::runtime_error(map_->body + " has no mode that sounds at this rate, so nothing can touch it");
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
  command->strength = bow.load.largest() * bow.friction.sliding * std::min(bow.duration, 1.0) / map_->mass;
  command->contact = std::make_unique<resonators::Bow>(bow, rate_);
  return command;
}

std::unique_ptr<TouchCommand> Instrument::touch(const score::MalletBlow& mallet) const {
  const score::Hammer& hammer = mallet.blow.hammer;
  const double longest = std::max(0.25, 4.0 * hammer.contact_duration());  // s, until it has left for good
  std::unique_ptr<TouchCommand> command = touch_at(mallet.blow.at, mallet.blow.direction);
  command->length = std::llround(longest * rate_);
  command->strength = 2.0 * hammer.mass * hammer.speed / map_->mass;
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
  for (const sound_maps::MapListener& listener : map_->listeners) {
    pressure.push_back(listener.pressure);
    delay.push_back(listener.delay);
  }
  return reception(pressure, delay);
}

Reception Instrument::at(std::span<const HearingPoint> points) const {
  const sound_maps::MapSphere& sphere = map_->sphere;
  std::vector<std::vector<resonators::Complex>> pressure;
  std::vector<double> delay;
  for (const HearingPoint& point : points) {
    const Vector3 way = point.position - map_->centre;
    const double distance = std::max(way.norm(), size_ * radius_);
    const Vector3 direction = way.norm() > 0.0 ? Vector3(way.normalized()) : Vector3::UnitZ();
    const double sensitivity = 1.0 - point.directivity - point.directivity * direction.dot(point.axis);
    const std::vector<double> weights = weights_in_direction(sphere, direction);
    std::vector<resonators::Complex>& heard = pressure.emplace_back();
    for (std::size_t mode = 0; mode < map_->modes(); ++mode) {
      resonators::Complex sum = 0.0;
      for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += weights[i] * sphere.pressure[mode * weights.size() + i];
      }
      heard.push_back(sensitivity * sphere.distance / distance * sum);
    }
    delay.push_back(distance / map_->air_speed);
  }
  return reception(pressure, delay);
}

std::vector<double> weights_in_direction(const sound_maps::MapSphere& sphere, const Vector3& direction) {
  std::vector<double> weights;
  for (std::size_t i = 0; i < sphere.direction.size(); ++i) {
    const double cosine = direction.dot(sphere.direction[i]);
    double before = 0.0, polynomial = 1.0, sum = 0.0;  // Legendre's
    for (std::size_t degree = 0; degree < sphere.rings; ++degree) {
      const auto l = static_cast<double>(degree);
      sum += (2.0 * l + 1.0) / (4.0 * std::numbers::pi) * polynomial;
      before = std::exchange(polynomial, ((2.0 * l + 1.0) * cosine * polynomial - l * before) / (l + 1.0));
    }
    weights.push_back(sphere.weight[i] * sum);
  }
  return weights;
}

}  // namespace idiophone::voices
