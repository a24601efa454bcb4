#include "modal_coordinates.hpp"

#include "modal_oscillators.hpp"

namespace idiophone::modal_bodies {

ModalCoordinates::ModalCoordinates(const ModalBasis& basis)
    : frequencies_(Eigen::Map<const Eigen::ArrayXd>(basis.frequencies.data(), std::ssize(basis.frequencies))),
      decays_(Eigen::Map<const Eigen::ArrayXd>(basis.decay_rates.data(), std::ssize(basis.decay_rates))),
      flexibilities_(frequencies_.square().inverse()),
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
  stiffness_ = frequencies_.square() / (length * pull_);
}

void ModalCoordinates::start(const Eigen::ArrayXd& places, const Eigen::ArrayXd& rates) {
  places_ = places;
  rates_ = rates;
}

void ModalCoordinates::advance(const Step& step, const Eigen::ArrayXd& force) {
  prepare(step.length);
  if (step.length == step.before) {
    rates_ = next_rates(force);
  } else {
    const Eigen::ArrayXd whole = stretch() ? Eigen::ArrayXd(force + stretching_.at(places_)) : force;
    for (Eigen::Index mode = 0; mode < frequencies_.size(); ++mode) {
      rates_[mode] = rate_of_other_step(frequencies_[mode], decays_[mode], {step.before, step.length}, places_[mode],
                                        rates_[mode], flexibilities_[mode] * whole[mode]);
    }
  }
  places_ += step.length * rates_;
}

Eigen::ArrayXd ModalCoordinates::next_rates(const Eigen::ArrayXd& force) const {
  const Eigen::ArrayXd rates = keep_ * rates_ + pull_ * (flexibilities_ * force - places_);
  if (!stretch()) {
    return rates;
  }
  const Eigen::ArrayXd before = places_ - length_ * rates_;
  const Eigen::ArrayXd end = places_ + length_ * rates;
  return rates + stretching_.change_of_end({before, places_, end, stiffness_}) / length_;
}

Eigen::ArrayXd ModalCoordinates::rates_now(const Step& step, const Eigen::ArrayXd& force) const {
  if (step.is_first()) {
    return rates_;
  }
  return (rates_ + next_rates(force)) / 2 *
         frequencies_.unaryExpr([&](double frequency) { return rate_correction(frequency, step.length); });
}

double ModalCoordinates::elastic_energy() const {
  const double small = (frequencies_ * places_).square().sum() / 2;
  return stretch() ? small + stretching_.energy(places_) : small;
}

void ModalCoordinates::archive(std::size_t mode, parallel::ArchiveRow& row) {
  row.value(places_[static_cast<Eigen::Index>(mode)]);
  row.value(rates_[static_cast<Eigen::Index>(mode)]);
}

}  // namespace idiophone::modal_bodies
