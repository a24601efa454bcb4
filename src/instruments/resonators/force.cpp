#include "idiophone/instruments/resonators/force.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace idiophone::resonators {

namespace {

constexpr double pi = std::numbers::pi;

/// Gauss' quadrature over -1 to 1.
constexpr std::array<std::array<double, 2>, 4> gauss = {{{-0.861136311594052575, 0.347854845137453857},
                                                         {-0.339981043584856265, 0.652145154862546143},
                                                         {0.339981043584856265, 0.652145154862546143},
                                                         {0.861136311594052575, 0.347854845137453857}}};
constexpr int quarters = 4;  // of the part of an audio sample in which the force acts, each with the four points

}  // namespace

ForceCurve sampled(const std::function<double(double time)>& force, double duration, int rate) {
  const double samples = duration * rate;
  ForceCurve pieces(static_cast<std::size_t>(std::ceil(samples)));
  for (std::size_t n = 0; n < pieces.size(); ++n) {
    const double part = std::min(1.0, samples - static_cast<double>(n));
    pieces[n].begin = force(static_cast<double>(n) / rate);
    for (int quarter = 0; quarter < quarters; ++quarter) {
      for (const auto& [point, weight] : gauss) {
        const double s = part * (quarter + 0.5 * (1.0 + point)) / quarters;
        const double share = part * 0.5 * weight / quarters * force((static_cast<double>(n) + s) / rate);
        pieces[n].mean += share;
        pieces[n].slope += 3.0 * (2.0 * s - 1.0) * share;
      }
    }
  }
  return pieces;
}

HertzPulse::HertzPulse(const score::Hammer& hammer) : duration(hammer.contact_duration()) {
  const double mean_of_shape = std::tgamma(1.25) / (std::sqrt(pi) * std::tgamma(1.75));
  peak = 2.0 * hammer.mass * hammer.speed / (mean_of_shape * duration);
}

double HertzPulse::at(double time) const {
  return time > 0.0 && time < duration ? peak * std::pow(std::sin(pi * time / duration), 1.5) : 0.0;
}

}  // namespace idiophone::resonators
