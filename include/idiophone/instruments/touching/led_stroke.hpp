#pragma once
// Scraping or rolling that a physics engine leads.

#include <cstdint>

#include "idiophone/instruments/resonators/running_stroke.hpp"

namespace idiophone::touching {

/// The force of a stroke as pieces of two blocks that overlap. Each piece rises from zero in its first block and falls
/// to zero in the second, as those of resonators::RunningStroke do. So nothing clicks if the engine is late or gone,
/// and each piece can act at a place of its own.
class LedStroke {
 public:
  static constexpr auto block = static_cast<std::int64_t>(resonators::RunningStroke::block);

  /// @param start  audio sample of the first piece
  LedStroke(const score::Stroke& stroke, std::uint64_t seed, int rate, std::int64_t start);

  /// As RunningStroke::change().
  void lead(double speed, double load) { forces_.change(speed, load); }
  void end() { forces_.end(); }
  [[nodiscard]] bool is_over() const { return forces_.is_over(); }

  /// Whether the next piece has to begin before an audio sample.
  [[nodiscard]] bool is_due(std::int64_t until) const { return next_ < until && !is_over(); }

  struct Piece {
    std::int64_t start = 0;  ///< audio sample
    resonators::ForceCurve force;
  };
  /// @param now  audio sample: the piece begins there if it is late
  [[nodiscard]] Piece next(std::int64_t now);

 private:
  resonators::RunningStroke forces_;
  resonators::ForceCurve rising_;  // of the next piece
  std::int64_t next_;
};

}  // namespace idiophone::touching
