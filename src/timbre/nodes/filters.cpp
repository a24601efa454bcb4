// Filters. A constant frequency that is not between 0 and half the rate is a mistake of the tree. One that changes
// gives "not a number", which ends the rendering with an error.

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "idiophone/timbre/nodes/limp_wall.hpp"
#include "idiophone/timbre/nodes/node_types.hpp"

namespace idiophone::timbre {

namespace {

using std::numbers::pi;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool is_possible(double frequency, double rate) {
  return frequency > 0.0 && 2.0 * frequency < rate;
}

/// y' = 2 pi f (x - y), exact for steps.
class OnePole {
 public:
  using Arguments = std::array<double, 2>;  // signal, frequency
  enum class Part { low, high };

  OnePole(int rate, Part part) : rate_(rate), part_(part) {}

  double step(const Moment& /*moment*/, const Arguments& arguments) {
    const auto [input, frequency] = arguments;
    if (frequency != frequency_) {
      frequency_ = frequency;
      share_ = is_possible(frequency, rate_) ? -std::expm1(-2.0 * pi * frequency / rate_) : not_a_number;
    }
    low_ = without_denormals(low_ + share_ * (input - low_));
    return part_ == Part::low ? low_ : input - low_;
  }

 private:
  double rate_;
  Part part_;
  double frequency_ = 0.0, share_ = not_a_number;
  double low_ = 0.0;
};

/// A state-variable filter by the trapezoidal rule (Zavalishin 2012, "The Art of VA Filter Design"): it stays stable
/// while its frequency changes.
class BandPass {
 public:
  using Arguments = std::array<double, 3>;  // signal, frequency, quality

  explicit BandPass(int rate) : rate_(rate) {}

  double step(const Moment& /*moment*/, const Arguments& arguments) {
    const auto [input, frequency, quality] = arguments;
    if (frequency != frequency_ || quality != quality_) {
      frequency_ = frequency;
      quality_ = quality;
      slope_ = is_possible(frequency, rate_) && quality > 0.0 ? std::tan(pi * frequency / rate_) : not_a_number;
      gain_ = 1.0 / (1.0 + slope_ * (slope_ + 1.0 / quality));
    }
    const double rest = input - low_;
    const double band = gain_ * (band_ + slope_ * rest);
    const double low = low_ + slope_ * band;
    band_ = without_denormals(2.0 * band - band_);
    low_ = without_denormals(2.0 * low - low_);
    return band / quality;
  }

 private:
  double rate_;
  double frequency_ = 0.0, quality_ = 0.0, slope_ = not_a_number, gain_ = not_a_number;
  double band_ = 0.0, low_ = 0.0;
};

/// y = b0 x + b1 x' + b2 x'' - a1 y' - a2 y'', in the transposed direct form II.
class Biquad {
 public:
  using Arguments = std::array<double, 6>;  // signal, b0, b1, b2, a1, a2

  double step(const Moment& /*moment*/, const Arguments& a) {
    const double output = a[1] * a[0] + first_;
    first_ = without_denormals(a[2] * a[0] - a[4] * output + second_);
    second_ = without_denormals(a[3] * a[0] - a[5] * output);
    return output;
  }

 private:
  double first_ = 0.0, second_ = 0.0;
};

/// A signal behind a limp wall, which it meets along its normal.
class Transmission {
 public:
  using Arguments = std::array<double, 2>;  // signal, surface density

  explicit Transmission(int rate) : rate_(rate) {}

  double step(const Moment& /*moment*/, const Arguments& arguments) {
    const auto [input, density] = arguments;
    if (density != density_) {
      density_ = density;
      wall_.tune(density >= 0.0 ? LimpWall::corner(density, 1.0, impedance) / rate_ : not_a_number);
    }
    return wall_.step(input);
  }

 private:
  static constexpr double impedance = 415.0;  // rho c of air at 20 C, Pa s/m
  double rate_;
  double density_ = not_a_number;
  LimpWall wall_;
};

/// A finite impulse response, as plain sums.
class FiniteResponse {
 public:
  using Arguments = std::array<double, 1>;

