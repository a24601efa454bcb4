#include "beam_modes.hpp"

#include <cmath>
#include <numbers>

namespace idiophone::sound_maps {

using std::numbers::pi;

namespace {

using Ends = sound_maps::IdealBody::Ends;

/// Root of cos x = sign/cosh x near a multiple of pi/2.
double root_near(double x, double sign) {
  for (int newton = 0; newton < 30; ++newton) {
    const double rest = std::cos(x) - sign / std::cosh(x);
    x -= rest / (-std::sin(x) + sign * std::tanh(x) / std::cosh(x));
  }
  return x;
}

/// cosh(b x) -+ cos(b x) - sigma (sinh(b x) -+ sin(b x)), without the differences of large numbers.
/// @param rest  (1 - sigma) exp(b)/2
/// @param sign  of the circular functions: -1 of an end at x = 0 that is clamped, +1 of a free one
double shape_of(double b, double x, double sigma, double rest, double sign) {
  const double hyperbolic = 0.5 * (1 + sigma) * std::exp(-b * x) + rest * std::exp(b * (x - 1));
  return hyperbolic + sign * (std::cos(b * x) - sigma * std::sin(b * x));
}

}  // namespace

double beam_root(Ends ends, int n) {
  switch (ends) {
    case Ends::supported:
      return pi * n;
    case Ends::clamped_free:
      return root_near(pi * (n - 0.5) + (n == 1 ? 0.3 : 0.0), -1.0);
    case Ends::free:
    case Ends::clamped:
      break;
  }
  return root_near(pi * (n + 0.5), 1.0);
}

double beam_shape(Ends ends, double root, double x) {
  if (ends == Ends::supported) {
    return std::numbers::sqrt2 * std::sin(root * x);
  }
  const double decay = std::exp(-root);
  const double cosine = std::cos(root);
  const double sine = std::sin(root);
  const double other = ends == Ends::clamped_free ? 1.0 : -1.0;
  const double divisor = 0.5 * (1 - decay * decay) + other * decay * sine;  // exp(-b) (sinh b +- sin b)
  const double sigma = (0.5 * (1 + decay * decay) + other * decay * cosine) / divisor;
  const double rest = 0.5 * (other * (sine - cosine) - decay) / divisor;
  return shape_of(root, x, sigma, rest, ends == Ends::free ? 1.0 : -1.0);
}

}  // namespace idiophone::sound_maps
