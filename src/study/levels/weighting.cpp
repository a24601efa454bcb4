#include "idiophone/study/levels/weighting.hpp"

#include <cmath>

namespace idiophone::levels {

double a_weighting(double frequency) {
  const double square = frequency * frequency;
  const auto above = [square](double corner) { return square + corner * corner; };
  return 1.2589 * std::pow(12194.0, 2) * square * square /
         (above(20.6) * std::sqrt(above(107.7) * above(737.9)) * above(12194.0));
}

}  // namespace idiophone::levels
