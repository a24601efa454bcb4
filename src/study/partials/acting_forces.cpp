// Which forces of a result are heard in a part of its sound.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/deck/section.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/foundation/types.hpp"
#include "idiophone/run/results/series_reader.hpp"
#include "idiophone/scene/radiation_section.hpp"
#include "idiophone/study/partials/measured_sounds.hpp"
#include "names_in_paths.hpp"
#include "rows_between.hpp"

namespace idiophone::partials {

namespace {

/// The speed of sound in the deck of a result, m/s.
double speed_of_sound(const results::SeriesReader& result) {
  double speed = scene::AirProperties().speed;
  deck::Mistakes mistakes;
  const deck::Node tree = deck::read_tree(result.deck(), "the deck of the result", result.overrides(), mistakes);
  const deck::Node* node = &tree;
  for (const char* key : {"radiation", "air"}) {
    node = node == nullptr ? nullptr : deck::Section(*node, mistakes).find(key);
  }
  if (node != nullptr) {
    deck::Section(*node, mistakes).optional("speed", speed, deck::Range{.above = 0.0, .unit = "m/s"});
  }
  return speed;
}

/// When a listener hears what happens at a place.
class Ear {
 public:
  /// @param listener  of the result; where it is at the beginning
  Ear(const results::SeriesReader& result, const std::string& listener) : speed_(speed_of_sound(result)) {
    const auto& places = result.find("audio/" + listener).positions;
    if (!places.empty()) {
      place_ = Vector3(places.front().data());
    }
  }

  /// The time that sound takes from a place (m), s; 0 where nobody knows the listener's place.
  [[nodiscard]] double delay(const Vector3& place) const { return place_ ? (place - *place_).norm() / speed_ : 0.0; }

 private:
  double speed_;
  std::optional<Vector3> place_;
};

/// A part of a sound, s.
struct Part {
  double start;
  double end;
  [[nodiscard]] bool has(double time) const { return time >= start && time <= end; }
};

/// All rows of a series until a time (s), a row's columns side by side.
std::vector<double> rows_until(const results::SeriesReader& result, const spectra::Series& series, double end) {
  const Rows rows = rows_between(result, series, 0.0, end);
  return result.read(series, rows.first, rows.count);
}

/// When the sound of a contact's force that is not zero arrives last, s; none of a force that acts in all rows that are
/// heard, as under a body that stands. Rows without touch arrive with the delay of the touch before, or of the first
/// one.
std::optional<double> last_heard_touch(const results::SeriesReader& result, const std::string& contact, const Ear& ear,
                                       const Part& part) {
  const spectra::Series& series = result.find("contacts/" + contact + "/force");
  const std::vector<double> forces = rows_until(result, series, part.end);
  const std::vector<double> points = rows_until(result, result.find("contacts/" + contact + "/point"), part.end);
  const std::size_t end = std::min(forces.size(), points.size());
  const auto acts = [](double value) { return value != 0; };
  const auto touch = static_cast<std::size_t>(std::ranges::find_if(forces, acts) - forces.begin());
  std::size_t heard = 0, touched = 0;
  std::optional<double> last;
  for (std::size_t at = 0, place = touch - touch % 3; place < end && at < end; at += 3) {
    const bool touches = std::ranges::any_of(std::span(forces).subspan(at, 3), acts);
    place = touches ? at : place;
    const double arrival = static_cast<double>(at / 3) / series.rate + ear.delay(Vector3(&points[place]));
    if (part.has(arrival)) {
      ++heard;
      touched += touches ? 1 : 0;
      last = touches ? arrival : last;
    }
  }
  return touched == heard ? std::nullopt : last;
}

/// Times that sound takes, s.
struct Delays {
  double least = 0.0;
  double largest = 0.0;
};

/// From the middles of the bodies at the beginning.
Delays delays_of_bodies(const results::SeriesReader& result, const Ear& ear) {
  std::vector<double> delays;
  for (const spectra::Series& series : result.all()) {
    if (name_between(series.path, "/motion/", "/centre_of_mass") && result.rows(series) > 0) {
      delays.push_back(ear.delay(Vector3(result.read(series, 0, 1).data())));
    }
  }
  return delays.empty() ? Delays() : Delays{std::ranges::min(delays), std::ranges::max(delays)};
}

/// When the sound of loads that do work arrives last, s. Nobody knows which body they act on, so it is the one that is
/// farthest away.
std::optional<double> last_heard_work(const results::SeriesReader& result, const spectra::Series& energy,
                                      const Ear& ear, const Part& part) {
  const std::vector<double> values = rows_until(result, energy, part.end);
  const std::size_t width = energy.columns.size();
  const auto work = static_cast<std::size_t>(std::ranges::find(energy.columns, "work") - energy.columns.begin());
  const Delays delays = delays_of_bodies(result, ear);
  for (std::size_t row = values.size() / width; work < width && row-- > 1;) {
    const double time = static_cast<double>(row) / energy.rate;
    const bool is_heard = time + delays.least <= part.end && time + delays.largest >= part.start;
    if (is_heard && values[row * width + work] != values[(row - 1) * width + work]) {
      return std::min(time + delays.largest, part.end);
    }
  }
  return {};
}

}  // namespace

std::vector<ActingForce> acting_forces(const std::filesystem::path& path, const std::string& listener, double start,
                                       double end) {
  const results::SeriesReader result(path);
  const Ear ear(result, listener);
  const Part part{start, end};
  std::vector<ActingForce> acting;
  for (const spectra::Series& series : result.all()) {
    if (series.path == "/energy") {
      if (const auto until = last_heard_work(result, series, ear, part)) {
        acting.push_back({"loads", *until});
      }
    } else if (const auto contact = name_between(series.path, "/contacts/", "/force")) {
      if (const auto until = last_heard_touch(result, *contact, ear, part)) {
        acting.push_back({"contact " + *contact, *until});
      }
    }
  }
  return acting;
}

}  // namespace idiophone::partials
