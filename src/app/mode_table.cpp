#include "mode_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "idiophone/run/loop/facts.hpp"

namespace idiophone::app {

namespace {

bool has_kinds(const ModeTable& table) {
  return std::ranges::any_of(table.kinds, [](const std::string& kind) { return !kind.empty(); });
}

/// Cents, if they are known.
std::string cents(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:+.1f}", value);
}

void print_head(const ModeTable& table) {
  fmt::print("{:>4}  {:>14}  {:>13}  {:>9}{}{}", "mode", "frequency/Hz", "damping ratio", "T60/s",
             table.mesh_errors.empty() ? "" : "  mesh/cents", table.air.shift.empty() ? "" : "  air/cents");
  if (table.bounds) {
    fmt::print("  {:>12}  {:>12}  {:>11}", "lower/Hz", "upper/Hz", "width/cents");
  }
  for (const auto& set : table.references) {
    fmt::print("{}", partials::cents_head(set));
  }
  fmt::print("{}\n", has_kinds(table) ? "  kind" : "");
}

void print_mode(const ModeTable& table, std::size_t number) {
  const eigenmodes::Mode& mode = table.modes[number];
  fmt::print("{:>4}  {:>14.4f}  {:>13.4g}  {:>9}", number + 1, mode.frequency, mode.damping_ratio,
             std::isfinite(mode.decay_time) ? fmt::format("{:.4g}", mode.decay_time) : "-");
  if (!table.mesh_errors.empty()) {
    fmt::print("  {:>10}", cents(table.mesh_errors[number]));
  }
  if (!table.air.shift.empty()) {
    fmt::print("  {:>9}", cents(table.air.shift[number]));
  }
  if (table.bounds) {
    const double lower = table.bounds->lower[number];
    const double upper = table.bounds->upper[number];
    fmt::print("  {:>12.4f}  {:>12.4f}  {:>11.2f}", lower, upper, partials::cents(upper, lower));
  }
  for (const auto& set : table.references) {
    fmt::print("{}", partials::cents_cell(partials::cents_from_nearest(mode.frequency, set, table.tolerance), set));
  }
  fmt::print("{}{}\n", has_kinds(table) ? "  " : "", table.kinds[number]);
}

}  // namespace

std::vector<partials::References> references_of(const scene::Scene& scene) {
  std::vector<partials::References> all;
  for (const auto& [name, frequencies] : scene.references) {
    all.push_back({name, frequencies});
  }
  return all;
}

void print(const ModeTable& table) {
  print_head(table);
  for (std::size_t number = 0; number < table.modes.size(); ++number) {
    print_mode(table, number);
  }
  if (table.bounds) {
    fmt::print("({})\n", assumption(*table.bounds));
  }
  if (!table.references.empty()) {
    fmt::print("(under each set of references: cents from the nearest of them, within {:g})\n", table.tolerance);
  }
}

nlohmann::json to_json(const ModeTable& table) {
  auto all = nlohmann::json::array();
  for (const eigenmodes::Mode& mode : table.modes) {
    const std::size_t number = all.size();
    const std::string& kind = table.kinds[number];
    nlohmann::json one = {
        {"frequency", mode.frequency},
        {"damping_ratio", mode.damping_ratio},
        {"decay_time", loop::number_or_null(mode.decay_time)},
        {"kind", kind.empty() ? nlohmann::json() : nlohmann::json(kind)},
        {"mesh_error", table.mesh_errors.empty() ? nlohmann::json() : loop::number_or_null(table.mesh_errors[number])},
        {"cents", nlohmann::json::object()}};
    if (!table.air.shift.empty()) {
      one["air_shift"] = loop::number_or_null(table.air.shift[number]);
      one["radiation_decay"] = loop::number_or_null(table.air.radiation_decay[number]);
    }
    for (const auto& set : table.references) {
      const auto cents = partials::cents_from_nearest(mode.frequency, set, table.tolerance);
      one["cents"][set.name] = cents ? nlohmann::json(*cents) : nlohmann::json();
    }
    all.push_back(one);
  }
  return all;
}

}  // namespace idiophone::app
