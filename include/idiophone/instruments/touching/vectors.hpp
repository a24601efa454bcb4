#pragma once
// Between the numbers of an engine and vectors.

#include "idiophone/foundation/types.hpp"
#include "idiophone/instruments/touching/contact_events.hpp"

namespace idiophone::touching {

inline Vector3 vector_of(const Triple& triple) {
  return {triple[0], triple[1], triple[2]};
}

inline Triple triple_of(const Vector3& vector) {
  return {vector[0], vector[1], vector[2]};
}

}  // namespace idiophone::touching
