#include "modal_coordinates.hpp"

#include <utility>

#include "modal_oscillators.hpp"

namespace idiophone::modal_bodies {

ModalCoordinates::ModalCoordinates(const ModalBasis& basis)
    : frequencies_(Eigen::Map<const Eigen::ArrayXd>(basis.frequencies.data(), std::ssize(basis.frequencies))),
      decays_(Eigen::Map<const Eigen::ArrayXd>(basis.decay_rates.data(), std::ssize(basis.decay_rates))),
      squares_(frequencies_.square()),
      flexibilities_(squares_.inverse()),
      keep_(Eigen::ArrayXd::Ones(frequencies_.size())),
      pull_(Eigen::ArrayXd::Zero(frequencies_.size())),
      stretching_(basis.stretching),
      places_(Eigen::ArrayXd::Zero(frequencies_.size())),
      rates_(Eigen::ArrayXd::Zero(frequencies_.size())) {}

void ModalCoordinates::prepare(double length) {
  if (length == length_) {
    return;
  }
  length_ = length;
  for (Eigen::Index mode = 0; mode < frequencies_.size(); ++mode) {
    const OscillatorStep oscillator(frequencies_[mode], decays_[mode], length);
    keep_[mode] = oscillator.keep;
    pull_[mode] = oscillator.pull;
  }
  stiffness_ = squares_ / (length * pull_);
}

void ModalCoordinates::start(const Eigen::ArrayXd& places, const Eigen::ArrayXd& rates) {
  places_ = places;
  rates_ = rates;
  if (stretch()) {
    stretching_.go_to(places_);
  }
}

void ModalCoordinates::restored(double length) {
  prepare(length);
  if (stretch()) {
    stretching_.go_to(places_);
  }
}

void ModalCoordinates::advance(const Step& step, const Eigen::ArrayXd& force) {
  prepare(step.length);
  if (step.length == step.before) {
    Next found = next(force);
    rates_ = std::move(found.rates);
    stored_ = found.stored;
  } else {
    const Eigen::ArrayXd whole = stretch() ? Eigen::ArrayXd(force + stretching_.force()) : force;
    stored_ = stretching_.energy();
    for (Eigen::Index mode = 0; mode < frequencies_.size(); ++mode) {
      rates_[mode] = rate_of_other_step(frequencies_[mode], decays_[mode], {step.before, step.length}, places_[mode],
                                        rates_[mode], flexibilities_[mode] * whole[mode]);
    }
  }
  places_ += step.length * rates_;
  if (stretch()) {
    stretching_.go_to(places_);
  }
}

ModalCoordinates::Next ModalCoordinates::next(const Eigen::ArrayXd& force) const {
  Eigen::ArrayXd rates = keep_ * rates_ + pull_ * (flexibilities_ * force - places_);
  if (!stretch()) {
    return {.rates = std::move(rates), .stored = 0.0};
  }
  const Eigen::ArrayXd before = places_ - length_ * rates_;
  const Eigen::ArrayXd end = places_ + length_ * rates;
  const StretchedStep stretched = stretching_.step({length_, before, places_, end, stiffness_, squares_}, stored_);
  rates += stretched.change / length_;
  return {.rates = std::move(rates), .stored = stretched.stored};
}

Eigen::ArrayXd ModalCoordinates::rates_now(const Step& step, const Eigen::ArrayXd& force) const {
  if (step.is_first()) {
    return rates_;
  }
  return (rates_ + next(force).rates) / 2 *
         frequencies_.unaryExpr([&](double frequency) { return rate_correction(frequency, step.length); });
}

double ModalCoordinates::elastic_energy() const {
  const double small = (frequencies_ * places_).square().sum() / 2;
  return stretch() ? small + stretching_.energy() : small;
}

void ModalCoordinates::archive(std::size_t mode, parallel::ArchiveRow& row) {
  row.value(places_[static_cast<Eigen::Index>(mode)]);
  row.value(rates_[static_cast<Eigen::Index>(mode)]);
}

}  // namespace idiophone::modal_bodies
