// Nodes of the paper's own: vectors of modes and their sum, decay, keyframes, timer.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/timbre/nodes/curve.hpp"
#include "idiophone/timbre/nodes/curve_node.hpp"
#include "idiophone/timbre/nodes/node_types.hpp"
#include "idiophone/timbre/nodes/random.hpp"

namespace idiophone::timbre {

namespace {

/// A vector that does not change.
class FixedVector : public Node {
 public:
  explicit FixedVector(std::vector<double> values) : values_(std::move(values)) {}

  void render(const Block& block, std::span<const Input> /*inputs*/, std::span<double> output) override {
    for (std::size_t i = 0; i < block.count; ++i) {
      std::ranges::copy(values_, output.begin() + static_cast<std::ptrdiff_t>(i * block.width));
    }
  }

 private:
  std::vector<double> values_;
};

std::unique_ptr<Node> vector_of(const Call& call) {
  std::vector<double> values;
  for (const std::vector<double>& value : call.constants) {
    values.push_back(value.front());
  }
  return std::make_unique<FixedVector>(std::move(values));
}

constexpr double largest_vector = 100000.0;

std::unique_ptr<Node> random_vector(const Call& call) {
  const double count = call.number(0);
  const double lowest = call.number(1);
  const double highest = call.number(2);
  if (!(count >= 1.0 && count <= largest_vector && count == std::floor(count))) {
    throw deck::DeckError(call.where, fmt::format("the length of a vector is a whole number from 1 to {}, not {}",
                                                  largest_vector, count));
  }
  const Random random(joined_seed(call.sound_start.body_seed, seed_of(call.number(3))));
  std::vector<double> values(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = lowest + (highest - lowest) * random.uniform(static_cast<std::int64_t>(i));
  }
  return std::make_unique<FixedVector>(std::move(values));
}

std::size_t length_of_random_vector(const Call& call) {
  const double count = call.number(0);
  return count >= 1.0 && count <= largest_vector ? static_cast<std::size_t>(count) : 1;
}

/// Sum of x times weight over the components.
class Combination : public Node {
 public:
  explicit Combination(std::size_t width) : width_(width) {}

  void render(const Block& block, std::span<const Input> inputs, std::span<double> output) override {
    for (std::size_t i = 0; i < block.count; ++i) {
      double sum = 0.0;
      for (std::size_t c = 0; c < width_; ++c) {
        sum += inputs[0].at(i, c) * inputs[1].at(i, c);
      }
      output[i] = sum;
    }
  }

 private:
  std::size_t width_;
};

/// exp(-2 pi ratio frequency t), by one factor for each sample.
struct Decay {
  using Arguments = std::array<double, 2>;  // frequency, ratio
  double rate;
  double frequency = 0.0, ratio = 0.0, factor = 1.0;
  double value = 1.0;

  double step(const Moment& /*moment*/, const Arguments& arguments) {
    if (arguments[0] != frequency || arguments[1] != ratio) {
      frequency = arguments[0];
      ratio = arguments[1];
      factor = std::exp(-2.0 * std::numbers::pi * frequency * ratio / rate);
    }
    const double now = value;
    value = without_denormals(value * factor);
    return now;
  }
};

std::unique_ptr<Node> damp(const Call& call) {
  return component_node(std::vector<Decay>(call.width, Decay{.rate = static_cast<double>(call.sound_start.rate)}));
}

/// Of the component that decays most slowly.
double lifetime_of_decay(const Call& call) {
  double slowest = std::numeric_limits<double>::infinity();
  for (std::size_t component = 0; component < call.width; ++component) {
    const bool is_known = !call.constants[0].empty() && !call.constants[1].empty();
    slowest = std::min(slowest, is_known ? call.constant(0, component) * call.constant(1, component) : 0.0);
  }
  return slowest > 0.0 ? -std::log(inaudible_share) / (2.0 * std::numbers::pi * slowest)
                       : std::numeric_limits<double>::infinity();
}

double lifetime_of_keyframes(const Call& call) {
  const std::size_t last = call.constants.size() - 1;
  return call.number(last) == 0.0 ? call.number(last - 1) : std::numeric_limits<double>::infinity();
}

double lifetime_of_timer(const Call& call) {
  const std::vector<double>& stops = call.constants[1];
  return stops.empty() ? std::numeric_limits<double>::infinity() : *std::ranges::max_element(stops);
}

std::unique_ptr<Node> keyframe(const Call& call) {
  Interpolation interpolation = Interpolation::linear;
  if (!find_interpolation(call.texts[0], interpolation)) {
    throw deck::DeckError(call.where, "the interpolation is linear, cubic or hold, not '" + call.texts[0] + "'");
  }
  std::vector<double> times, values;
  for (std::size_t a = 1; a < call.constants.size(); ++a) {
    (a % 2 == 1 ? times : values).push_back(call.number(a));
  }
  if (times.size() != values.size()) {
    throw deck::DeckError(call.where, "a value is missing after the last time");
  }
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (!(times[i] > times[i - 1])) {
      throw deck::DeckError(call.where, fmt::format("times must ascend; {} comes after {}", times[i], times[i - 1]));
    }
  }
  return std::make_unique<CurveNode>(std::make_shared<const Curve>(times, values, interpolation), 0.0,
                                     call.sound_start.rate);
}

struct Timer {
  using Arguments = std::array<double, 3>;  // start, stop, x
  double rate;

