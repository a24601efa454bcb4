// A load's or a drive's course over time: its value, and its keys.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

namespace {

constexpr double pi = std::numbers::pi;

double interpolate(const std::vector<std::array<double, 2>>& table, double time) {
  const auto next = std::ranges::upper_bound(table, time, {}, [](const auto& row) { return row[0]; });
  if (next == table.begin()) {
    return 0.0;
  }
  const auto [left, left_value] = *std::prev(next);
  if (next == table.end()) {
    return time == left ? left_value : 0.0;
  }
  const auto [right, right_value] = *next;
  return left_value + (right_value - left_value) * ((time - left) / (right - left));
}

}  // namespace

double Signal::at(double time) const {
  const double t = time - start;
  if (shape == Shape::table) {
    return interpolate(table, t);
  }
  if (t < 0.0 || t >= duration) {
    return 0.0;
  }
  switch (shape) {
    case Shape::half_sine:
      return std::sin(pi * t / duration);
    case Shape::sine:
      return std::sin(2.0 * pi * frequency * t);
    default:
      return 1.0;
  }
}

double Signal::end() const {
  return start + (shape == Shape::table ? table.back()[0] : duration);
}

bool read_signal(Section& section, const Folder& folder, Signal& signal) {
  using Shape = Signal::Shape;
  const Choices<Shape> shapes{
      {{"half_sine", Shape::half_sine}, {"constant", Shape::constant}, {"sine", Shape::sine}, {"table", Shape::table}}};
  const bool shape_known = section.optional("shape", signal.shape, shapes);
  bool good = section.optional("start", signal.start, Range{.at_least = 0.0, .at_most = 1e6, .unit = "s"});
  if (!shape_known) {  // and so not which of these are needed
    for (const char* key : {"duration", "frequency", "table"}) {
      static_cast<void>(section.find(key));
    }
    return false;
  }

  signal.duration = infinity;
  if (signal.shape == Shape::half_sine) {
    good &= section.required("duration", signal.duration, positive_seconds);
  } else if (signal.shape == Shape::table) {
    good &= section.refuse("duration", "a table ends with its last row; leave duration out");
  } else {
    good &= section.optional("duration", signal.duration, positive_seconds);
  }
  good &= signal.shape == Shape::sine
              ? section.required("frequency", signal.frequency, Range{.above = 0.0, .at_most = 1e9, .unit = "Hz"})
              : section.refuse("frequency", "only 'shape: sine' has a frequency");
  good &= signal.shape == Shape::table ? section.required("table", signal.table, folder, time_and_value)
                                       : section.refuse("table", "only 'shape: table' has a table");
  return good;
}

}  // namespace idiophone::scene
