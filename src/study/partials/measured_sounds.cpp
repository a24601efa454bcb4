#include "idiophone/study/partials/measured_sounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/foundation/spectra/sound_file.hpp"
#include "idiophone/run/results/series_reader.hpp"

namespace idiophone::partials {

namespace {

/// The largest angle between the first and any other of unit quaternions, degrees.
double largest_turn(const std::vector<double>& quaternions) {
  double least = 1.0;  // cosine of half the angle
  for (std::size_t row = 0; row + 3 < quaternions.size(); row += 4) {
    double product = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      product += quaternions[i] * quaternions[row + i];
    }
    least = std::min(least, std::abs(product));
  }
  return 2 * std::acos(least) * 180 / std::numbers::pi;
}

}  // namespace

bool is_result_file(const std::filesystem::path& path) {
  return path.extension() == ".h5";
}

std::vector<spectra::Sound> read_sounds(const std::filesystem::path& path) {
  if (is_result_file(path)) {
    return results::read_sounds(path);
  }
  spectra::SoundFile file = spectra::read_sound_file(path);
  spectra::Sound sound{.name = path.stem().string(), .rate = file.rate, .unit = "", .channels = {}, .samples = {}};
  for (std::size_t channel = 0; channel < file.channels.size(); ++channel) {
    sound.channels.push_back(file.channels.size() == 1 ? sound.name : fmt::format("{}.{}", sound.name, channel + 1));
  }
  sound.samples = std::move(file.channels);
  return {sound};
}

std::vector<TurnedBody> turned_bodies(const std::filesystem::path& result, double start, double end) {
  const std::string motion = "/motion/";
  const std::string orientation = "/orientation";
  const results::SeriesReader reader(result);
  std::vector<TurnedBody> bodies;
  for (const spectra::Series& series : reader.all()) {
    if (!series.path.starts_with(motion) || !series.path.ends_with(orientation)) {
      continue;
    }
    const std::int64_t rows = reader.rows(series);
    const auto first = std::clamp<std::int64_t>(std::llround(start * series.rate), 0, rows);
    const auto last = std::clamp<std::int64_t>(std::llround(end * series.rate) + 1, first, rows);
    const std::string body = series.path.substr(motion.size(), series.path.size() - motion.size() - orientation.size());
    bodies.push_back({body, largest_turn(reader.read(series, first, last - first))});
  }
  return bodies;
}

}  // namespace idiophone::partials
