#include "idiophone/solids/solid/solid.hpp"

#include <algorithm>
#include <stdexcept>

#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/solids/solid/directional_loss.hpp"
#include "idiophone/solids/solid/material_relaxation.hpp"
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

/// The same with a part of the elasticity that relaxes. The elasticity is not isotropic.
template <class Visitor, class SomeRegion>
void with_directional_maxwell(const PackedElements& elements, SomeRegion& region, Visitor visit) {
  constexpr MemoryUse use = std::is_const_v<SomeRegion> ? MemoryUse::read : MemoryUse::advance;
  const auto& whole = std::get<AnisotropicElasticity>(region.elasticity);
  const auto& relaxing = std::get<AnisotropicElasticity>(region.relaxing);
  std::visit(
      [&](const auto& packs) {
        visit(packs, DirectionalMaxwell<use>{{whole, *region.memory}, relaxing, *region.relaxing_strain});
      },
      elements);
}

/// Calls visit(elements, law) with the law of a region's elements, which advances the memory unless the region is
/// const.
template <class SomeRegion, class Visitor>
void with_law(const PackedElements& elements, SomeRegion& region, Visitor visit) {
  const auto prestressed = [&](const auto& packs, const auto& law) {
    const auto& [initial, initial_relaxed] = *region.initial_strains;
    visit(packs, Prestressed<Plain<decltype(law)>>{law, region.memory ? initial : initial_relaxed});
  };
  const auto with_strain = [&](auto visit_law) {
    if (region.memory && region.relaxing_strain) {
      with_directional_maxwell(elements, region, visit_law);
    } else if (region.memory) {
      with_maxwell(elements, region.elasticity, *region.memory, visit_law);
    } else {
      with_kelvin_voigt(elements, region.relaxed, region.beta, visit_law);
    }
  };
  if (region.initial_strains) {
    with_strain(prestressed);
  } else {
    with_strain(visit);
  }
}

}  // namespace

namespace {

/// Modulus of a material after an eternity at rest, without creep.
/// @param relaxation  of the material, which the fit of its loss factor takes long to find again
double modulus_at_rest(const scene::Damping& damping, const Relaxation& relaxation) {
  return damping.of_vibration() == 0.0 ? relaxation.long_term : relaxation_of_loss(damping).long_term;
}

}  // namespace

Solid::Region::Region(const OrientedMaterial& oriented, PackRange its_packs)
    : packs(its_packs),
      beta(oriented.material.damping.stiffness),
      density(oriented.material.density),
      relaxation(relaxation_of(oriented.material.damping)),
      elasticity(solid::elasticity(oriented.material, oriented.axes)),
      relaxing(solid::relaxing_elasticity(oriented)),
      relaxed(elasticity_at(oriented, modulus_at_rest(oriented.material.damping, relaxation))),
      instantaneous(elasticity_at(oriented, relaxation.instantaneous())),
      stress(oriented.stress) {
  if (oriented.material.damping.has_directional_loss()) {
    relaxing_strain = solid::relaxing_strain(oriented);
    largest_relaxing_share = solid::largest_relaxing_share(oriented);
  }
  if (!stress.isZero(0.0)) {
    initial_strains = {strain_of(elasticity, stress), strain_of(relaxed, stress)};
  }
}

double Solid::Region::most_damping(double frequency) const {
  const double instant = relaxation.instantaneous();
  const double by_stiffness = beta * frequency * frequency;
  if (!largest_relaxing_share) {
    return by_stiffness / instant + relaxation.instantaneous_damping();
  }
  // C_r may be none of the stiffness that resists a motion: K is then that of C. At most it is this share of C.
  const double share = *largest_relaxing_share;
  return by_stiffness + relaxation.instantaneous_damping() * instant * share / (1 + (instant - 1) * share);
}

Solid::Solid(const mesh::BodyPart& part, std::span<const Vector3> reference,
             std::span<const OrientedMaterial> materials)
    : elements_(pack_elements(part, reference)), division_(PackDivision::undivided(layout().pack_count())) {
  if (!part.regions.empty() && static_cast<std::size_t>(std::ranges::max(part.regions)) >= materials.size()) {
    throw std::logic_error("a material region of a body has no material");
  }
  for (const OrientedMaterial& material : materials) {
    regions_.emplace_back(material, layout().region(regions_.size()));
  }
}

