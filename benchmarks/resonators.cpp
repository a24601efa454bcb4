// Modes that one core computes in real time at 48 kHz, in blocks of 128 frames as an audio device asks for them:
// ringing, and while a force acts; one to four outputs.

#include <benchmark/benchmark.h>

#include <cmath>

#include "idiophone/instruments/resonators/resonator_bank.hpp"

namespace {

namespace resonators = idiophone::resonators;
using resonators::ResonatorBank;

constexpr int rate = 48000;
constexpr std::size_t frames = 128;

class Body {
 public:
  Body(std::size_t modes, std::size_t outputs) : bank_(turns(modes)), outputs_(outputs) {
    gains_.resize(outputs * bank_.groups());
    input_.resize(bank_.groups());
    for (resonators::ModeGroup& gain : gains_) {
      gain.real.fill(resonators::ModePack{} + 0.5);
      gain.imaginary.fill(resonators::ModePack{} + 0.25);
    }
    for (resonators::ModeGroup& gain : input_) {
      gain.real.fill(resonators::ModePack{} + 1.0);
    }
    block(true);
  }

  void block(bool driven) {
    const resonators::Drive drive{.force = force_, .by_mean = input_, .by_slope = input_};
    for (std::size_t first = 0; first < frames; first += ResonatorBank::most_samples) {
      bank_.advance({&drive, driven ? 1UL : 0UL}, gains_, outputs_,
                    {sound_.data(), outputs_ * ResonatorBank::most_samples});
      bank_.silence();
      benchmark::DoNotOptimize(sound_.data());
    }
  }

 private:
  static std::vector<resonators::Complex> turns(std::size_t modes) {
    std::vector<resonators::Complex> all;
    for (std::size_t mode = 0; mode < modes; ++mode) {
      const double frequency = 20.0 * std::pow(1000.0, static_cast<double>(mode) / static_cast<double>(modes));
      all.push_back(resonators::Resonator({frequency, 1e-3}, rate).turn);
    }
    return all;
  }

  ResonatorBank bank_;
  std::size_t outputs_;
  std::vector<resonators::ModeGroup> gains_, input_;
  std::vector<double> sound_ = std::vector<double>(ResonatorBank::most_outputs * ResonatorBank::most_samples);
  std::vector<resonators::ForcePiece> force_{ResonatorBank::most_samples, {.mean = 1.0, .slope = 0.1}};
};

void run(benchmark::State& state, bool driven) {
  const auto modes = static_cast<std::size_t>(state.range(0));
  Body body(modes, static_cast<std::size_t>(state.range(1)));
  while (state.KeepRunning()) {
    body.block(driven);
  }
  // A rate per second of modes times audio samples, as modes at this rate of samples.
  state.counters["modes_in_real_time"] =
      benchmark::Counter(static_cast<double>(modes * frames) / rate, benchmark::Counter::kIsIterationInvariantRate);
}

void ring(benchmark::State& state) {
  run(state, false);
}

void drive(benchmark::State& state) {
  run(state, true);
}

}  // namespace

BENCHMARK(ring)->Args({1024, 1})->Args({1024, 2})->Args({1024, 4})->Args({65536, 1})->Args({65536, 2});
BENCHMARK(drive)->Args({1024, 1})->Args({65536, 1});
