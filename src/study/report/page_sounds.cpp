#include "page_sounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "idiophone/foundation/spectra/spectrum.hpp"
#include "idiophone/foundation/web/web_page.hpp"
#include "idiophone/study/partials/compare.hpp"

namespace idiophone::report {

namespace {

using nlohmann::json;

constexpr double longest_analysis = 4.0;  // s; more takes long and hardly changes the partials
constexpr double dynamic_range = 60.0;    // dB

/// The frequency weighting A as a factor, 1 at 1000 Hz (IEC 61672-1, annex E).
double a_weighting(double frequency) {
  const double square = frequency * frequency;
  const auto above = [square](double corner) { return square + corner * corner; };
  return 1.2589 * std::pow(12194.0, 2) * square * square /
         (above(20.6) * std::sqrt(above(107.7) * above(737.9)) * above(12194.0));
}

/// 10 log10 of the time integral of the squared, weighted sound.
double exposure(const std::vector<double>& samples, double rate) {
  const spectra::Spectrum spectrum = spectra::spectrum(samples, rate);
  double sum = 0.0;
  for (std::size_t bin = 0; bin < spectrum.level.size(); ++bin) {
    const double weight = a_weighting(static_cast<double>(bin) * spectrum.frequency_step);
    sum += weight * weight * std::pow(10.0, 0.1 * spectrum.level[bin]);
  }
  const double duration = static_cast<double>(samples.size()) / rate;
  return 10.0 * std::log10(std::max(sum * duration, 1e-40));
}

Channel channel_of(const spectra::Sound& sound, std::size_t number) {
  Channel channel{.name = sound.channels[number],
                  .unit = sound.unit,
                  .attached = sound.attached,
                  .rate = sound.rate,
                  .samples = sound.samples[number]};
  const double length = static_cast<double>(channel.samples.size()) / channel.rate;
  channel.start = std::min(0.02, length / 10);
  channel.duration = std::min(length - channel.start, longest_analysis);
  channel.partials =
      partials::find_partials(channel.samples, channel.rate,
                              {.start = channel.start, .duration = channel.duration, .dynamic_range = dynamic_range});
  channel.exposure = exposure(channel.samples, channel.rate);
  return channel;
}

json number(const std::optional<double>& value) {
  return value ? json(*value) : json();
}

}  // namespace

std::vector<Channel> read_channels(const std::filesystem::path& result) {
  std::vector<Channel> channels;
  for (const spectra::Sound& sound : results::read_sounds(result)) {
    for (std::size_t number = 0; number < sound.samples.size(); ++number) {
      channels.push_back(channel_of(sound, number));
    }
  }
  if (channels.empty()) {
    throw std::runtime_error(fmt::format("{} has no sound to report on", result.string()));
  }
  return channels;
}

json to_json(const Channel& channel) {
  constexpr double largest_whole = 32767.0;
  double loudest = 0.0;
  for (const double sample : channel.samples) {
    loudest = std::max(loudest, std::abs(sample));
  }
  const double scale = loudest > 0 ? loudest / largest_whole : 1.0;
  std::vector<std::int16_t> whole;
  std::ranges::transform(channel.samples, std::back_inserter(whole),
                         [scale](double sample) { return static_cast<std::int16_t>(std::lround(sample / scale)); });
  json answer = {{"name", channel.name},         {"unit", channel.unit},
                 {"attached", channel.attached}, {"rate", channel.rate},
                 {"loudest", loudest},           {"samples", web::encoded(whole)},
                 {"start", channel.start},       {"duration", channel.duration},
                 {"exposure", channel.exposure}, {"complete", channel.partials.complete},
                 {"partials", json::array()}};
  const bool pressure = channel.unit == "Pa";
  for (const partials::Partial& partial : channel.partials.found) {
    answer["partials"].push_back({{"frequency", partial.frequency},
                                  {"level", partial.level},
                                  {"spl", pressure ? json(partials::sound_pressure_level(partial.level)) : json()},
                                  {"decay_time", number(partial.decay_time)},
                                  {"remainder", number(partial.remainder)}});
  }
  return answer;
}

json compared(const Channel& first, const Channel& second) {
  partials::References references{.name = first.name, .frequencies = {}};
  std::ranges::transform(first.partials.found, std::back_inserter(references.frequencies),
                         &partials::Partial::frequency);
  json pairs = json::array();
  double cents = 0.0;
  double levels = 0.0;
  const auto matches = partials::match(second.partials.found, references);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!matches[i].partial) {
      continue;
    }
    const partials::Partial& own = first.partials.found[i];
    const partials::Partial& other = second.partials.found[*matches[i].partial];
    const double level = other.level - own.level;
    pairs.push_back(
        {{"frequency", own.frequency},
         {"other_frequency", other.frequency},
         {"cents", matches[i].cents},
         {"level", level},
         {"decay_ratio", own.decay_time && other.decay_time ? json(*other.decay_time / *own.decay_time) : json()}});
    cents += matches[i].cents * matches[i].cents;
    levels += level * level;
  }
  const double count = std::max<double>(1.0, static_cast<double>(pairs.size()));
  return {{"first", first.name},
          {"second", second.name},
          {"first_alone", first.partials.found.size() - pairs.size()},
          {"pairs", pairs},
          {"cents", std::sqrt(cents / count)},
          {"level", std::sqrt(levels / count)},
          {"exposure", second.exposure - first.exposure}};
}

}  // namespace idiophone::report
