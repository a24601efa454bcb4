#include "mode_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

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

/// The bodies that have a part of the kinetic energy, the largest first: "lid 93 %, box 7 %".
std::string shares(const std::vector<std::string>& bodies, const std::vector<double>& kinetic_shares) {
  constexpr double least = 0.005;
  std::vector<std::size_t> order(bodies.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t b) { return kinetic_shares[b]; });
  std::string text;
  for (const std::size_t b : order) {
    if (kinetic_shares[b] >= least) {
      text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", bodies[b], 100 * kinetic_shares[b]);
    }
  }
  return text;
}

/// The head and the cells of the column of shares; empty texts where there is one body.
std::vector<std::string> column_of_shares(const ModeTable& table) {
  std::vector<std::string> column(table.modes.size() + 1);
  if (table.bodies.size() == 1) {
    return column;
  }
  column.front() = "kinetic energy";
  for (std::size_t mode = 0; mode < table.modes.size(); ++mode) {
    column[mode + 1] = shares(table.bodies, table.modes[mode].kinetic_shares);
  }
  const std::size_t width = std::ranges::max(column, {}, &std::string::size).size();
  std::ranges::for_each(column, [&](std::string& cell) { cell = fmt::format("  {:>{}}", cell, width); });
  return column;
}

/// @param shares  as column_of_shares()
void print_head(const ModeTable& table, const std::string& shares) {
  fmt::print("{:>4}  {:>14}  {:>13}  {:>9}{}{}", "mode", "frequency/Hz", "damping ratio", "T60/s",
             table.mesh_errors.empty() ? "" : "  mesh/cents", table.air.shift.empty() ? "" : "  air/cents");
  if (table.bounds) {
    fmt::print("  {:>12}  {:>12}  {:>11}", "lower/Hz", "upper/Hz", "width/cents");
  }
  for (const auto& set : table.references) {
    fmt::print("{}", partials::cents_head(set));
  }
  fmt::print("{}{}\n", shares, has_kinds(table) ? "  kind" : "");
}

void print_mode(const ModeTable& table, std::size_t number, const std::string& shares) {
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
  fmt::print("{}{}{}\n", shares, has_kinds(table) ? "  " : "", table.kinds[number]);
}

/// Whether a mode of a round body has a twin, which is turned by a quarter of its nodal angle: "(m, n)" with m above 0.
bool has_twin(const std::string& kind) {
  return kind.starts_with('(') && !kind.starts_with("(0,");
}

/// How far the two modes of a pair are apart, where they are farthest; empty below a cent.
std::string split_in_words(const ModeTable& table) {
  double widest = 1.0;  // cents
  std::string words;
  std::map<std::string, std::size_t> first_ones;  // without their twins so far
  for (std::size_t mode = 0; table.is_round && mode < table.modes.size(); ++mode) {
    const auto first = first_ones.find(table.kinds[mode]);
    if (first == first_ones.end()) {
      first_ones.emplace(table.kinds[mode], mode);
      continue;
    }
    const double apart = partials::cents(table.modes[mode].frequency, table.modes[first->second].frequency);
    if (has_twin(table.kinds[mode]) && apart > widest) {
      widest = apart;
      words = fmt::format(
          "(modes {} and {} are one pair and {:.1f} cents apart, because the mesh, the body or what holds it is not "
          "quite round)\n",
          first->second + 1, mode + 1, apart);
    }
    first_ones.erase(first);
  }
  return words;
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
  const std::vector<std::string> shares = column_of_shares(table);
  print_head(table, shares.front());
  for (std::size_t number = 0; number < table.modes.size(); ++number) {
    print_mode(table, number, shares[number + 1]);
  }
  if (table.bounds) {
    fmt::print("({})\n", assumption(*table.bounds));
  }
  fmt::print("{}", split_in_words(table));
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
    for (std::size_t b = 0; b < table.bodies.size(); ++b) {
      one["kinetic_share"][table.bodies[b]] = mode.kinetic_shares[b];
    }
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
