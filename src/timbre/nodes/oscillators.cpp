// Waves. The edges of sawtooth, triangle and square are smoothed by a cubic B-spline four samples wide (BLEP and BLAMP:
// Välimäki, Pekonen and Nam 2012, "Perceptually informed synthesis of bandlimited classical waveforms using integrated
// polynomial interpolation"): every alias below a quarter of the rate is 60 dB below the fundamental, if that is at
// most a twentieth of the rate.

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "idiophone/timbre/nodes/node_types.hpp"

namespace idiophone::timbre {

namespace {

constexpr double cycle = 2.0 * std::numbers::pi;
constexpr double reach = 2.0;  // samples on each side of an edge

double fraction(double x) {
  return x - std::floor(x);
}

/// A step smoothed by the spline minus the step, x samples after it.
double step_residual(double x) {
  const double before = -std::abs(x);
  if (before <= -reach) {
    return 0.0;
  }
  const double square = before * before;
  const double rise = before < -1.0 ? std::pow(reach + before, 4) / 24.0
                                    : 0.5 + before * (2.0 / 3.0 - square / 3.0 - square * before / 8.0);
  return x < 0.0 ? rise : -rise;
}

/// A ramp smoothed by the spline minus the ramp, x samples after its kink: the integral of step_residual().
double ramp_residual(double x) {
  const double before = -std::abs(x);
  if (before <= -reach) {
    return 0.0;
  }
  if (before < -1.0) {
    return std::pow(reach + before, 5) / 120.0;
  }
  const double square = before * before;
  return 7.0 / 30.0 + before * 0.5 + square / 3.0 - square * square / 12.0 - square * square * before / 40.0;
}

/// Sum of the residuals of all edges near by, which are where the phase is a whole number.
/// @param increment  of the phase in a sample, not zero
template <class Residual>
double near_edges(double phase, double increment, const Residual& residual) {
  const double width = reach * std::abs(increment);
  double sum = 0.0;
  double edge = std::ceil(phase - width);
  while (edge <= phase + width) {
    sum += residual((phase - edge) / increment);
    edge += 1.0;
  }
  return sum;
}

/// From -1 to 1 in each cycle. A negative increment gives the negative wave.
double sawtooth(double phase, double increment) {
  const double sign = std::copysign(1.0, increment);
  const double edges = increment == 0.0 ? 0.0 : near_edges(sign * phase, sign * increment, step_residual);
  return sign * (2.0 * fraction(sign * phase) - 1.0 - 2.0 * edges);
}

bool is_duty(double duty) {
  return duty >= 0.0 && duty <= 1.0;
}

double square(double phase, double increment, double duty) {
  if (!is_duty(duty)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return sawtooth(phase - duty, increment) - sawtooth(phase, increment) + 2.0 * duty - 1.0;
}

double triangle(double phase, double increment) {
  const double plain = 1.0 - 4.0 * std::abs(fraction(phase) - 0.5);
  if (increment == 0.0) {
    return plain;
  }
  const double edges = near_edges(phase, increment, ramp_residual) - near_edges(phase - 0.5, increment, ramp_residual);
  return plain + 8.0 * std::abs(increment) * edges;
}

/// Goes through the cycles of a frequency that may change. The phase is in cycles.
class Phase {
 public:
  explicit Phase(int rate) : rate_(rate) {}

  /// The phase of this sample. The next one is frequency/rate later.
  double next(double frequency) {
    const double now = phase_;
    phase_ = fraction(phase_ + frequency / rate_);
    return now;
  }
  [[nodiscard]] double increment(double frequency) const { return frequency / rate_; }

 private:
  double rate_;
  double phase_ = 0.0;
};

/// A wave of the kinds above. Frequencies of half the rate and more are silent: they would be aliases.
template <class Wave>
struct Oscillator {
  using Arguments = std::array<double, 2>;  // frequency, shape
  Phase phase;
  Wave wave;

  double step(const Moment& /*moment*/, const Arguments& arguments) {
    const double increment = phase.increment(arguments[0]);
    const double now = phase.next(arguments[0]);
    return std::abs(increment) < 0.5 ? wave(now, increment, arguments[1]) : 0.0 * increment;
  }
};

/// A sine of constant frequency: a number that turns in the complex plane.
struct SteadySine {
  using Arguments = std::array<double, 0>;
  double real, imaginary, turn_real, turn_imaginary;

  double step(const Moment& /*moment*/, const Arguments& /*arguments*/) {
    const double sample = imaginary;
    const double next = real * turn_real - imaginary * turn_imaginary;
    imaginary = real * turn_imaginary + imaginary * turn_real;
    real = next;
    return sample;
  }
};

SteadySine steady_sine(double frequency, double phase, int rate) {
  if (2.0 * std::abs(frequency) >= rate) {
    return {0.0, 0.0, 1.0, 0.0};
  }
  const double turn = cycle * frequency / rate;
  return {std::cos(cycle * phase), std::sin(cycle * phase), std::cos(turn), std::sin(turn)};
}

double sine_wave(double phase, double /*increment*/, double offset) {
  return std::sin(cycle * (phase + offset));
}
double sawtooth_wave(double phase, double increment, double offset) {
  return sawtooth(phase + offset, increment);
}
double triangle_wave(double phase, double increment, double offset) {
  return triangle(phase + offset, increment);
}

using Wave = double (*)(double, double, double);

std::unique_ptr<Node> oscillator(const Call& call, Wave wave) {
  return component_node(std::vector<Oscillator<Wave>>(call.width, {Phase(call.sound_start.rate), wave}));
}

std::unique_ptr<Node> sine(const Call& call) {
  if (call.constants[0].empty() || call.constants[1].empty()) {
    return oscillator(call, sine_wave);
  }
  return component_node(call.states([&](std::size_t component) {
    return steady_sine(call.constant(0, component), call.constant(1, component), call.sound_start.rate);
  }));
}

}  // namespace

std::vector<NodeType> oscillators() {
  constexpr auto signal = Argument::Kind::signal;
  const std::vector<Argument> frequency_and_phase = {{"frequency", signal}, {"phase", signal, 0.0}};
  const auto wave = [&](const char* name, const char* description, Wave function) {
    return NodeType{.name = name,
                    .arguments = frequency_and_phase,
                    .description = description,
                    .make = [function](const Call& call) { return oscillator(call, function); }};
  };
  return {
      {.name = "sine",
       .arguments = frequency_and_phase,
       .description = "sine wave of a frequency in Hz; the phase is in cycles",
       .make = sine},
      wave("sawtooth", "band-limited sawtooth, rising from -1 to 1 in each cycle", sawtooth_wave),
      wave("triangle", "band-limited triangle, from -1 to 1 and back", triangle_wave),
      {.name = "square",
       .arguments = {{"frequency", signal}, {"duty", signal, 0.5}},
       .description = "band-limited square wave, 1 for the part `duty` of each cycle, then -1",
       .make =
           [](const Call& call) {
             call.require(1, is_duty, "a duty is a number from 0 to 1");
             return oscillator(call, square);
           }},
  };
}

}  // namespace idiophone::timbre