  explicit FiniteResponse(std::vector<double> taps) : taps_(std::move(taps)), past_(taps_.size()) {}

  double step(const Moment& /*moment*/, const Arguments& arguments) {
    past_[newest_] = arguments[0];
    double sum = 0.0;
    for (std::size_t k = 0; k < taps_.size(); ++k) {
      sum += taps_[k] * past_[(newest_ + taps_.size() - k) % taps_.size()];
    }
    newest_ = (newest_ + 1) % taps_.size();
    return sum;
  }

 private:
  std::vector<double> taps_, past_;
  std::size_t newest_ = 0;
};

/// A filter of two states that was inaudible for so long (s) has forgotten what excited it.
double state_memory(const Call& /*call*/) {
  return 1e-3;
}

/// The second argument of all filters with a frequency.
void require_possible_frequency(const Call& call) {
  const int rate = call.sound_start.rate;
  call.require(
      1, [rate](double frequency) { return is_possible(frequency, rate); },
      "the frequency of a filter is between 0 and half the rate");
}

template <OnePole::Part part>
std::unique_ptr<Node> one_pole(const Call& call) {
  require_possible_frequency(call);
  return component_node(std::vector<OnePole>(call.width, OnePole(call.sound_start.rate, part)));
}

}  // namespace

std::vector<NodeType> filters() {
  using enum Argument::Kind;
  return {
      {.name = "lowpass",
       .arguments = {{"x", signal}, {"frequency", signal}},
       .description = "one-pole low-pass with a corner frequency in Hz",
       .make = one_pole<OnePole::Part::low>,
       .ends_with = EndsWith::first,
       .memory = state_memory},
      {.name = "highpass",
       .arguments = {{"x", signal}, {"frequency", signal}},
       .description = "x without its `lowpass`",
       .make = one_pole<OnePole::Part::high>,
       .ends_with = EndsWith::first,
       .memory = state_memory},
      {.name = "bandpass",
       .arguments = {{"x", signal}, {"frequency", signal}, {"quality", signal}},
       .description = "resonance at a frequency, gain 1 there; the width at -3 dB is frequency/quality",
       .make =
           [](const Call& call) {
             require_possible_frequency(call);
             call.require(
                 2, [](double quality) { return quality > 0.0; }, "the quality of a filter is above 0");
             return component_node(std::vector<BandPass>(call.width, BandPass(call.sound_start.rate)));
           },
       .ends_with = EndsWith::first,
       .memory = state_memory},
      {.name = "biquad",
       .arguments = {{"x", signal}, {"b0", signal}, {"b1", signal}, {"b2", signal}, {"a1", signal}, {"a2", signal}},
       .description = "y = b0 x + b1 x' + b2 x'' - a1 y' - a2 y'', where ' is the sample before",
       .make = [](const Call& call) { return component_node(std::vector<Biquad>(call.width)); },
       .ends_with = EndsWith::first,
       .memory = state_memory},
      {.name = "transmit",
       .arguments = {{"x", signal}, {"surface_density", signal}},
       .description = "x behind a limp wall of so many kg/m2, by the mass law; the wall reflects the rest",
       .make =
           [](const Call& call) {
             call.require(
                 1, [](double density) { return density >= 0.0; }, "the surface density of a wall is at least 0");
             return component_node(std::vector<Transmission>(call.width, Transmission(call.sound_start.rate)));
           },
       .ends_with = EndsWith::first,
       .memory = state_memory},
      {.name = "fir",
       .arguments = {{"x", signal}, {"taps", vector}},
       .description = "finite impulse response whose taps are a vector",
       .make =
           [](const Call& call) {
             return component_node(std::vector<FiniteResponse>(call.width, FiniteResponse(call.constants[1])));
           },
       .ends_with = EndsWith::first,
       .memory =
           [](const Call& call) { return static_cast<double>(call.constants[1].size()) / call.sound_start.rate; }},
  };
}

}  // namespace idiophone::timbre
