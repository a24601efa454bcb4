// Nodes of recorded sounds: played once or in a loop, and in grains.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/timbre/nodes/node_types.hpp"
#include "idiophone/timbre/nodes/random.hpp"
#include "interpolation.hpp"
#include "named_recording.hpp"

namespace idiophone::timbre {

namespace {

constexpr double highest_pitch = 64.0;

bool is_pitch(double pitch) {
  return pitch >= 0.0 && pitch <= highest_pitch;
}

using Samples = std::shared_ptr<const std::vector<double>>;

/// A recording, of which samples before its beginning and after its end are silent, or those of its repetition.
class Recording {
 public:
  Recording(Samples samples, std::size_t begin, bool repeats)
      : samples_(std::move(samples)), begin_(begin), size_(samples_->size() - begin), repeats_(repeats) {}

  /// @param position  since its beginning, samples
  /// @param pitch     that it is played at
  [[nodiscard]] double at(double position, double pitch) const {
    const auto read = [this](std::int64_t index) { return sample(index); };
    return pitch == 1.0 && position == std::floor(position) ? sample(static_cast<std::int64_t>(position))
                                                            : interpolated(read, position, 1.0 / std::max(1.0, pitch));
  }
  /// In samples.
  [[nodiscard]] double length() const { return static_cast<double>(size_); }
  [[nodiscard]] bool repeats() const { return repeats_; }

 private:
  [[nodiscard]] double sample(std::int64_t index) const {
    const auto size = static_cast<std::int64_t>(size_);
    if (index >= 0 && index < size) {
      return (*samples_)[begin_ + static_cast<std::size_t>(index)];
    }
    return repeats_ ? (*samples_)[begin_ + static_cast<std::size_t>((index % size + size) % size)] : 0.0;
  }

  Samples samples_;
  std::size_t begin_, size_;
  bool repeats_;
};

/// A recording at a speed that may change.
class Playback {
 public:
  using Arguments = std::array<double, 1>;  // pitch

  explicit Playback(Recording recording) : recording_(std::move(recording)) {}

  double step(const Moment& /*moment*/, const Arguments& arguments) {
    const double pitch = arguments[0];
    if (!is_pitch(pitch)) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    if (position_ >= recording_.length()) {
      if (!recording_.repeats()) {
        return 0.0;
      }
      position_ = std::fmod(position_, recording_.length());
    }
    return recording_.at(std::exchange(position_, position_ + pitch), pitch);
  }

 private:
  Recording recording_;
  double position_ = 0.0;  // samples
};

/// Where a recording begins to be played, in samples.
std::size_t beginning_of(const Call& call, const Samples& samples) {
  const double start = call.number(2), length = static_cast<double>(samples->size()) / call.sound_start.rate;
  if (!(start >= 0.0 && start < length)) {
    throw deck::DeckError(call.where, fmt::format("the start is from 0 to the end of {}, {:.4g} s, not {}",
                                                  call.texts[0], length, start));
  }
  return std::min(static_cast<std::size_t>(std::llround(start * call.sound_start.rate)), samples->size() - 1);
}

std::unique_ptr<Node> sample(const Call& call) {
  call.require(1, is_pitch, fmt::format("the pitch of a sample is from 0 to {}", highest_pitch));
  call.require(
      3, [](double loop) { return loop == 0.0 || loop == 1.0; }, "loop is 0 or 1");
  const Samples samples = recording_of(call, 0);
  return component_node(
      std::vector<Playback>{Playback(Recording(samples, beginning_of(call, samples), call.number(3) == 1.0))});
}

/// Until its end at a constant pitch.
double lifetime_of_sample(const Call& call) {
  const bool is_known = !call.constants[1].empty() && call.number(1) > 0.0 && call.number(3) == 0.0;
  return is_known ? static_cast<double>(recording_of(call, 0)->size()) / call.sound_start.rate / call.number(1)
                  : std::numeric_limits<double>::infinity();
}

/// Short pieces of a recording under Hann windows that overlap (Roads 1988, "Introduction to granular synthesis").
class Grains {
 public:
  using Arguments = std::array<double, 2>;  // position, pitch

