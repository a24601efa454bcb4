#include "residual_flexibility.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::motion {

namespace {

constexpr double damping_ratio = 0.1;

double sum(const Pack& pack) {
  double total = 0.0;
  for (int lane = 0; lane < solid::lanes; ++lane) {
    total += pack[lane];
  }
  return total;
}

}  // namespace

ResidualFlexibility::ResidualFlexibility(const ModalBasis& basis, std::span<const double> mobility) {
  if (std::ranges::none_of(basis.residual, [](double flexibility) { return flexibility > 0; })) {
    return;
  }
  const std::size_t packs = (basis.nodes() + solid::lanes - 1) / solid::lanes;
  for (std::vector<Pack>* values : {&flexibility_, &frequency_, &keep_, &pull_}) {
    values->resize(packs);
  }
  place_.resize(packs);
  rate_.resize(packs);
  const double highest = residual_frequency(basis);
  for (std::size_t node = 0; node < basis.residual.size(); ++node) {
    const double flexibility = basis.residual[node];
    if (flexibility > 0 && mobility[node] > 0) {
      const std::size_t lane = node % solid::lanes;
      flexibility_[node / solid::lanes][lane] = flexibility;
      frequency_[node / solid::lanes][lane] = std::min(highest, std::sqrt(mobility[node] / flexibility));
    }
  }
}

void ResidualFlexibility::begin(double step) {
  for (std::size_t pack = 0; pack < frequency_.size(); ++pack) {
    for (int lane = 0; lane < solid::lanes; ++lane) {
      const double frequency = frequency_[pack][lane];
      const OscillatorStep oscillator(frequency, damping_ratio * frequency, step);
      keep_[pack][lane] = oscillator.keep;
      pull_[pack][lane] = oscillator.pull;
    }
  }
}

void ResidualFlexibility::advance(std::size_t pack, const PackVector& force, double step) {
  for (std::size_t axis = 0; exists() && axis < 3; ++axis) {
    Pack& place = place_[pack].at(axis);
    Pack& rate = rate_[pack].at(axis);
    rate = keep_[pack] * rate + pull_[pack] * (flexibility_[pack] * force.at(axis) - place);
    place += step * rate;
  }
}

void ResidualFlexibility::rest_but(std::span<const std::size_t> packs) {
  auto next = packs.begin();
  for (std::size_t pack = 0; pack < place_.size(); ++pack) {
    if (next != packs.end() && *next == pack) {
      ++next;
    } else {
      place_[pack] = rate_[pack] = {};
    }
  }
}

void ResidualFlexibility::add(std::size_t pack, ModalShapes::Vibration& vibration) const {
  for (std::size_t axis = 0; exists() && axis < 3; ++axis) {
    vibration.displacement.at(axis) += place_[pack].at(axis);
    vibration.velocity.at(axis) += rate_[pack].at(axis);
  }
}

double ResidualFlexibility::inverse_mass(std::size_t node) const {
  if (!exists()) {
    return 0.0;
  }
  const std::size_t pack = node / solid::lanes;
  const std::size_t lane = node % solid::lanes;
  return frequency_[pack][lane] * frequency_[pack][lane] * flexibility_[pack][lane];
}

double ResidualFlexibility::kinetic_energy() const {
  double energy = 0.0;
  for (std::size_t pack = 0; pack < rate_.size(); ++pack) {
    const auto& [x, y, z] = rate_[pack];
    const Pack compliance = frequency_[pack] * frequency_[pack] * flexibility_[pack];
    energy += sum(compliance > 0 ? (x * x + y * y + z * z) / compliance : Pack{}) / 2;
  }
  return energy;
}

double ResidualFlexibility::elastic_energy() const {
  double energy = 0.0;
  for (std::size_t pack = 0; pack < place_.size(); ++pack) {
    const auto& [x, y, z] = place_[pack];
    energy += sum(flexibility_[pack] > 0 ? (x * x + y * y + z * z) / flexibility_[pack] : Pack{}) / 2;
  }
  return energy;
}

void ResidualFlexibility::archive(std::size_t node, parallel::ArchiveRow& row) {
  for (std::vector<PackVector>* vectors : {&place_, &rate_}) {
    for (Pack& pack : (*vectors)[node / solid::lanes]) {
      double value = pack[node % solid::lanes];
      row.value(value);
      pack[node % solid::lanes] = value;
    }
  }
}

}  // namespace idiophone::motion
