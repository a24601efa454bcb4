#pragma once
// A bow that the pointer leads over a body of the page.

#include <cstdint>
#include <vector>

#include "idiophone/instruments/resonators/bow.hpp"
#include "idiophone/instruments/score/action.hpp"

namespace idiophone::page_sound {

/// phi of a place and a direction, [modes] 1/sqrt(kg).
using Participation = std::vector<double>;

class PageBow {
 public:
  /// It neither moves nor presses yet.
  PageBow(const friction::Law& friction, Participation place, int rate);

  /// The bow gets to this motion and this place evenly, in 20 ms.
  void lead(const resonators::ContactMotion& motion, Participation place);

  /// The load falls to zero.
  void lift();

  /// The place of the next samples, which then are over.
  [[nodiscard]] Participation next_place(std::int64_t samples);

  /// Audio samples since it was lifted and its load fell to zero; 0 or less before.
  [[nodiscard]] std::int64_t since_end() const { return is_lifted_ ? moved_ - follow_ : 0; }

  [[nodiscard]] resonators::Bow& contact() { return bow_; }

  resonators::ContactPoint point{};  ///< where it touches the body in the present samples

 private:
  resonators::Bow bow_;
  std::int64_t follow_;  // audio samples in which it follows
  Participation from_, to_;
  std::int64_t moved_ = 0;  // audio samples since it left `from_`
  bool is_lifted_ = false;
};

}  // namespace idiophone::page_sound