  [[nodiscard]] double step(const Moment& moment, const Arguments& arguments) const {
    const double time = static_cast<double>(moment.sample) / rate;
    return time >= arguments[0] && time < arguments[1] ? arguments[2] : 0.0;
  }
};

struct Clock {
  using Arguments = std::array<double, 0>;
  double rate;

  [[nodiscard]] double step(const Moment& moment, const Arguments& /*arguments*/) const {
    return static_cast<double>(moment.sample) / rate;
  }
};

}  // namespace

bool find_interpolation(const std::string& word, Interpolation& interpolation) {
  for (const auto& [name, meaning] :
       {std::pair{"linear", Interpolation::linear}, std::pair{"cubic", Interpolation::cubic},
        std::pair{"hold", Interpolation::hold}}) {
    if (word == name) {
      interpolation = meaning;
      return true;
    }
  }
  return false;
}

std::vector<NodeType> vectors() {
  using enum Argument::Kind;
  const auto one = [](const Call& /*call*/) { return std::size_t{1}; };
  const auto rate_of = [](const Call& call) { return static_cast<double>(call.sound_start.rate); };
  return {
      {.name = "vector",
       .arguments = {{"x", number}},
       .description = "a vector of numbers",
       .make = vector_of,
       .repeats = true,
       .is_timeless = true,
       .width = [](const Call& call) { return call.constants.size(); }},
      {.name = "rvector",
       .arguments = {{"length", number}, {"lowest", number}, {"highest", number}, {"seed", number, 1.0}},
       .description = "a vector of random numbers, the same each time that the sound starts",
       .make = random_vector,
       .is_timeless = true,
       .width = length_of_random_vector},
      {.name = "combine",
       .arguments = {{"x", signal}, {"weights", signal, 1.0}},
       .description = "sum of the components of x, times weights",
       .make = [](const Call& call) { return std::make_unique<Combination>(call.width); },
       .is_timeless = true,
       .width = one,
       .ends_with = EndsWith::any},
      {.name = "damp",
       .arguments = {{"frequency", signal}, {"ratio", signal}},
       .description = "exp(-2 pi ratio frequency t): the decay of a mode with this damping ratio",
       .make = damp,
       .lifetime = lifetime_of_decay},
      {.name = "keyframe",
       .arguments = {{"interpolation", word}, {"time", number}, {"value", number}},
       .description = "values at times (s) since the sound began, and linear, cubic or hold between them",
       .make = keyframe,
       .repeats = true,
       .lifetime = lifetime_of_keyframes},
      {.name = "timer",
       .arguments = {{"start", signal}, {"stop", signal}, {"x", signal}},
       .description = "x from a time (s) to another, otherwise 0",
       .make =
           [rate_of](const Call& call) { return component_node(std::vector<Timer>(call.width, Timer{rate_of(call)})); },
       .ends_with = EndsWith::last,
       .lifetime = lifetime_of_timer},
      {.name = "time",
       .arguments = {},
       .description = "seconds since the sound began",
       .make = [rate_of](const Call& call) { return component_node(std::vector<Clock>{Clock{rate_of(call)}}); }},
  };
}

}  // namespace idiophone::timbre
