// `idiophone analyze`: the partials and levels of a sound.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "answer.hpp"
#include "command.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/results/sound_reader.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "idiophone/study/partials/free_parts.hpp"
#include "idiophone/study/partials/measured_sounds.hpp"
#include "idiophone/study/partials/partial_tables.hpp"
#include "level_answers.hpp"

namespace idiophone::app {

namespace {

struct AnalyzeOptions {
  std::filesystem::path result;  ///< NAME.h5, or a sound file
  std::string listener;          ///< empty for all
  std::optional<double> start;   ///< s, after the blow; default: 0.02, or a tenth of a short sound
  std::optional<double> duration;
  double lowest = 20.0;  ///< Hz
  std::optional<double> highest;
  double dynamic_range = 60.0;  ///< dB
  double tolerance = 100.0;     ///< cents, of matches with references
  bool levels = false;
  Style style = Style::text;
  std::filesystem::path partials;     ///< CSV to write, if any
  std::filesystem::path spectrum;     ///< CSV to write, if any
  std::filesystem::path spectrogram;  ///< CSV to write, if any
};

void declare(CLI::App& app, AnalyzeOptions& options) {
  app.add_option("result", options.result, "NAME.h5, or a sound file: WAV, FLAC, ...")->required();
  app.add_option("--listener", options.listener, "only this one");
  app.add_option("--start", options.start,
                 "s, after the blow; levels are those at this time (default: 0.02, or a tenth of a short sound; of a "
                 "recording, after its blow)")
      ->capture_default_str();
  app.add_option("--duration", options.duration, "s to look at");
  app.add_option("--lowest", options.lowest, "Hz")->capture_default_str();
  app.add_option("--highest", options.highest, "Hz");
  app.add_option("--range", options.dynamic_range, "dB below the strongest partial")->capture_default_str();
  app.add_option("--tolerance", options.tolerance, "cents, of matches with the deck's references")
      ->capture_default_str();
  app.add_flag("--levels", options.levels, "also prints sound levels, third octaves and loudness (--json: always)");
  add_json(app, options.style);
  app.add_option("--partials", options.partials, "CSV file for the partials");
  app.add_option("--spectrum", options.spectrum, "CSV file for the spectrum");
  app.add_option("--spectrogram", options.spectrogram, "CSV file for the spectrogram");
}

/// What is analysed: what the user chose; of a result, from shortly after its beginning; of a recording, from after the
/// blow to the next click or blow.
partials::FreePart part_of(const spectra::Sound& sound, const AnalyzeOptions& options) {
  const double length = static_cast<double>(sound.samples.front().size()) / sound.rate;
  if (!options.start && !options.duration && !partials::is_result_file(options.result)) {
    const auto energy = [](const std::vector<double>& samples) {
      return std::inner_product(samples.begin(), samples.end(), samples.begin(), 0.0);
    };
    return partials::free_parts(*std::ranges::max_element(sound.samples, {}, energy), sound.rate).front();
  }
  const double start = options.start.value_or(std::min(0.02, length / 10));
  return {start, options.duration.value_or(length - start)};
}

/// Where the analysis begins, s.
double start_of(const spectra::Sound& sound, const AnalyzeOptions& options) {
  return part_of(sound, options).start;
}

using AllReferences = std::vector<partials::References>;

AllReferences read_references(const std::filesystem::path& result) {
  AllReferences all;
  for (const auto& [name, frequencies] : results::read_references(result)) {
    all.push_back({name, frequencies});
  }
  return all;
}

/// Warns of bodies that turn while a listener that stands still hears them.
void warn_of_turning(const spectra::Sound& sound, const AnalyzeOptions& options) {
  constexpr double noticeable = 5.0;  // degrees
  const auto [start, duration] = part_of(sound, options);
  const double end = start + duration;
  for (const auto& [body, degrees] : partials::turned_bodies(options.result, start, end)) {
    if (degrees > noticeable && sound.attached != body) {
      spdlog::warn(
          "{}: body {} turns by {:.0f} degrees in this part, so partials swell, fade or split for a listener that "
          "stands still, and decay times are wrong. Attach the listener to it (attached: {}), or balance the blow "
          "(balanced: true)",
          sound.name, body, degrees, body);
    }
  }
}

/// Warns of forces that a listener hears in the part that is analysed.
void warn_of_forces(const spectra::Sound& sound, const AnalyzeOptions& options) {
  const auto [start, duration] = part_of(sound, options);
  std::vector<std::string> acting;
  for (const auto& [name, until] : partials::acting_forces(options.result, sound.name, start, start + duration)) {
    acting.push_back(fmt::format("{}, heard until {:.4g} s", name, until));
  }
  if (!acting.empty()) {
    spdlog::warn(
        "{}: forces act in this part ({}), so the sound is no free decay: frequencies of the forces look like "
        "partials, and levels and decay times of partials can be wrong. Choose a part without forces (--start, "
        "--duration)",
        sound.name, fmt::join(acting, "; "));
  }
}

partials::PartialsByChannel find_partials(const spectra::Sound& sound, const AnalyzeOptions& options) {
  partials::PartialOptions wanted;
  const partials::FreePart part = part_of(sound, options);
  wanted.start = part.start;
  wanted.duration = part.duration;
  wanted.lowest = options.lowest;
  wanted.highest = options.highest;
  wanted.dynamic_range = options.dynamic_range;
  partials::PartialsByChannel partials;
  for (std::size_t channel = 0; channel < sound.samples.size(); ++channel) {
    partials.push_back(partials::find_partials(sound.samples[channel], sound.rate, wanted));
    if (!partials.back().complete) {
      spdlog::warn(
          "{}: the search for partials ended early: what is left is no sum of damped sines, but, for example, a click "
          "or another blow. Choose a part without it (--start, --duration)",
          sound.channels[channel]);
    }
  }
  return partials;
}

partials::SampleUnit unit_of(const spectra::Sound& sound) {
  return sound.unit == "Pa" ? partials::SampleUnit::pascal : partials::SampleUnit::any;
}

/// A table for each channel, with a column for each set of references.
void print_partials(const spectra::Sound& sound, const partials::PartialsByChannel& partials,
                    const AllReferences& references, const AnalyzeOptions& options) {
  for (std::size_t channel = 0; channel < partials.size(); ++channel) {
    fmt::print("{} (level in dB re {} at {} s)\n", sound.channels[channel],
               sound.unit.empty() ? "full scale" : "1 " + sound.unit, start_of(sound, options));
    fmt::print("{}\n", partials::table(partials[channel].found, references, options.tolerance, unit_of(sound)));
  }
}

nlohmann::json to_json(const std::optional<double>& number) {
  return number ? nlohmann::json(*number) : nlohmann::json();
}

nlohmann::json to_json(const partials::Partial& partial, const spectra::Sound& sound) {
  const bool pressure = unit_of(sound) == partials::SampleUnit::pascal;
  return {{"frequency", partial.frequency},
          {"level", partial.level},
          {"sound_pressure_level",
           pressure ? nlohmann::json(partials::sound_pressure_level(partial.level)) : nlohmann::json()},
          {"decay_time", to_json(partial.decay_time)},
          {"frequency_deviation", partial.frequency_deviation},
          {"prominence", partial.prominence},
          {"remainder", to_json(partial.remainder)}};
}

nlohmann::json to_json(const partials::Match& match) {
  nlohmann::json found = {{"reference", match.reference}, {"partial", nullptr}};
  if (match.partial) {
    found["partial"] = *match.partial;
    found["cents"] = match.cents;
    found["percent"] = match.percent;
  }
  return found;
}

/// Levels of the whole sound, or of the part that the user chooses: the blow belongs to them.
LevelAnswer levels_in(const spectra::Sound& sound, const AnalyzeOptions& options) {
  return measure_levels(sound, options.start.value_or(0.0),
                        options.duration.value_or(std::numeric_limits<double>::infinity()));
}

/// Appends what was found in each channel.
void add_json(nlohmann::json& channels, const spectra::Sound& sound, const partials::PartialsByChannel& partials,
              const AllReferences& references, const AnalyzeOptions& options) {
  const LevelAnswer levels = levels_in(sound, options);
  for (std::size_t channel = 0; channel < partials.size(); ++channel) {
    nlohmann::json found = {{"listener", sound.name},
                            {"channel", sound.channels[channel]},
                            {"unit", sound.unit},
                            {"start", start_of(sound, options)},
                            {"complete", partials[channel].complete},
                            {"partials", nlohmann::json::array()},
                            {"references", nlohmann::json::object()},
                            {"levels", to_json(levels, channel)}};
    for (const auto& partial : partials[channel].found) {
      found["partials"].push_back(to_json(partial, sound));
    }
    for (const auto& set : references) {
      auto& matches = found["references"][set.name] = nlohmann::json::array();
      for (const auto& match : partials::match(partials[channel].found, set, options.tolerance)) {
        matches.push_back(to_json(match));
      }
    }
    channels.push_back(found);
  }
}

int analyze(const AnalyzeOptions& options) {
  const bool is_result = partials::is_result_file(options.result);
  const AllReferences references = is_result ? read_references(options.result) : AllReferences{};
  bool found = false;
  auto channels = nlohmann::json::array();
  for (const spectra::Sound& sound : partials::read_sounds(options.result)) {
    if (!options.listener.empty() && options.listener != sound.name) {
      continue;
    }
    if (is_result) {
      warn_of_turning(sound, options);
      warn_of_forces(sound, options);
    }
    const partials::PartialsByChannel partials = find_partials(sound, options);
    if (options.style == Style::json) {
      add_json(channels, sound, partials, references, options);
    } else {
      print_partials(sound, partials, references, options);
      if (options.levels) {
        print_levels(sound, levels_in(sound, options));
      }
    }
    if (!found && !options.partials.empty()) {
      partials::write_partials(options.partials, sound, partials);
    }
    if (!found && !options.spectrum.empty()) {
      partials::write_spectrum(options.spectrum, sound);
    }
    if (!found && !options.spectrogram.empty()) {
      partials::write_spectrogram(options.spectrogram, sound);
    }
    found = true;
  }
  if (!found) {
    throw std::runtime_error(fmt::format("{} has no listener '{}'", options.result.string(), options.listener));
  }
  if (options.style == Style::json) {
    print_answer(nlohmann::json{{"tolerance", options.tolerance}, {"channels", channels}});
  } else if (!references.empty()) {
    fmt::print("(under each set of references: cents from the nearest of them, within {:g})\n", options.tolerance);
  }
  return loop::exit_finished;
}

}  // namespace

Command analyze_command() {
  return make_command<AnalyzeOptions>("analyze", "find the partials and levels of a sound", Ranks::one, declare,
                                      analyze);
}

}  // namespace idiophone::app
