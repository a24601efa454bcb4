#include "modal_coordinates.hpp"

#include "modal_oscillators.hpp"

namespace idiophone::modal_bodies {

ModalCoordinates::ModalCoordinates(const ModalBasis& basis)
    : frequencies_(Eigen::Map<const Eigen::ArrayXd>(basis.frequencies.data(), std::ssize(basis.frequencies))),
      decays_(Eigen::Map<const Eigen::ArrayXd>(basis.decay_rates.data(), std::ssize(basis.decay_rates))),
      flexibilities_(frequencies_.square().inverse()),
      keep_(Eigen::ArrayXd::Ones(frequencies_.size())),
      pull_(Eigen::ArrayXd::Zero(frequencies_.size())),
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
    for (Eigen::Index mode = 0; mode < frequencies_.size(); ++mode) {
      rates_[mode] = rate_of_other_step(frequencies_[mode], decays_[mode], {step.before, step.length}, places_[mode],
                                        rates_[mode], flexibilities_[mode] * force[mode]);
    }
  }
  places_ += step.length * rates_;
}

Eigen::ArrayXd ModalCoordinates::next_rates(const Eigen::ArrayXd& force) const {
  return keep_ * rates_ + pull_ * (flexibilities_ * force - places_);
}

Eigen::ArrayXd ModalCoordinates::rates_now(const Step& step, const Eigen::ArrayXd& force) const {
  if (step.is_first()) {
    return rates_;
  }
  return (rates_ + next_rates(force)) / 2 *
         frequencies_.unaryExpr([&](double frequency) { return rate_correction(frequency, step.length); });
}

double ModalCoordinates::elastic_energy() const {
  return (frequencies_ * places_).square().sum() / 2;
}

void ModalCoordinates::archive(std::size_t mode, parallel::ArchiveRow& row) {
  row.value(places_[static_cast<Eigen::Index>(mode)]);
  row.value(rates_[static_cast<Eigen::Index>(mode)]);
}

}  // namespace idiophone::modal_bodies
