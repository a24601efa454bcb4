#include "residual_flexibility.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::modal_bodies {

namespace {

constexpr double damping_ratio = 0.1;

}  // namespace

ResidualFlexibility::ResidualFlexibility(const ModalBasis& basis, std::span<const double> mobility) {
  if (std::ranges::none_of(basis.residual, [](double flexibility) { return flexibility > 0; })) {
    return;
  }
  flexibility_ = basis.residual;
  frequency_.resize(basis.nodes());
  slot_.assign(basis.nodes(), none);
  const double highest = residual_frequency(basis);
  for (std::size_t node = 0; node < basis.nodes(); ++node) {
    if (flexibility_[node] > 0 && mobility[node] > 0) {
      frequency_[node] = std::min(highest, std::sqrt(mobility[node] / flexibility_[node]));
    } else {
      flexibility_[node] = 0.0;
    }
  }
}

void ResidualFlexibility::choose(std::span<const std::size_t> nodes, double step) {
  if (!exists() || (step == length_ && std::ranges::equal(nodes, chosen_))) {
    return;
  }
  length_ = step;
  std::vector<NodePack> packs((nodes.size() + solid::lanes - 1) / solid::lanes);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::size_t node = nodes[i];
    NodePack& pack = packs[i / solid::lanes];
    const std::size_t lane = i % solid::lanes;
    pack.flexibility[lane] = flexibility_[node];
    pack.frequency[lane] = frequency_[node];
    const OscillatorStep oscillator(frequency_[node], damping_ratio * frequency_[node], step);
    pack.keep[lane] = oscillator.keep;
    pack.pull[lane] = oscillator.pull;
    if (const std::size_t before = slot_[node]; before != none) {
      const NodePack& old = packs_[before / solid::lanes];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        pack.place.at(axis)[lane] = old.place.at(axis)[before % solid::lanes];
        pack.rate.at(axis)[lane] = old.rate.at(axis)[before % solid::lanes];
      }
    }
  }
  for (const std::size_t node : chosen_) {
    slot_[node] = none;
  }
  chosen_.assign(nodes.begin(), nodes.end());
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    slot_[chosen_[i]] = i;
  }
  packs_ = std::move(packs);
}

void ResidualFlexibility::advance(std::size_t pack, const PackVector& force, const Step& step) {
  if (!exists()) {
    return;
  }
  NodePack& nodes = packs_[pack];
  if (step.length != step.before) {
    change_length(nodes, force, step);
    return;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Pack& place = nodes.place.at(axis);
    Pack& rate = nodes.rate.at(axis);
    rate = nodes.keep * rate + nodes.pull * (nodes.flexibility * force.at(axis) - place);
    place += step.length * rate;
  }
}

void ResidualFlexibility::change_length(NodePack& nodes, const PackVector& force, const Step& step) {
  for (int lane = 0; lane < solid::lanes; ++lane) {
    const double frequency = nodes.frequency[lane];
    for (std::size_t axis = 0; axis < 3 && frequency > 0; ++axis) {
      Pack& place = nodes.place.at(axis);
      Pack& rate = nodes.rate.at(axis);
      rate[lane] = rate_of_other_step(frequency, damping_ratio * frequency, {step.before, step.length}, place[lane],
                                      rate[lane], nodes.flexibility[lane] * force.at(axis)[lane]);
      place[lane] += step.length * rate[lane];
    }
  }
}

void ResidualFlexibility::add(std::size_t pack, NodeGroup::Vibration& vibration) const {
  for (std::size_t axis = 0; exists() && axis < 3; ++axis) {
    vibration.displacement.at(axis) += packs_[pack].place.at(axis);
    vibration.velocity.at(axis) += packs_[pack].rate.at(axis);
  }
}

double ResidualFlexibility::inverse_mass(std::size_t node) const {
  return exists() ? frequency_[node] * frequency_[node] * flexibility_[node] : 0.0;
}

template <class Vector, class Inverse>
double ResidualFlexibility::sum_of_squares(Vector vector, Inverse inverse) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    const auto& [x, y, z] = packs_[i / solid::lanes].*vector;
    const std::size_t lane = i % solid::lanes;
    if (const double divisor = inverse(chosen_[i]); divisor > 0) {
      sum += (x[lane] * x[lane] + y[lane] * y[lane] + z[lane] * z[lane]) / divisor;
    }
  }
  return sum;
}

double ResidualFlexibility::kinetic_energy() const {
  return sum_of_squares(&NodePack::rate, [&](std::size_t node) { return inverse_mass(node); }) / 2;
}

double ResidualFlexibility::elastic_energy() const {
  return sum_of_squares(&NodePack::place, [&](std::size_t node) { return flexibility_[node]; }) / 2;
}

void ResidualFlexibility::archive(std::size_t node, parallel::ArchiveRow& row) {
  const std::size_t slot = slot_[node];
  for (const auto vector : {&NodePack::place, &NodePack::rate}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double value = slot == none ? 0.0 : (packs_[slot / solid::lanes].*vector).at(axis)[slot % solid::lanes];
      row.value(value);
      if (slot != none) {
        (packs_[slot / solid::lanes].*vector).at(axis)[slot % solid::lanes] = value;
      }
    }
  }
}

}  // namespace idiophone::modal_bodies
