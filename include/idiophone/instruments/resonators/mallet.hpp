#pragma once
// A mallet that strikes a body and feels how the body gives way.

#include "idiophone/instruments/resonators/elastic_contact.hpp"

namespace idiophone::resonators {

/// A free mass with a round head.
class Mallet : public ElasticContact {
 public:
  /// It touches the body, with its whole speed. @param loss  s/m, not negative
  Mallet(const score::Hammer& hammer, double loss, int rate);

  /// Whether it has left for good: it flies back, and is farther away than five times the deepest approach.
  [[nodiscard]] bool is_over() const override;
};

}  // namespace idiophone::resonators
