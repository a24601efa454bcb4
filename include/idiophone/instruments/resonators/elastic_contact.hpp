#pragma once
// Elastic contact across a gap: of a body with a rigid stop or a loose mass, or of two bodies with each other.

#include <cstdint>
#include <limits>

#include "idiophone/instruments/resonators/contact.hpp"
#include "idiophone/instruments/score/action.hpp"

namespace idiophone::resonators {

/// The force of contact is that of Hunt and Crossley (J. Applied Mechanics 42, 1975),
///
///   force = hardness x^exponent (1 + loss x'),
///
/// of the approach x, not below zero. In an audio sample, the first part is the exact difference of the stored energy,
/// hardness x^(exponent + 1)/(exponent + 1), over that of x; the second takes the mean x. So what the bodies lose is
/// what is stored, and a loss that is never negative.
class ElasticContact : public Contact {
 public:
  /// What is on the other side of the gap, unless it is a body.
  struct Mass {
    double mass = std::numeric_limits<double>::infinity();  ///< kg; infinite: a rigid stop
    double speed = 0.0;                                     ///< towards the body at first, m/s
    double load = 0.0;                                      ///< that presses it towards the body, N
  };

  /// A negative gap and a load rise over 10 ms, so that nothing clicks when they begin.
  /// @param gap  m, over the time in s; negative: what touches would overlap so far without a force
  ElasticContact(const score::Elasticity& law, scene::Course gap, const Mass& mass, int rate);

  [[nodiscard]] double force(double free, double compliance) const override;
  void advance(double way, double force) override;

  /// Whether nothing happens as long as the body is at rest.
  [[nodiscard]] bool is_at_rest() const;

  [[nodiscard]] double approach() const { return approach_; }  ///< m; negative: the gap
  [[nodiscard]] double speed() const { return mass_.speed; }   ///< of the mass towards the body, m/s
  /// Of the contact, J.
  [[nodiscard]] double stored_energy() const { return stored(approach_); }

 protected:
  [[nodiscard]] double deepest() const { return deepest_; }  ///< approach so far, m

 private:
  /// J; 0 in the gap.
  [[nodiscard]] double stored(double approach) const;
  /// While the approach changes by so much in an audio sample, N.
  [[nodiscard]] double force_of(double change) const;
  /// How far a negative gap and a load have risen at an audio sample, 0 to 1.
  [[nodiscard]] double risen(std::int64_t sample) const;
  /// At the beginning of an audio sample, m.
  [[nodiscard]] double gap(std::int64_t sample) const;
  /// Finds what gap and load do in the next audio sample.
  void look_ahead();

  score::Elasticity law_;
  scene::Course gap_;
  double energy_scale_;   // of the stored energy, J/m^(exponent + 1)
  Mass mass_;             // its speed is the present one
  double step_;           // s
  std::int64_t now_ = 0;  // audio samples since the beginning
  double approach_, deepest_ = 0.0;
  double closing_ = 0.0, load_ = 0.0;  // of the next sample: by how much the gap falls, m; N
};

}  // namespace idiophone::resonators
