#include "idiophone/study/partials/measured_sounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>

#include "idiophone/foundation/spectra/sound_file.hpp"
#include "idiophone/run/results/series_reader.hpp"
#include "names_in_paths.hpp"
#include "rows_between.hpp"

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
  const results::SeriesReader reader(result);
  std::vector<TurnedBody> bodies;
  for (const spectra::Series& series : reader.all()) {
    if (const auto body = name_between(series.path, "/motion/", "/orientation")) {
      const Rows rows = rows_between(reader, series, start, end);
      bodies.push_back({*body, largest_turn(reader.read(series, rows.first, rows.count))});
    }
  }
  return bodies;
}

}  // namespace idiophone::partials
