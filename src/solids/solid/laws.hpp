#pragma once
// The material laws of the kernels. Those with damping need the gradients of two nodal fields, the displacement and a
// field that carries the rate of strain, and make of both the effective strain A: the second Piola-Kirchhoff stress is
// C A, with C the elasticity.

#include <type_traits>

#include "finite_strain.hpp"
#include "idiophone/solids/solid/memory.hpp"

namespace idiophone::solid {

/// Kelvin-Voigt (O'Brien and Hodgins 1999): A = E + beta E', the same as phi = beta lambda and psi = beta mu.
template <class Elasticity>
struct KelvinVoigt {
  Elasticity elasticity;
  double beta = 0.0;  ///< damping proportional to stiffness, s

  static constexpr bool has_rate_field = true;

  /// u + beta v, m
  [[nodiscard]] Pack rate_field(const Pack& displacement, const Pack& velocity) const {
    return displacement + beta * velocity;
  }

  /// A, without unit.
  /// @param h        dX-gradient of the displacement
  /// @param delayed  that of the rate field
  [[nodiscard]] PackSymmetric strain(const PackMatrix& h, const PackMatrix& delayed, std::size_t /*place*/) const {
    return delayed_strain(h, delayed);
  }

  /// Stored energy E : C E/2, J/m3.
  [[nodiscard]] Pack energy_density(const PackMatrix& h, const PackMatrix& /*delayed*/, std::size_t /*place*/) const {
    const PackSymmetric e = green_strain(h);
    return 0.5 * contract(e, elasticity.stress(e, Pack{} + 1.0));
  }
};

/// Elastic: A = E. It needs no second field. Tetrahedra use Kelvin-Voigt without damping instead, for the same bits as
/// ever; hexahedra gain a third of their speed.
template <class Elasticity>
struct Undamped {
  Elasticity elasticity;

  static constexpr bool has_rate_field = false;  ///< whether the gradient of a second field is needed

  /// A, without unit.
  /// @param h  dX-gradient of the displacement
  [[nodiscard]] PackSymmetric strain(const PackMatrix& h, const PackMatrix& /*h*/, std::size_t /*place*/) const {
    return green_strain(h);
  }

  /// Stored energy E : C E/2, J/m3.
  [[nodiscard]] Pack energy_density(const PackMatrix& h, const PackMatrix& /*h*/, std::size_t place) const {
    return KelvinVoigt<Elasticity>{elasticity, 0.0}.energy_density(h, h, place);
  }
};

/// What a law does to the memory: advance it to the present step, as is due once a step, or only read it.
enum class MemoryUse { advance, read };

/// A generalised Maxwell solid: A = long_term E + sum of overstrains + beta E' (memory.hpp).
template <class Elasticity, MemoryUse use>
struct Maxwell {
  Elasticity elasticity;
  std::conditional_t<use == MemoryUse::advance, Memory, const Memory>& memory;

  static constexpr bool has_rate_field = true;

  /// dt v, m: what the displacement has changed by in the step that led here, as v is the velocity at its middle
  [[nodiscard]] Pack rate_field(const Pack& /*displacement*/, const Pack& velocity) const {
    return memory.step() * velocity;
  }

  /// A, without unit.
  /// @param h       dX-gradient of the displacement
  /// @param change  that of the rate field
  /// @param place   pack times points of an element plus point
  [[nodiscard]] PackSymmetric strain(const PackMatrix& h, const PackMatrix& change, std::size_t place) const {
    const PackSymmetric e = green_strain(h);
    const PackSymmetric de = strain_change(h, change);
    auto* overstrain = memory.at(place);
    PackSymmetric sum;
    for (int c = 0; c < 6; ++c) {
      sum.at[c] = memory.long_term() * e.at[c] + memory.damping() * de.at[c];
    }
    for (const auto& [keep, gain, strength] : memory.mechanisms()) {
      for (int c = 0; c < 6; ++c) {
        const Pack q = keep * overstrain->at[c] + gain * de.at[c];
        sum.at[c] += q;
        if constexpr (use == MemoryUse::advance) {
          overstrain->at[c] = q;
        }
      }
      ++overstrain;
    }
    return sum;
  }

