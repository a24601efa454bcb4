#include "idiophone/instruments/voices/shared_budget.hpp"

#include <algorithm>

namespace idiophone::voices {

void Claims::make(std::span<const Claim> claims) {
  if (!busy_.test_and_set(std::memory_order_acquire)) {
    const std::span<const Claim> kept = claims.first(std::min(claims.size(), claims_.capacity()));
    claims_.assign(kept.begin(), kept.end());
    busy_.clear(std::memory_order_release);
  }
}

template <class Counts>
double Claims::sum_of(const Counts& counts) {
  if (!busy_.test_and_set(std::memory_order_acquire)) {
    last_sum_ = 0.0;
    for (const Claim& claim : claims_) {
      last_sum_ += counts(claim) ? claim.cost : 0.0;
    }
    busy_.clear(std::memory_order_release);
  }
  return last_sum_;
}

double Claims::at_least(double priority) {
  return sum_of([priority](const Claim& claim) { return claim.priority >= priority; });
}

double Claims::above(double priority) {
  return sum_of([priority](const Claim& claim) { return claim.priority > priority; });
}

}  // namespace idiophone::voices
