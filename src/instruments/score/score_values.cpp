// What the numbers of an action mean. No decks: the library for engines has this file, too.

#include <cmath>
#include <numbers>

#include "idiophone/instruments/score/action.hpp"

namespace idiophone::score {

double Hammer::contact_duration() const {
  static const double factor = 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);  // 2.9433
  return factor * std::pow(1.25 * mass * speed * speed / hardness, 0.4) / speed;
}

}  // namespace idiophone::score