  /// Energy stored in the springs: long_term E : C E/2 + sum of Q : C Q/(2 strength), J/m3.
  [[nodiscard]] Pack energy_density(const PackMatrix& h, const PackMatrix& change, std::size_t place) const {
    const Pack one = Pack{} + 1.0;
    const PackSymmetric e = green_strain(h);
    const PackSymmetric de = strain_change(h, change);
    const auto* overstrain = memory.at(place);
    Pack energy = 0.5 * memory.long_term() * contract(e, elasticity.stress(e, one));
    for (const auto& [keep, gain, strength] : memory.mechanisms()) {
      PackSymmetric q;
      for (int c = 0; c < 6; ++c) {
        q.at[c] = keep * overstrain->at[c] + gain * de.at[c];
      }
      energy += 0.5 / strength * contract(q, elasticity.stress(q, one));
      ++overstrain;
    }
    return energy;
  }
};

/// A generalised Maxwell solid of which a part C_r of the elasticity relaxes (directional_loss.hpp): with the relaxed
/// strain R = long_term E + sum of overstrains, its stress is C (E + beta E') + C_r (R - E).
template <MemoryUse use>
struct DirectionalMaxwell : Maxwell<AnisotropicElasticity, use> {
  using Whole = Maxwell<AnisotropicElasticity, use>;

  AnisotropicElasticity relaxing;         ///< C_r
  AnisotropicElasticity relaxing_strain;  ///< C^-1 C_r, of a strain

  /// A, without unit. The arguments are those of Maxwell's law.
  [[nodiscard]] PackSymmetric strain(const PackMatrix& h, const PackMatrix& change, std::size_t place) const {
    const PackSymmetric e = green_strain(h);
    const PackSymmetric de = strain_change(h, change);
    PackSymmetric relaxed = Whole::strain(h, change, place);  // with beta E', which all of C has
    const double damping = this->memory.damping();
    for (int c = 0; c < 6; ++c) {
      relaxed.at[c] -= e.at[c] + damping * de.at[c];
    }
    PackSymmetric sum = relaxing_strain.stress(relaxed, Pack{} + 1.0);
    for (int c = 0; c < 6; ++c) {
      sum.at[c] += e.at[c] + damping * de.at[c];
    }
    return sum;
  }

  /// Energy stored in the springs: E : (C - C_r) E/2 and what Maxwell's law stores with C_r, J/m3.
  [[nodiscard]] Pack energy_density(const PackMatrix& h, const PackMatrix& change, std::size_t place) const {
    const Pack one = Pack{} + 1.0;
    const PackSymmetric e = green_strain(h);
    return Whole{relaxing, this->memory}.energy_density(h, change, place) +
           0.5 * (contract(e, this->elasticity.stress(e, one)) - contract(e, relaxing.stress(e, one)));
  }
};

/// A law of a body that is stressed where it rests: S = S0 + C A. S0 is C A0, so the kernels know nothing of it.
template <class Law>
struct Prestressed : Law {
  PackSymmetric initial;  ///< A0, without unit

  /// A0 + A, without unit. The arguments are those of the law.
  [[nodiscard]] PackSymmetric strain(const PackMatrix& h, const PackMatrix& rate, std::size_t place) const {
    PackSymmetric sum = Law::strain(h, rate, place);
    for (int c = 0; c < 6; ++c) {
      sum.at[c] += initial.at[c];
    }
    return sum;
  }

  /// Stored energy beyond that at rest: S0 : E besides the law's, J/m3.
  [[nodiscard]] Pack energy_density(const PackMatrix& h, const PackMatrix& rate, std::size_t place) const {
    return Law::energy_density(h, rate, place) +
           contract(green_strain(h), this->elasticity.stress(initial, Pack{} + 1.0));
  }
};

}  // namespace idiophone::solid
