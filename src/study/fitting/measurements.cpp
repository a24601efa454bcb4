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
#include "idiophone/study/partials/free_parts.hpp"
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

double energy_of(const std::vector<double>& samples) {
  return std::inner_product(samples.begin(), samples.end(), samples.begin(), 0.0);
}

/// The partials of the first free part that is a sum of damped sines; those of the best part if there is none.
partials::Partials free_partials(const std::vector<double>& samples, double rate) {
  constexpr std::size_t most_parts = 4;
  std::optional<partials::Partials> best;
  const std::vector<partials::FreePart> parts = partials::free_parts(samples, rate);
  for (std::size_t i = 0; i < std::min(parts.size(), most_parts); ++i) {
    partials::PartialOptions options{.duration = parts[i].duration, .dynamic_range = 60.0};
    options.start = parts[i].start;
    partials::Partials found = partials::find_partials(samples, rate, options);
    if (found.complete) {
      return found;
    }
    best = best ? best : std::move(found);
  }
  return *best;
}

/// Whether a partial is hum of the mains.
bool is_hum(const partials::Partial& partial) {
  constexpr double near = 0.3;   // Hz
  constexpr double slow = 10.0;  // s
  const auto is_multiple = [&](double mains) {
    const double harmonic = std::max(1.0, std::round(partial.frequency / mains));
    return std::abs(partial.frequency - harmonic * mains) < near;
  };
  return partial.decay_time.value_or(2 * slow) > slow && (is_multiple(50.0) || is_multiple(60.0));
}

Measurements read_recording(const std::filesystem::path& file) {
  const spectra::SoundFile sound = spectra::read_sound_file(file);
  const std::vector<double>& samples = *std::ranges::max_element(sound.channels, {}, energy_of);
  Measurements measured;
  try {
    const partials::Partials partials = free_partials(samples, sound.rate);
    if (!partials.complete) {
      throw std::invalid_argument(
          "after the blow, there is more than a sum of damped sines, for example soft clicks or speech; cut the "
          "recording before it");
    }
    for (const partials::Partial& partial : partials.found) {
      if (is_hum(partial)) {
        measured.hum.push_back(partial.frequency);
        continue;
      }
      const double deviation = partials::cents(partial.frequency + partial.frequency_deviation, partial.frequency);
      measured.lines.push_back({.frequency = partial.frequency,
                                .uncertainty = std::max(default_uncertainty, deviation),
                                .decay_time = partial.decay_time,
                                .level = partial.level});
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
