#include "page_body.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "idiophone/instruments/resonators/smooth_rise.hpp"

namespace idiophone::page_sound {

using resonators::Complex;
using resonators::ModeGroup;
using resonators::Resonator;

PageBody::PageBody(std::size_t modes, std::size_t channels, int rate,
                   std::optional<resonators::StretchedModes> stretching)
    : channels_(channels), rate_(rate), bank_(std::vector<Complex>(modes), std::move(stretching)), contacts_(rate) {}

void PageBody::tune(const PageTuning& tuning) {
  resonators_.clear();
  lowest_ = 0.0;
  std::vector<Complex> turns;
  for (std::size_t mode = 0; mode < tuning.frequency.size(); ++mode) {
    const resonators::DampedOscillator oscillator(tuning.frequency[mode], tuning.decay[mode]);
    const bool sounds = tuning.frequency[mode] < 0.5 * rate_ && oscillator.oscillates();
    resonators_.push_back(sounds ? Resonator(oscillator, rate_) : Resonator());
    turns.push_back(resonators_.back().turn);
    if (sounds && (lowest_ == 0.0 || oscillator.damped < lowest_)) {
      lowest_ = oscillator.damped;
    }
  }
  bank_.retune(resonators::in_groups(turns), tuning.size);
  gains_.clear();
  for (std::size_t channel = 0; channel < channels_; ++channel) {
    std::vector<Complex> gains;
    for (std::size_t mode = 0; mode < resonators_.size(); ++mode) {
      const double* pressure = &tuning.pressure[2 * (channel * resonators_.size() + mode)];
      gains.push_back(Complex(pressure[0], pressure[1]) * resonators_[mode].velocity);
    }
    const std::vector<ModeGroup> groups = resonators::in_groups(gains);
    gains_.insert(gains_.end(), groups.begin(), groups.end());
  }
  for (Force& force : forces_) {
    tune(force);
  }
}

void PageBody::tune(Force& force) const {
  force.by_mean = driven(force.participation, &Resonator::by_mean);
  force.by_slope = driven(force.participation, &Resonator::by_slope);
}

std::vector<ModeGroup> PageBody::driven(const Participation& participation, Complex Resonator::*part) const {
  std::vector<Complex> products;
  for (std::size_t mode = 0; mode < resonators_.size(); ++mode) {
    products.push_back(participation[mode] * resonators_[mode].*part);
  }
  return resonators::in_groups(products);
}

void PageBody::strike(std::int64_t start, resonators::ForceCurve force, Participation participation) {
  if (lowest_ == 0.0) {
    return;
  }
  const std::size_t acts_for = force.size();
  resonators::add_rise(force, lowest_, rate_);
  tune(forces_.emplace_back(Force{
      .start = start, .curve = std::move(force), .acts_for = acts_for, .participation = std::move(participation)}));
}

void PageBody::put_bow(int number, const friction::Law& friction, const Participation& place) {
  if (lowest_ == 0.0 || bows_.size() == resonators::PointContacts::most) {
    return;
  }
  PageBow& bow = bows_.try_emplace(number, friction, place, rate_).first->second;
  bow.point = contact_point(place);
  contacts_.add(bow.contact(), bow.point);
}

void PageBody::lead_bow(int number, const resonators::ContactMotion& motion, Participation place) {
  if (const auto found = bows_.find(number); found != bows_.end()) {
    found->second.lead(motion, std::move(place));
  }
}

void PageBody::lift_bow(int number) {
  if (const auto found = bows_.find(number); found != bows_.end()) {
    found->second.lift();
  }
}

resonators::ContactPoint PageBody::contact_point(const Participation& place) const {
  resonators::ContactPoint point{.displacement = driven(place, &Resonator::displacement),
                                 .by_mean = driven(place, &Resonator::by_mean),
                                 .by_slope = {},
                                 .lowest = lowest_};
  point.by_slope.resize(point.by_mean.size());
  return point;
}

void PageBody::move_bows(std::int64_t samples) {
  for (auto& [number, bow] : bows_) {
    bow.point = contact_point(bow.next_place(samples));
  }
  contacts_.find_compliance();
}

void PageBody::end_bows() {
  const auto rest = static_cast<std::int64_t>(resonators::samples_of_rise(lowest_, rate_));
  for (auto entry = bows_.begin(); entry != bows_.end();) {
    const auto next = std::next(entry);
    if (entry->second.since_end() > rest) {
      contacts_.remove(entry->second.contact());
      bows_.erase(entry);
    }
    entry = next;
  }
}

std::vector<resonators::Drive> PageBody::drives(std::int64_t first, std::size_t samples) {
  std::vector<resonators::Drive> drives;
  for (Force& force : forces_) {
    const std::int64_t offset = first - force.start;
    for (std::size_t i = 0; i < samples; ++i) {
      const std::int64_t at = offset + static_cast<std::int64_t>(i);
      const bool is_during = at >= 0 && at < static_cast<std::int64_t>(force.curve.size());
      force.piece[i] = is_during ? force.curve[static_cast<std::size_t>(at)] : resonators::ForcePiece{};
    }
    drives.push_back({.force = std::span(force.piece).first(samples),
                      .by_mean = force.by_mean,
                      .by_slope = force.by_slope,
                      .acts = offset < static_cast<std::int64_t>(force.acts_for)});
  }
  return drives;
}

bool PageBody::render(std::int64_t first, std::span<double> sound) {
  std::erase_if(forces_, [first](const Force& force) {
    return force.start + static_cast<std::int64_t>(force.curve.size()) <= first;
  });
  end_bows();
  if (forces_.empty() && bows_.empty() && !bank_.sounds()) {
    return false;
  }
  while (!sound.empty()) {
    const std::size_t samples = std::min(resonators::ResonatorBank::most_samples, sound.size() / channels_);
    const std::span<double> piece = sound.first(samples * channels_);
    const std::vector<resonators::Drive> acting = drives(first, samples);
    if (bows_.empty() && !bank_.stretches(acting)) {
      bank_.advance(acting, gains_, channels_, piece);
    } else {
      move_bows(static_cast<std::int64_t>(samples));
      bank_.advance(acting, contacts_, gains_, channels_, piece);
    }
    first += static_cast<std::int64_t>(samples);
    sound = sound.subspan(piece.size());
  }
  bank_.silence();
  return true;
}

}  // namespace idiophone::page_sound
