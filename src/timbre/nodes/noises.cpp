// Noise. The argument `seed` makes noises differ: nodes with equal arguments are one node.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/timbre/nodes/node_types.hpp"
#include "idiophone/timbre/nodes/random.hpp"

namespace idiophone::timbre {

namespace {

using std::numbers::pi;

/// Another one for each kind of noise, seed and component.
Random random_of(const Call& call, std::uint64_t kind, std::size_t seed_argument, std::size_t component) {
  const std::uint64_t seed = seed_of(call.number(seed_argument));
  return Random(joined_seed(joined_seed(call.sound_start.start_seed + kind, seed), component));
}

struct White {
  using Arguments = std::array<double, 0>;
  Random random;

  [[nodiscard]] double step(const Moment& moment, const Arguments& /*arguments*/) const {
    return 2.0 * random.uniform(moment.sample) - 1.0;
  }
};

/// White noise through poles and zeros in turn, two and two for each octave pair, so that the power falls as
/// 1/frequency from `lowest` up.
class Pink {
 public:
  using Arguments = std::array<double, 0>;

  Pink(Random random, int rate) : random_(random) {
    constexpr double lowest = 4.0, ratio = 4.0;  // Hz; from one pole to the next, the zero in the middle
    for (double pole = lowest; pole < 0.25 * rate && count_ < sections_.size(); pole *= ratio) {
      sections_[count_++] = {std::exp(-2.0 * pi * pole / rate), std::exp(-4.0 * pi * pole / rate)};
    }
    scale_ = 1.0 / std::sqrt(power());
  }

  double step(const Moment& moment, const Arguments& /*arguments*/) {
    double sample = scale_ * random_.normal(moment.sample);
    for (std::size_t s = 0; s < count_; ++s) {
      Section& section = sections_[s];
      const double input = sample;
      sample = without_denormals(input - section.zero * section.input + section.pole * section.output);
      section.input = input;
      section.output = sample;
    }
    return sample;
  }

 private:
  struct Section {
    double pole = 0.0, zero = 0.0;
    double input = 0.0, output = 0.0;  // of the sample before
  };

  /// Of the output, if the scale is 1: the mean of the squared response over all frequencies.
  [[nodiscard]] double power() const {
    constexpr int steps = 4000;
    constexpr double lowest = 1e-7;  // rad per sample
    const double factor = std::pow(pi / lowest, 1.0 / steps);
    double sum = 0.0;
    double frequency = lowest;
    for (int i = 0; i < steps; ++i, frequency *= factor) {
      const double middle = frequency * std::sqrt(factor);
      double response = 1.0;
      for (std::size_t s = 0; s < count_; ++s) {
        const auto squared = [&](double place) { return 1.0 + place * place - 2.0 * place * std::cos(middle); };
        response *= squared(sections_[s].zero) / squared(sections_[s].pole);
      }
      sum += response * frequency * (factor - 1.0);
    }
    return sum / pi;
  }

  Random random_;
  std::array<Section, 12> sections_;
  std::size_t count_ = 0;
  double scale_ = 1.0;
};

/// Gradient noise (Perlin 1985) in one dimension: zero at the lattice's points, with a random slope there.
class Perlin {
 public:
  using Arguments = std::array<double, 1>;  // frequency

  Perlin(Random random, int rate) : random_(random), rate_(rate) {}

  double step(const Moment& /*moment*/, const Arguments& arguments) {
    const double x = rest_;
    const double fade = x * x * x * (x * (6.0 * x - 15.0) + 10.0);
    const double left = slope(point_) * x;
    const double right = slope(point_ + 1) * (x - 1.0);
    advance(arguments[0] / rate_);
    return 2.0 * (left + fade * (right - left));
  }

 private:
  [[nodiscard]] double slope(std::int64_t point) const { return 2.0 * random_.uniform(point) - 1.0; }

  void advance(double distance) {
    const double place = rest_ + distance;
    const double whole = std::floor(place);
    if (std::abs(whole) > 0x1p40) {  // or not a number
      rest_ = std::nan("");
      return;
    }
    rest_ = place - whole;
    point_ += static_cast<std::int64_t>(whole);
  }

  Random random_;
  double rate_;
  std::int64_t point_ = 0;
  double rest_ = 0.0;
};

/// A second-order Gauss-Markov process: an oscillator with damping that noise drives. It starts in its steady state.
class Markov {
 public:
  using Arguments = std::array<double, 0>;

  /// @param damping  ratio to the critical damping, 0 to 1
  Markov(Random random, double frequency, double damping, int rate) : random_(random) {
    const double decay = 2.0 * pi * frequency * damping / rate;
    const double turn = 2.0 * pi * frequency * std::sqrt(1.0 - damping * damping) / rate;
    const double square = std::exp(-2.0 * decay);
    first_ = 2.0 * std::exp(-decay) * std::cos(turn);
    second_ = -square;
    const double loss = -std::expm1(-2.0 * decay);  // 1 - square
    const double sine = std::sin(turn);
    noise_ = std::sqrt(loss * (loss * loss + 4.0 * square * sine * sine) / (1.0 + square));
    const double correlation = first_ / (1.0 + square);
    last_ = random_.normal(0);
    before_ = correlation * last_ + std::sqrt(1.0 - correlation * correlation) * random_.normal(1);
  }

  double step(const Moment& moment, const Arguments& /*arguments*/) {
    const double next = first_ * last_ + second_ * before_ + noise_ * random_.normal(moment.sample + 2);
    before_ = last_;
    last_ = next;
    return next;
  }

 private:
  Random random_;
  double first_, second_, noise_;
  double last_, before_;
};

std::unique_ptr<Node> markov(const Call& call) {
  const double frequency = call.number(0);
  const double damping = call.number(1);
  const int rate = call.sound_start.rate;
  if (!(frequency > 0.0 && 2.0 * frequency < rate && damping > 0.0 && damping < 1.0)) {
    throw deck::DeckError(call.where,
                          "markov needs a frequency between 0 and half the rate, and a damping between 0 and 1");
  }
  return component_node(std::vector<Markov>{{random_of(call, 4, 2, 0), frequency, damping, rate}});
}

}  // namespace

std::vector<NodeType> noises() {
  using enum Argument::Kind;
  const Argument seed{"seed", number, 1.0};
  return {
      {.name = "white",
       .arguments = {seed},
       .description = "white noise, evenly distributed from -1 to 1",
       .make = [](const Call& call) { return component_node(std::vector<White>{{random_of(call, 1, 0, 0)}}); }},
      {.name = "pink",
       .arguments = {seed},
       .description = "1/f noise: power as 1/frequency from 4 Hz up; root mean square 1",
       .make =
           [](const Call& call) {
             return component_node(std::vector<Pink>{{random_of(call, 2, 0, 0), call.sound_start.rate}});
           }},
      {.name = "perlin",
       .arguments = {{"frequency", signal}, seed},
       .description = "Perlin noise, smooth, from -1 to 1, with `frequency` random slopes in a second",
       .make =
           [](const Call& call) {
             return component_node(call.states([&](std::size_t component) {
               return Perlin(random_of(call, 3, 1, component), call.sound_start.rate);
             }));
           }},
      {.name = "markov",
       .arguments = {{"frequency", number}, {"damping", number, 0.5}, seed},
       .description = "second-order Markov process, variance 1: an oscillator with a damping ratio that noise drives",
       .make = markov},
  };
}

}  // namespace idiophone::timbre
