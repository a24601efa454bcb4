#include "idiophone/study/fitting/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "idiophone/foundation/deck/section.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/foundation/spectra/sound_file.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "idiophone/study/partials/partials.hpp"

namespace idiophone::fitting {

namespace {

using deck::Mistakes;
using deck::Node;
using deck::Range;
using deck::Section;

constexpr Range hertz{.at_least = 1e-3, .at_most = 1e9, .unit = "Hz"};
constexpr Range uncertainties{.at_least = 0.01, .at_most = 1200.0, .unit = "cents"};
constexpr Range seconds{.at_least = 1e-9, .at_most = 1e6, .unit = "s"};
constexpr Range kilograms{.at_least = 1e-12, .at_most = 1e9, .unit = "kg"};

/// The uncertainty of lines that give none, cents.
struct UsualUncertainty {
  double cents;
};

}  // namespace

/// A frequency, or {frequency, uncertainty, decay_time}.
static bool read(const Node& node, Mistakes& mistakes, Line& line, const UsualUncertainty& usual) {
  line.uncertainty = usual.cents;
  if (node.kind != Node::Kind::map) {
    return read(node, mistakes, line.frequency, hertz);
  }
  Section section(node, mistakes);
  section.required("frequency", line.frequency, hertz);
  section.optional("uncertainty", line.uncertainty, uncertainties);
  section.optional("decay_time", line.decay_time, seconds);
  return section.finish();
}

namespace {

Measurements read_yaml(const std::filesystem::path& file) {
  Measurements measured;
  Mistakes mistakes;
  const Node tree = deck::read_tree(deck::read_text(file), file.string(), {}, mistakes);
  Section section(tree, mistakes);
  UsualUncertainty usual{default_uncertainty};
  section.optional("uncertainty", usual.cents, uncertainties);
  section.optional("mass", measured.mass, kilograms);
  if (section.required("lines", measured.lines, usual) && measured.lines.empty()) {
    mistakes.add(*section.find("lines"), "is empty; it needs at least one frequency");
  }
  section.finish();
  mistakes.raise();
  return measured;
}

/// Seconds from the beginning of a recording to where its partials are free: shortly after the loudest sample.
double start_of(const std::vector<double>& samples, double rate) {
  const auto loudest = std::ranges::max_element(samples, {}, [](double sample) { return std::abs(sample); });
  const double blow = static_cast<double>(loudest - samples.begin()) / rate;
  const double rest = static_cast<double>(samples.size()) / rate - blow;
  return blow + std::min(0.02, rest / 10);
}

double energy_of(const std::vector<double>& samples) {
  return std::inner_product(samples.begin(), samples.end(), samples.begin(), 0.0);
}

Measurements read_recording(const std::filesystem::path& file) {
  const spectra::SoundFile sound = spectra::read_sound_file(file);
  const std::vector<double>& samples = *std::ranges::max_element(sound.channels, {}, energy_of);
  Measurements measured;
  try {
    partials::PartialOptions options{.dynamic_range = 60.0};
    options.start = start_of(samples, sound.rate);
    const partials::Partials partials = partials::find_partials(samples, sound.rate, options);
    if (!partials.complete) {
      throw std::invalid_argument(
          "after the blow, there is more than a sum of damped sines, for example a click or another blow; cut the "
          "recording before it");
    }
    for (const partials::Partial& partial : partials.found) {
      const double deviation = partials::cents(partial.frequency + partial.frequency_deviation, partial.frequency);
      measured.lines.push_back({.frequency = partial.frequency,
                                .uncertainty = std::max(default_uncertainty, deviation),
                                .decay_time = partial.decay_time});
    }
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
  }
  if (measured.lines.empty()) {
    throw std::runtime_error(fmt::format("{}: no partial stands out of the noise", file.string()));
  }
  return measured;
}

}  // namespace

Measurements read_measurements(const std::filesystem::path& file) {
  const auto ending = file.extension();
  Measurements measured = ending == ".yaml" || ending == ".yml" ? read_yaml(file) : read_recording(file);
  std::ranges::sort(measured.lines, {}, &Line::frequency);
  return measured;
}

}  // namespace idiophone::fitting