  struct Options {
    double density;  ///< grains per second
    double length;   ///< of a grain, s
    double spread;   ///< of their positions, s
    Random random;
    double rate;  ///< audio samples per second
  };

  Grains(Samples samples, const Options& options)
      : recording_(std::move(samples), 0, true),
        options_(options),
        length_(std::llround(options.length * options.rate)) {}

  double step(const Moment& moment, const Arguments& arguments) {
    const auto [position, pitch] = arguments;
    if (!is_pitch(pitch) || !std::isfinite(position)) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    begin(moment.sample, position, pitch);
    std::erase_if(playing_, [&](const Grain& grain) { return moment.sample - grain.start >= length_; });
    double sum = 0.0;
    for (const Grain& grain : playing_) {
      const auto age = static_cast<double>(moment.sample - grain.start);
      const double window = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * age / static_cast<double>(length_));
      sum += window * recording_.at(grain.position + age * grain.pitch, grain.pitch);
    }
    return sum / std::max(1.0, 0.5 * options_.density * options_.length);
  }

 private:
  struct Grain {
    std::int64_t start;  ///< audio sample
    double position;     ///< of its beginning, samples
    double pitch;
  };

  /// Begins the grain that is due, if one is.
  void begin(std::int64_t sample, double position, double pitch) {
    if (static_cast<double>(sample) < std::round(static_cast<double>(count_) * options_.rate / options_.density)) {
      return;
    }
    const double shift = options_.spread * (2.0 * options_.random.uniform(count_++) - 1.0);
    const double begins = std::round((position + shift) * options_.rate);
    const double wrapped = begins - recording_.length() * std::floor(begins / recording_.length());
    playing_.push_back({sample, wrapped, pitch});
  }

  Recording recording_;
  Options options_;
  std::int64_t length_;  // audio samples
  std::vector<Grain> playing_;
  std::int64_t count_ = 0;  // of all grains so far
};

std::unique_ptr<Node> grains(const Call& call) {
  call.require(2, is_pitch, fmt::format("the pitch of grains is from 0 to {}", highest_pitch));
  const auto within = [](double lowest, double highest) {
    return [lowest, highest](double number) { return number >= lowest && number <= highest; };
  };
  call.require(3, within(0.1, 1000.0), "the density is from 0.1 to 1000 grains in a second");
  call.require(4, within(0.001, 10.0), "the length of a grain is from 0.001 to 10 s");
  call.require(5, within(0.0, 3600.0), "the spread is from 0 to 3600 s");
  const std::uint64_t seed = joined_seed(call.sound_start.start_seed, seed_of(call.number(6)));
  return component_node(
      std::vector<Grains>{Grains(recording_of(call, 0), {.density = call.number(3),
                                                         .length = call.number(4),
                                                         .spread = call.number(5),
                                                         .random = Random(seed),
                                                         .rate = static_cast<double>(call.sound_start.rate)})});
}

}  // namespace

std::vector<NodeType> recordings() {
  using enum Argument::Kind;
  const auto one = [](const Call& /*call*/) { return std::size_t{1}; };
  return {
      {.name = "sample",
       .arguments = {{"file", text}, {"pitch", signal, 1.0}, {"start", number, 0.0}, {"loop", number, 0.0}},
       .description =
           "a recorded sound from a time (s) on; pitch 2 is an octave higher and twice as fast; with loop 1, "
           "what is after the start repeats",
       .make = sample,
       .width = one,
       .lifetime = lifetime_of_sample},
      {.name = "grains",
       .arguments = {{"file", text},
                     {"position", signal},
                     {"pitch", signal, 1.0},
                     {"density", number, 50.0},
                     {"length", number, 0.08},
                     {"spread", number, 0.0},
                     {"seed", number, 1.0}},
       .description =
           "pieces of a recorded sound, `density` in a second and `length` s long, each from the position (s) "
           "when it begins, give or take the spread (s); after its end, the recording repeats",
       .make = grains,
       .width = one},
  };
}

}  // namespace idiophone::timbre