const PackLayout& Solid::layout() const {
  return std::visit([](const auto& packs) -> const PackLayout& { return packs.layout(); }, elements_);
}

std::size_t Solid::points() const {
  return std::visit([](const auto& packs) { return packs.points(); }, elements_);
}

void Solid::begin_memory(double step) {
  for (Region& region : regions_) {
    if (!region.relaxation.mechanisms.empty()) {
      region.memory.emplace(region.relaxation, region.beta, step, region.packs, points());
    }
  }
}

void Solid::add_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) const {
  for (const Region& region : regions_) {
    with_law(elements_, region, [&](const auto& packs, const auto& law) {
      packs.add_internal_force(law, region.packs, nullptr, state, force);
    });
  }
}

void Solid::add_and_remember(std::span<const PackRange> ranges, std::span<const NodeState> state,
                             std::span<NodeForce> force) {
  for (Region& region : regions_) {
    with_law(elements_, region, [&](const auto& packs, const auto& law) {
      for (const PackRange range : ranges) {
        packs.add_internal_force(law, common(range, region.packs), &division_.held, state, force);
      }
    });
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
  for (const Region& region : regions_) {
    std::visit([&](const auto& packs) { packs.add_mass(region.density, region.packs, mass); }, elements_);
  }
}

void Solid::elastic_energy(std::span<const NodeState> state, std::span<double> energy) const {
  for (const Region& region : regions_) {
    with_law(elements_, region,
             [&](const auto& packs, const auto& law) { packs.elastic_energy(law, region.packs, state, energy); });
  }
}

void Solid::add_linear_stiffness_force(std::span<const NodeState> state, std::span<NodeForce> force) const {
  for (std::size_t region = 0; region < regions_.size(); ++region) {
    add_linear_stiffness_force(region, regions_[region].instantaneous, state, force);
  }
}

void Solid::add_linear_stiffness_force(std::size_t region, const Elasticity& elasticity,
                                       std::span<const NodeState> state, std::span<NodeForce> force) const {
  with_kelvin_voigt(elements_, elasticity, 1.0, [&](const auto& packs, const auto& law) {
    packs.add_internal_force(law, regions_[region].packs, nullptr, state, force);
  });
}

double Solid::damping(double frequency) const {
  double most = 0.0;
  for (const Region& region : regions_) {
    most = std::max(most, region.most_damping(frequency));
  }
  return most;
}

bool Solid::is_prestressed() const {
  return std::ranges::any_of(regions_, [](const Region& region) { return region.initial_strains.has_value(); });
}

double Solid::geometric_share() const {
  double largest = 0.0;
  for (const Region& region : regions_) {
    const double pull = dense::eigenpairs(Eigen::MatrixXd(region.stress)).values[2];
    largest = std::max(largest, 2 * pull / least_stiffness(region.instantaneous));
  }
  return largest;
}

bool Solid::has_memory() const {
  return std::ranges::any_of(regions_, [](const Region& region) { return region.memory.has_value(); });
}

void Solid::archive_memory(std::size_t element, parallel::ArchiveRow& row) {
  const std::size_t pack = layout().pack_of(element);
  std::size_t width = 0;  // of all rows: elements without so many mechanisms have zeros in the place of the others
  for (Region& region : regions_) {
    width = std::max(width, 6 * points() * region.relaxation.mechanisms.size());
    if (region.memory && region.packs.begin <= pack && pack < region.packs.end) {
      region.memory->archive(pack, element - layout().first_element(pack), row);
    }
  }
  for (double none = 0.0; row.count() < width;) {
    row.value(none);
  }
}

std::size_t Solid::bytes() const {
  std::size_t sum = std::visit([](const auto& packs) { return packs.bytes(); }, elements_) + division_.held.bytes();
  for (const Region& region : regions_) {
    sum += region.memory ? region.memory->bytes() : 0;
  }
  return sum;
}

}  // namespace idiophone::solid
