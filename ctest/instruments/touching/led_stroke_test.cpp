#include "idiophone/instruments/touching/led_stroke.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "surface_pair.hpp"

namespace idiophone::touching {

namespace {

constexpr int rate = 48000;
const Surface steel;

}  // namespace

/// So nothing clicks when the engine stops telling.
TEST(LedStroke, EachPieceRisesFromZeroAndFallsToZero) {
  score::Stroke stroke = stroke_of(score::Stroke::Kind::scrape, 0.01, steel, steel);
  stroke.speed = 0.5;
  stroke.load = 0.6;
  LedStroke led(stroke, 1, rate, 1000);
  for (std::int64_t start : {1000L, 1000 + LedStroke::block}) {
    const LedStroke::Piece piece = led.next(0);
    EXPECT_EQ(piece.start, start);
    ASSERT_EQ(std::ssize(piece.force), 2 * LedStroke::block);
    const double largest = std::ranges::max(piece.force, {}, &resonators::ForcePiece::mean).mean;
    EXPECT_LT(piece.force.front().mean, 0.01 * largest);
    EXPECT_LT(piece.force.back().mean, 0.01 * largest);
    const auto middle = std::span(piece.force).subspan(LedStroke::block - 64, 128);
    EXPECT_GT(std::ranges::max(middle, {}, &resonators::ForcePiece::mean).mean, 0.01 * largest);
  }
}

}  // namespace idiophone::touching
