#pragma once
// A mallet that strikes a body and feels how the body gives way.

#include "idiophone/instruments/resonators/contact.hpp"

namespace idiophone::resonators {

/// A free mass with a round head. The force of contact is that of Hunt and Crossley (J. Applied Mechanics 42, 1975),
///
///   force = hardness x^(3/2) (1 + loss x'),
///
/// of the approach x, not below zero. In an audio sample, the first part is the exact difference of the stored energy,
/// 2/5 hardness x^(5/2), over that of x; the second takes the mean x. So what the mallet loses is what the modes get,
/// what is stored, and a loss that is never negative.
class Mallet : public Contact {
 public:
  /// It touches the body, with its whole speed. @param loss  s/m, not negative
  Mallet(const score::Hammer& hammer, double loss, int rate);

  [[nodiscard]] double force(double free, double compliance) const override;
  void advance(double way, double force) override;

  /// Whether it has left for good: it flies back, and is farther away than five times the deepest approach.
  [[nodiscard]] bool is_over() const override;

  [[nodiscard]] double approach() const { return approach_; }  ///< m; negative: the gap
  [[nodiscard]] double speed() const { return speed_; }        ///< towards the body, m/s
  /// Of the contact, J.
  [[nodiscard]] double stored_energy() const { return stored(approach_); }

 private:
  [[nodiscard]] double stored(double approach) const;
  /// While the approach changes by so much in an audio sample, N.
  [[nodiscard]] double force_of(double change) const;

  score::Hammer hammer_;
  double loss_;
  double step_;  // s
  double approach_ = 0.0, deepest_ = 0.0;
  double speed_;
};

}  // namespace idiophone::resonators
