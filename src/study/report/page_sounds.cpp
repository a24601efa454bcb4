#include "page_sounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>

#include "idiophone/foundation/web/web_page.hpp"
#include "idiophone/run/results/sound_reader.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "recurring_partials.hpp"

namespace idiophone::report {

namespace {

using nlohmann::json;

constexpr std::size_t most_impacts = 24;  // with partials of their own

/// The sound in which impacts are looked for: of a listener that no body carries, if there is one.
const spectra::Sound& heard(const std::vector<spectra::Sound>& sounds) {
  const auto found = std::ranges::find_if(sounds, [](const spectra::Sound& sound) { return sound.attached.empty(); });
  return found == sounds.end() ? sounds.front() : *found;
}

/// The impacts of a result, at least one; of many, the loudest ones.
std::vector<Impact> loudest_impacts(std::vector<Impact> all, const spectra::Sound& sound) {
  if (all.empty()) {
    return {Impact()};
  }
  const std::vector<double> loudness = peaks(sound.samples.front(), sound.rate, all);
  std::vector<double> descending = loudness;
  std::ranges::sort(descending, std::greater());
  const double least = descending[std::min(most_impacts, all.size()) - 1];
  std::vector<Impact> kept;
  for (std::size_t i = 0; i < all.size() && kept.size() < most_impacts; ++i) {
    if (loudness[i] >= least) {
      kept.push_back(std::move(all[i]));
    }
  }
  return kept;
}

Channel channel_of(const spectra::Sound& sound, std::size_t number, std::span<const Impact> impacts) {
  const std::vector<double>& samples = sound.samples[number];
  return {.name = sound.channels[number],
          .unit = sound.unit,
          .attached = sound.attached,
          .rate = sound.rate,
          .samples = samples,
          .stretches = stretches(samples, sound.rate, impacts),
          .exposure = exposure(samples, sound.rate)};
}

json number(const std::optional<double>& value) {
  return value ? json(*value) : json();
}

json to_json(const partials::Partial& partial, const std::string& unit) {
  return {{"frequency", partial.frequency},
          {"level", partial.level},
          {"spl", unit == "Pa" ? json(partials::sound_pressure_level(partial.level)) : json()},
          {"decay_time", number(partial.decay_time)},
          {"remainder", number(partial.remainder)}};
}

json to_json(const Stretch& stretch, const std::string& unit) {
  json answer = {{"peak", stretch.peak},
                 {"start", stretch.start},
                 {"duration", stretch.duration},
                 {"complete", stretch.partials.complete},
                 {"partials", json::array()}};
  for (const partials::Partial& partial : stretch.partials.found) {
    answer["partials"].push_back(to_json(partial, unit));
  }
  return answer;
}

}  // namespace

Sounds read_sounds(const std::filesystem::path& result) {
  const std::vector<spectra::Sound> all = results::read_sounds(result);
  if (std::ranges::all_of(all, [](const spectra::Sound& sound) { return sound.samples.empty(); })) {
    throw std::runtime_error(fmt::format("{} has no sound to report on", result.string()));
  }
  const std::vector<Impact> found = impacts(result, heard(all));
  Sounds sounds{.impacts = loudest_impacts(found, heard(all))};
  sounds.left_out = found.size() - std::min(found.size(), sounds.impacts.size());
  for (const spectra::Sound& sound : all) {
    for (std::size_t number = 0; number < sound.samples.size(); ++number) {
      sounds.channels.push_back(channel_of(sound, number, sounds.impacts));
    }
  }
  return sounds;
}

json to_json(const Impact& impact) {
  return {{"time", impact.time}, {"cause", impact.cause}, {"force", impact.force}};
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
  json answer = {{"name", channel.name},
                 {"unit", channel.unit},
                 {"attached", channel.attached},
                 {"rate", channel.rate},
                 {"loudest", loudest},
                 {"samples", web::encoded(whole)},
                 {"exposure", channel.exposure.level},
                 {"highest", channel.exposure.highest},
                 {"stretches", json::array()},
                 {"recurring", json::array()}};
  for (const Stretch& stretch : channel.stretches) {
    answer["stretches"].push_back(to_json(stretch, channel.unit));
  }
  for (const RecurringPartial& recurring : recurring_partials(channel.stretches)) {
    answer["recurring"].push_back(to_json(recurring.loudest, channel.unit));
    answer["recurring"].back()["impacts"] = recurring.impacts;
  }
  return answer;
}

json compared(const Channel& first, const Channel& second) {
  const std::vector<partials::Partial>& own_partials = loudest(first.stretches).partials.found;
  const std::vector<partials::Partial>& other_partials = loudest(second.stretches).partials.found;
  partials::References references{.name = first.name, .frequencies = {}};
  std::ranges::transform(own_partials, std::back_inserter(references.frequencies), &partials::Partial::frequency);
  json pairs = json::array();
  double cents = 0.0;
  double levels = 0.0;
  const auto matches = partials::match(other_partials, references);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!matches[i].partial) {
      continue;
    }
    const partials::Partial& own = own_partials[i];
    const partials::Partial& other = other_partials[*matches[i].partial];
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
          {"first_alone", own_partials.size() - pairs.size()},
          {"pairs", pairs},
          {"cents", std::sqrt(cents / count)},
          {"level", std::sqrt(levels / count)},
          {"exposure", second.exposure.level - first.exposure.level}};
}

}  // namespace idiophone::report
