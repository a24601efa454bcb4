#include "reverberator.hpp"

#include <cmath>

namespace idiophone::timbre {

namespace {

std::vector<std::size_t> lengths_of_lines(int rate) {
  std::vector<std::size_t> lengths;
  for (const double time : {0.02973, 0.03319, 0.03711, 0.04111, 0.04537, 0.05077, 0.05623, 0.06287}) {  // s
    lengths.push_back(static_cast<std::size_t>(std::lround(time * rate)) | 1U);
  }
  return lengths;
}

}  // namespace

Reverberator::Reverberator(double decay, int rate) : lines_(lengths_of_lines(rate), decay, rate) {}

double Reverberator::step(double input) {
  double sound = 0.0, sign = 1.0;
  for (const double arriving : lines_.step(input)) {
    sound += sign * arriving;
    sign = -sign;
  }
  return sound / std::sqrt(static_cast<double>(lines_.size()));
}

}  // namespace idiophone::timbre
