#include "idiophone/solids/solid/solid.hpp"

#include <fmt/format.h>

#include "laws.hpp"
#include "tetrahedron_kernels.hpp"

namespace idiophone::solid {

namespace {

template <class T>
using Plain = std::remove_cvref_t<T>;

/// Calls visit(elements, law) with Kelvin-Voigt's law, or the elastic one for hexahedra without damping.
template <class Visitor>
void with_kelvin_voigt(const PackedElements& elements, const Elasticity& elasticity, double beta, Visitor visit) {
  std::visit(
      [&](const auto& packs, const auto& c) {
        if constexpr (std::is_same_v<Plain<decltype(packs)>, PackedHexahedra>) {
          if (beta == 0.0) {
            visit(packs, Undamped<Plain<decltype(c)>>{c});
            return;
          }
        }
        visit(packs, KelvinVoigt<Plain<decltype(c)>>{c, beta});
      },
      elements, elasticity);
}

/// Calls visit(elements, law) with Maxwell's law, which advances the memory unless it is const.
template <class Visitor, class SomeMemory>
void with_maxwell(const PackedElements& elements, const Elasticity& elasticity, SomeMemory& memory, Visitor visit) {
  constexpr MemoryUse use = std::is_const_v<SomeMemory> ? MemoryUse::read : MemoryUse::advance;
  std::visit(
      [&](const auto& packs, const auto& c) {
        visit(packs, Maxwell<Plain<decltype(c)>, use>{c, memory});
      },
      elements, elasticity);
}

Relaxation relaxation_of_loss(const scene::Damping& damping) {
  return damping.loss ? fit_relaxation(*damping.loss) : Relaxation{};
}

/// @throws deck::DeckError where creep is not slower than all of the loss factor's mechanisms
Relaxation find_relaxation(const scene::Damping& damping) {
  Relaxation loss = relaxation_of_loss(damping);
  const double creep = damping.of_vibration();
  if (creep == 0.0) {
    return loss;
  }
  for (const Relaxation::Mechanism& mechanism : loss.mechanisms) {
    if (mechanism.rate < 2 * creep) {
      throw deck::DeckError(
          damping.loss->where,
          fmt::format(
              "with mass_of: vibration, the damping `mass` must be below half the rate of the slowest mechanism "
              "of the loss factor, {:.4g} 1/s; it is {:.4g} 1/s. Give the loss factor a higher band",
              mechanism.rate, creep));
    }
  }
  return creeping(loss, creep);
}

}  // namespace

Solid::Solid(const mesh::BodyPart& part, std::span<const Vector3> reference, const scene::Material& material,
             const Eigen::Matrix3d& axes)
    : elements_(pack_elements(part, reference)),
      division_(PackDivision::undivided(std::visit([](const auto& packs) { return packs.pack_count(); }, elements_))),
      beta_(material.damping.stiffness),
      density_(material.density),
      relaxation_(find_relaxation(material.damping)),
      elasticity_(solid::elasticity(material, axes)),
      relaxed_(solid::elasticity(material, axes, relaxation_of_loss(material.damping).long_term)),
      instantaneous_(solid::elasticity(material, axes, relaxation_.instantaneous())) {}

void Solid::begin_memory(double step) {
  if (!relaxation_.mechanisms.empty()) {
    std::visit(
        [&](const auto& packs) { memory_.emplace(relaxation_, beta_, step, packs.pack_count(), packs.points()); },
        elements_);
  }
}

void Solid::add_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) const {
  const auto add = [&](const auto& packs, const auto& law) { packs.add_internal_force(law, state, force); };
  if (memory_) {
    with_maxwell(elements_, elasticity_, *memory_, add);
  } else {
    with_kelvin_voigt(elements_, relaxed_, beta_, add);
  }
}

void Solid::add_and_remember(std::span<const PackRange> ranges, std::span<const NodeState> state,
                             std::span<NodeForce> force) {
  const auto add = [&](const auto& packs, const auto& law) {
    for (const PackRange range : ranges) {
      packs.add_internal_force(law, range, &division_.held, state, force);
    }
  };
  if (memory_) {
    with_maxwell(elements_, elasticity_, *memory_, add);
  } else {
    with_kelvin_voigt(elements_, relaxed_, beta_, add);
  }
}

void Solid::begin_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) {
  add_and_remember(division_.inner, state, force);
}

void Solid::finish_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) {
  add_and_remember(division_.border, state, force);
  division_.held.add(force);
}

void Solid::add_mass(std::span<double> mass) const {
  std::visit([&](const auto& packs) { packs.add_mass(density_, mass); }, elements_);
}

void Solid::elastic_energy(std::span<const NodeState> state, std::span<double> energy) const {
  const auto find = [&](const auto& packs, const auto& law) { packs.elastic_energy(law, state, energy); };
  if (memory_) {
    with_maxwell(elements_, elasticity_, *memory_, find);
  } else {
    with_kelvin_voigt(elements_, relaxed_, beta_, find);
  }
}

void Solid::add_linear_stiffness_force(std::span<const NodeState> state, std::span<NodeForce> force) const {
  with_kelvin_voigt(elements_, instantaneous_, 1.0,
                    [&](const auto& packs, const auto& law) { packs.add_internal_force(law, state, force); });
}

double Solid::damping(double frequency) const {
  return beta_ / relaxation_.instantaneous() * frequency * frequency + relaxation_.instantaneous_damping();
}

Index Solid::element_count() const {
  return std::visit([](const auto& packs) { return packs.element_count(); }, elements_);
}

std::size_t Solid::bytes() const {
  return std::visit([](const auto& packs) { return packs.bytes(); }, elements_) + division_.held.bytes() +
         (memory_ ? memory_->bytes() : 0);
}

}  // namespace idiophone::solid
