#include "impacts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "idiophone/run/results/series_reader.hpp"
#include "onsets.hpp"

namespace idiophone::report {

namespace {

constexpr double gap = 0.02;        // s, without force
constexpr double one_blow = 0.03;   // s
constexpr double travel = 0.05;     // s, from a contact to its sound
constexpr double tolerance = 0.01;  // s, of an onset

/// When a contact begins, and the largest force until it ends.
std::vector<Impact> touches_of(const results::SeriesReader& reader, const spectra::Series& series,
                               const std::string& contact) {
  const std::vector<double> values = reader.read(series);
  const std::size_t width = series.columns.size();
  std::vector<Impact> touches;
  double last = -1.0;
  for (std::size_t row = 0; row < values.size() / width; ++row) {
    double square = 0.0;
    for (const double value : std::span(values).subspan(row * width, width)) {
      square += value * value;
    }
    if (square == 0.0) {
      continue;
    }
    const double time = static_cast<double>(row) / series.rate;
    if (touches.empty() || time - last > gap) {
      touches.push_back({.time = time, .cause = contact, .force = 0.0});
    }
    touches.back().force = std::max(touches.back().force, std::sqrt(square));
    touches.back().end = last = time;
  }
  return touches;
}

std::vector<Impact> all_touches(const std::filesystem::path& result) {
  const results::SeriesReader reader(result);
  const std::string begin = "/contacts/";
  const std::string end = "/force";
  std::vector<Impact> touches;
  for (const spectra::Series& series : reader.all()) {
    if (series.path.starts_with(begin) && series.path.ends_with(end)) {
      const auto name = series.path.substr(begin.size(), series.path.size() - begin.size() - end.size());
      std::ranges::move(touches_of(reader, series, name), std::back_inserter(touches));
    }
  }
  std::ranges::stable_sort(touches, {}, &Impact::time);
  return touches;
}

bool names(const std::string& cause, const std::string& contact) {
  return (", " + cause + ", ").find(", " + contact + ", ") != std::string::npos;
}

/// Touches within a short time become one.
std::vector<Impact> joined(const std::vector<Impact>& touches) {
  std::vector<Impact> blows;
  for (const Impact& touch : touches) {
    if (blows.empty() || touch.time - blows.back().time > one_blow) {
      blows.push_back(touch);
      continue;
    }
    Impact& blow = blows.back();
    blow.cause += names(blow.cause, touch.cause) ? "" : ", " + touch.cause;
    blow.force = std::max(blow.force, touch.force);
    blow.end = std::max(blow.end, touch.end);
  }
  return blows;
}

}  // namespace

std::vector<Impact> impacts(const std::filesystem::path& result, const spectra::Sound& heard) {
  std::vector<Impact> blows = joined(all_touches(result));
  const std::size_t contacts = blows.size();
  for (const double onset : onsets(heard.samples.front(), heard.rate)) {
    const auto explains = [&](const Impact& blow) {
      return onset > blow.time - tolerance && onset < blow.time + travel + tolerance;
    };
    if (std::none_of(blows.begin(), blows.begin() + static_cast<std::ptrdiff_t>(contacts), explains)) {
      blows.push_back({.time = onset, .cause = "", .end = onset});
    }
  }
  std::ranges::stable_sort(blows, {}, &Impact::time);
  return blows;
}

}  // namespace idiophone::report
