#pragma once
// How much force players may ask for, because each second of it takes memory.

#include <cstdint>
#include <deque>

#include "idiophone/instruments/score/score.hpp"

namespace idiophone::drivers {

class ForceBudget {
 public:
  static constexpr double most = 60.0;  ///< s, of all forces together that are not over

  explicit ForceBudget(int rate) : rate_(rate) {}

  /// Takes the time of an event's force, until it is over. Call it before the force is computed.
  /// @param now  audio sample
  /// @throws std::runtime_error when there is not so much left
  void take(const score::ScoreEvent& event, std::int64_t now);

 private:
  struct Taken {
    std::int64_t end;  ///< audio sample
    double duration;   ///< s
  };
  int rate_;
  double taken_time_ = 0.0;  // s
  std::deque<Taken> taken_;
};

}  // namespace idiophone::drivers
