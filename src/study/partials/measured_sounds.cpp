#include "idiophone/study/partials/measured_sounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string>

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

/// What a path has between two texts that it begins and ends with.
std::optional<std::string> between(const std::string& path, const std::string& before, const std::string& after) {
  if (!path.starts_with(before) || !path.ends_with(after)) {
    return {};
  }
  return path.substr(before.size(), path.size() - before.size() - after.size());
}

/// Rows of a series.
struct Rows {
  std::int64_t first = 0;
  std::int64_t count = 0;
};

/// The rows from `start` to `end`, s.
Rows rows_between(const results::SeriesReader& reader, const spectra::Series& series, double start, double end) {
  const std::int64_t all = reader.rows(series);
  const auto first = std::clamp<std::int64_t>(std::llround(start * series.rate), 0, all);
  const auto last = std::clamp<std::int64_t>(std::llround(end * series.rate) + 1, first, all);
  return {first, last - first};
}

/// The last time at which one of the columns has another value than in the row before, s.
std::optional<double> last_change(const results::SeriesReader& reader, const spectra::Series& series,
                                  const std::string& column, const Rows& rows) {
  const std::vector<double> values = reader.read(series, rows.first, rows.count);
  const std::size_t width = series.columns.size();
  const auto c = static_cast<std::size_t>(std::ranges::find(series.columns, column) - series.columns.begin());
  for (auto row = static_cast<std::size_t>(rows.count); c < width && row-- > 1;) {
    if (values[row * width + c] != values[(row - 1) * width + c]) {
      return static_cast<double>(rows.first + static_cast<std::int64_t>(row)) / series.rate;
    }
  }
  return {};
}

/// The last time of a force that is not zero, s; none of a force that acts in all rows, as under a body that stands.
std::optional<double> last_touch(const results::SeriesReader& reader, const spectra::Series& series, const Rows& rows) {
  const std::vector<double> values = reader.read(series, rows.first, rows.count);
  const std::size_t width = series.columns.size();
  std::int64_t touched = 0, last = 0;
  for (std::int64_t row = 0; row < rows.count; ++row) {
    const std::span force = std::span(values).subspan(static_cast<std::size_t>(row) * width, width);
    if (std::ranges::any_of(force, [](double value) { return value != 0; })) {
      ++touched;
      last = row;
    }
  }
  if (touched == 0 || touched == rows.count) {
    return {};
  }
  return static_cast<double>(rows.first + last) / series.rate;
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
    if (const auto body = between(series.path, "/motion/", "/orientation")) {
      const Rows rows = rows_between(reader, series, start, end);
      bodies.push_back({*body, largest_turn(reader.read(series, rows.first, rows.count))});
    }
  }
  return bodies;
}

std::vector<ActingForce> acting_forces(const std::filesystem::path& result, double start, double end) {
  const results::SeriesReader reader(result);
  std::vector<ActingForce> acting;
  for (const spectra::Series& series : reader.all()) {
    if (series.path == "/energy") {
      if (const auto until = last_change(reader, series, "work", rows_between(reader, series, start, end))) {
        acting.push_back({"loads", *until});
      }
    } else if (const auto contact = between(series.path, "/contacts/", "/force")) {
      if (const auto until = last_touch(reader, series, rows_between(reader, series, start, end))) {
        acting.push_back({"contact " + *contact, *until});
      }
    }
  }
  return acting;
}

}  // namespace idiophone::partials
