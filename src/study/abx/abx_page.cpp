#include "idiophone/study/abx/abx_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "abx_page_files.hpp"
#include "idiophone/foundation/web/web_page.hpp"
#include "idiophone/study/partials/measured_sounds.hpp"

namespace idiophone::abx {

namespace {

using nlohmann::json;
using spectra::Sound;

std::string names_of(const std::vector<Sound>& sounds) {
  std::string names;
  for (const Sound& sound : sounds) {
    names += (names.empty() ? "" : ", ") + sound.name;
  }
  return names;
}

/// The sound of a file; of a result that of the listener.
Sound chosen_sound(const std::filesystem::path& file, const std::string& listener) {
  std::vector<Sound> sounds = partials::read_sounds(file);
  const bool chooses = partials::is_result_file(file) && !listener.empty();
  const auto wanted = chooses ? std::ranges::find(sounds, listener, &Sound::name)
                              : sounds.begin() + (sounds.size() == 1 ? 0 : sounds.size());
  if (wanted == sounds.end()) {
    throw std::runtime_error(sounds.empty() ? fmt::format("{} has no sound", file.string())
                                            : fmt::format("{}: choose one of its listeners by --listener: {}",
                                                          file.string(), names_of(sounds)));
  }
  return std::move(*wanted);
}

/// The largest magnitude, and the sum of squares of all channels times the time between samples.
struct Strength {
  double peak = 0.0;
  double energy = 0.0;
};

Strength strength_of(const Sound& sound) {
  Strength strength;
  for (const std::vector<double>& channel : sound.samples) {
    for (const double sample : channel) {
      strength.peak = std::max(strength.peak, std::abs(sample));
      strength.energy += sample * sample / sound.rate;
    }
  }
  return strength;
}

Sound audible_sound(const std::filesystem::path& file, const std::string& listener) {
  Sound sound = chosen_sound(file, listener);
  if (sound.samples.empty() || sound.samples.size() > 2) {
    throw std::runtime_error(
        fmt::format("{}: {} channels; a browser plays one or two", file.string(), sound.samples.size()));
  }
  const Strength strength = strength_of(sound);
  if (!(strength.peak > 0.0) || !std::isfinite(strength.energy)) {
    throw std::runtime_error(fmt::format("{}: nothing but silence, or samples that are no numbers", file.string()));
  }
  return sound;
}

/// Samples times a factor, as the page decodes them (page/sounds.js).
json to_json(const Sound& sound, double factor) {
  json channels = json::array();
  for (const std::vector<double>& channel : sound.samples) {
    std::vector<float> samples;
    std::ranges::transform(channel, std::back_inserter(samples),
                           [factor](double sample) { return static_cast<float>(factor * sample); });
    channels.push_back(web::encoded(samples));
  }
  return {{"rate", sound.rate}, {"channels", channels}};
}

}  // namespace

std::string page(const Settings& settings) {
  constexpr double largest_sample = 0.9;
  const Sound a = audible_sound(settings.a, settings.listener);
  const Sound b = audible_sound(settings.b, settings.listener);
  if (a.unit != b.unit && !settings.match_levels) {
    throw std::runtime_error(
        fmt::format("{} has the unit '{}' and {} has '{}', so their levels can't be compared; use --match-levels",
                    settings.a.string(), a.unit, settings.b.string(), b.unit));
  }
  const Strength of_a = strength_of(a);
  const Strength of_b = strength_of(b);
  const double ratio = settings.match_levels ? std::sqrt(of_a.energy / of_b.energy) : 1.0;  // what B is multiplied by
  const double factor = largest_sample / std::max(of_a.peak, ratio * of_b.peak);
  const json data = {{"names", {settings.a.filename().string(), settings.b.filename().string()}},
                     {"sounds", {to_json(a, factor), to_json(b, ratio * factor)}},
                     {"matched", settings.match_levels},
                     {"trials", settings.trials}};
  return web::filled_page(std::string(page_template), page_files, data);
}

}  // namespace idiophone::abx
