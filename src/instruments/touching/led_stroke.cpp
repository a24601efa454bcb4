#include "idiophone/instruments/touching/led_stroke.hpp"

#include <algorithm>
#include <utility>

namespace idiophone::touching {

LedStroke::LedStroke(const score::Stroke& stroke, std::uint64_t seed, int rate, std::int64_t start)
    : forces_(stroke, seed, rate), rising_(forces_.next(0).back().force), next_(start) {}

LedStroke::Piece LedStroke::next(std::int64_t now) {
  std::vector<resonators::PointForce> following = forces_.next(0);
  Piece piece{.start = std::max(now, next_), .force = std::move(rising_)};
  const resonators::ForceCurve& falling = following.front().force;
  piece.force.insert(piece.force.end(), falling.begin(), falling.end());
  rising_ = std::move(following.back().force);
  next_ = piece.start + block;
  return piece;
}

}  // namespace idiophone::touching
