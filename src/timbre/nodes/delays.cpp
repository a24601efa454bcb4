// Nodes with long memories: delay, reverberation and convolution.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/spectra/convolver.hpp"
#include "idiophone/timbre/nodes/node_types.hpp"
#include "interpolation.hpp"
#include "named_recording.hpp"
#include "reverberator.hpp"

namespace idiophone::timbre {

namespace {

constexpr double longest_delay = 60.0;         // s
constexpr double longest_reverberation = 100;  // s

/// A delay that may change. Delays that are impossible give "not a number".
class Delay {
 public:
  using Arguments = std::array<double, 2>;  // signal, delay

  Delay(double longest, int rate)
      : rate_(rate),
        longest_(longest),
        past_(static_cast<std::size_t>(longest * rate) + std::size_t{2} * interpolation_reach) {}

  double step(const Moment& moment, const Arguments& arguments) {
    const auto [input, delay] = arguments;
    const auto size = static_cast<std::int64_t>(past_.size());
    past_[moment.sample % size] = input;
    const double samples = delay * rate_;
    const auto at = [&](std::int64_t sample) { return sample < 0 ? 0.0 : past_[sample % size]; };
    if (delay >= 0.0 && delay <= longest_ && samples == std::round(samples)) {
      return at(moment.sample - std::llround(samples));
    }
    if (!(delay <= longest_ && samples >= interpolation_reach)) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    return interpolated(at, static_cast<double>(moment.sample) - samples);
  }

 private:
  double rate_, longest_;
  std::vector<double> past_;  // a ring
};

std::unique_ptr<Node> delay(const Call& call) {
  const double longest = call.number(2);
  if (!(longest > 0.0 && longest <= longest_delay)) {
    throw deck::DeckError(call.where, fmt::format("the longest delay must be above 0 and at most {} s", longest_delay));
  }
  const std::vector<double>& delays = call.constants[1];
  const double shortest = static_cast<double>(interpolation_reach) / call.sound_start.rate;
  for (const double time : delays) {
    const double samples = time * call.sound_start.rate;
    if (!(time >= 0.0 && time <= longest) || (time < shortest && samples != std::round(samples))) {
      throw deck::DeckError(call.where,
                            fmt::format("a delay of {} s is not possible: it must be 0, or from {:.2g} s to "
                                        "the longest delay, {} s",
                                        time, shortest, longest));
    }
  }
  return component_node(std::vector<Delay>(call.width, Delay(longest, call.sound_start.rate)));
}

struct Reverberation {
  using Arguments = std::array<double, 1>;
  Reverberator room;
  double step(const Moment& /*moment*/, const Arguments& arguments) { return room.step(arguments[0]); }
};

std::unique_ptr<Node> reverberate(const Call& call) {
  const double decay = call.number(1);
  if (!(decay > 0.0 && decay <= longest_reverberation)) {
    throw deck::DeckError(call.where,
                          fmt::format("the decay time must be above 0 and at most {} s", longest_reverberation));
  }
  return component_node(std::vector<Reverberation>(call.width, {Reverberator(decay, call.sound_start.rate)}));
}

struct Convolution {
  using Arguments = std::array<double, 1>;
  std::shared_ptr<spectra::Convolver> convolver;
  double step(const Moment& /*moment*/, const Arguments& arguments) { return convolver->step(arguments[0]); }
};

std::unique_ptr<Node> convolve(const Call& call) {
  const auto taps = recording_of(call, 1);
  return component_node(
      call.states([&](std::size_t /*component*/) { return Convolution{std::make_shared<spectra::Convolver>(*taps)}; }));
}

}  // namespace

std::vector<NodeType> delays() {
  using enum Argument::Kind;
  return {
      {.name = "delay",
       .arguments = {{"x", signal}, {"time", signal}, {"longest", number, 1.0}},
       .description = "x as it was a time (s) before; the time may change, which shifts the pitch",
       .make = delay,
       .ends_with = EndsWith::first,
       .memory = [](const Call& call) { return call.number(2); }},
      {.name = "reverberate",
       .arguments = {{"x", signal}, {"decay", number}},
       .description = "the late sound of a room, without x itself; it falls by 60 dB in the decay time (s)",
       .make = reverberate,
       .ends_with = EndsWith::first,
       .memory = [](const Call& /*call*/) { return 0.1; }},  // longer than its lines
      {.name = "convolve",
       .arguments = {{"x", signal}, {"file", text}},
       .description = "convolution with a sound file, by FFTW",
       .make = convolve,
       .ends_with = EndsWith::first,
       .memory = [](const Call& /*call*/) { return 10.0; }},  // longer than a pause in a response
  };
}

}  // namespace idiophone::timbre
