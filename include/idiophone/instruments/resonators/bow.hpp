#pragma once
// A bow, or a finger, that rubs a body at a point.

#include <cstdint>
#include <optional>

#include "idiophone/foundation/friction/elasto_plastic_friction.hpp"
#include "idiophone/instruments/resonators/contact.hpp"
#include "idiophone/instruments/score/action.hpp"

namespace idiophone::resonators {

class Bow : public Contact {
 public:
  /// The load rises and falls over 10 ms where the bow begins and ends.
  Bow(const score::Bow& bow, int rate);

  [[nodiscard]] double force(double free, double compliance) const override;
  void advance(double way, double force) override;

  /// The score no longer does.
  void lead(const ContactMotion& motion, std::int64_t samples) override;

  /// In the next audio sample.
  [[nodiscard]] ContactMotion motion() const;

  [[nodiscard]] const friction::ElastoPlasticFriction& friction() const { return friction_; }

 private:
  /// From one motion to another.
  struct Lead {
    ContactMotion from, to;
    std::int64_t begin, samples;
  };

  score::Bow bow_;
  double step_;  // s
  friction::ElastoPlasticFriction friction_;
  std::int64_t now_ = 0;  // audio samples since the beginning
  std::optional<Lead> lead_;
};

}  // namespace idiophone::resonators
