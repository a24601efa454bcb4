#pragma once
// Processor time that sound maps and proxies share. Two threads may compute them, and neither waits for the other.

#include <atomic>
#include <cstddef>
#include <span>
#include <vector>

namespace idiophone::voices {

/// Springs that one core computes in a second, on the machine on which the costs of modes were measured.
inline constexpr double usual_speed = 4e8;

/// What one body takes of a budget.
struct Claim {
  double priority = 0.0;
  double cost = 0.0;  ///< processor time per time of sound
};

/// The claims of one kind of voices. One thread makes them, another one asks.
class Claims {
 public:
  /// @param most  claims that are kept, the first ones; there is no allocation later
  explicit Claims(std::size_t most) { claims_.reserve(most); }

  /// These take the place of those before, unless the other thread asks at this moment.
  void make(std::span<const Claim> claims);

  /// Sum of the costs with at least this priority; with a greater one. The last sum while the other thread makes
  /// claims.
  [[nodiscard]] double at_least(double priority);
  [[nodiscard]] double above(double priority);

 private:
  template <class Counts>
  double sum_of(const Counts& counts);

  std::atomic_flag busy_;
  std::vector<Claim> claims_;
  double last_sum_ = 0.0;
};

struct SharedBudget {
  /// @param most_maps     of which claims are kept
  /// @param most_proxies  likewise
  SharedBudget(std::size_t most_maps, std::size_t most_proxies) : maps(most_maps), proxies(most_proxies) {}

  Claims maps, proxies;
};

}  // namespace idiophone::voices
