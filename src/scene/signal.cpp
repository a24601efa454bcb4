// A load's or a drive's course over time: its value, and its keys.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"
#include "table_header.hpp"

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

/// A table of newtons says how strong the force is, so that the deck can only give its direction.
bool check_unit(Section& section) {
  const Node& table = *section.find("table");
  if (!units_of_table(table.file).is_force) {
    return true;
  }
  const std::vector<Node>& keys = section.node().children;
  const auto force = std::ranges::find(keys, "force", &Node::key);  // known only to sections that read it
  if (force == keys.end()) {
    return section.mistakes().add(table, "has newtons, but this is no force: leave the unit of its values out");
  }
  Vector3 direction = Vector3::Zero();
  Mistakes known;  // the reader of the force tells them
  if (read(*force, known, direction, Range{}) && std::abs(direction.norm() - 1.0) > 1e-3) {
    return section.mistakes().add(
        *force, fmt::format("the table has newtons, so that this must be a direction of length 1, but it has {:.4g}",
                            direction.norm()));
  }
  return true;
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
  if (signal.shape != Shape::table) {
    good &= section.refuse("table", "only 'shape: table' has a table");
  } else {
    good &= section.required("table", signal.table, folder, time_and_value) && check_unit(section);
  }
  return good;
}

}  // namespace idiophone::scene
