#include "idiophone/study/bench/tool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "idiophone/study/bench/cut_side.hpp"

namespace idiophone::bench {

namespace {

constexpr std::array<std::pair<const char*, Profile>, 2> known = {
    {{"router", Profile::groove}, {"sander", Profile::hollow}}};

/// 0 where the text is no number above 0.
double radius_of(const std::string& text) {
  double value = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_good = error == std::errc{} && rest == text.data() + text.size() && value > 0 && std::isfinite(value);
  return is_good ? value : 0.0;
}

Tool read_tool(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const double radius = colon == std::string::npos ? 0.0 : radius_of(text.substr(colon + 1));
  for (const auto& [word, profile] : known) {
    if (name == word && radius > 0) {
      return {name, profile, radius};
    }
  }
  throw std::runtime_error(fmt::format(
      "--tools: '{}' is not a tool: write router:RADIUS or sander:RADIUS, with a radius above 0 m, e.g. router:0.006",
      text));
}

/// Integral of depth_share() from the middle of a cut to a place (m), m.
double integral_to(const Tool& tool, double place) {
  const double inside = std::clamp(place, -tool.radius, tool.radius);
  switch (tool.profile) {
    case Profile::groove:
      return inside;
    case Profile::hollow: {
      constexpr double pi = std::numbers::pi;
      return inside / 2 + tool.radius / (2 * pi) * std::sin(pi * inside / tool.radius);
    }
  }
  return 0.0;
}

}  // namespace

std::vector<Tool> read_tools(const std::vector<std::string>& texts) {
  std::vector<Tool> tools;
  tools.reserve(texts.size());
  for (const std::string& text : texts) {
    tools.push_back(read_tool(text));
  }
  if (tools.empty()) {
    throw std::runtime_error("--tools needs a tool, e.g. router:0.006");
  }
  return tools;
}

Radii suitable_radii(double length) {
  constexpr double fewest_strips = 4;  // in a cut
  return {fewest_strips / 2 * length / Strips::count, length / 2};
}

void require_suitable_radii(const std::vector<Tool>& tools, double length) {
  const auto [least, most] = suitable_radii(length);
  for (const Tool& tool : tools) {
    if (tool.radius < least || tool.radius > most) {
      throw std::runtime_error(
          fmt::format("--tools: {}:{:g} does not suit this body, which is {:.4g} m long: its radius must be between "
                      "{:.4g} and {:.4g} m",
                      tool.name, tool.radius, length, least, most));
    }
  }
}

double doubt_of(const Tool& tool, double thinnest) {
  constexpr double narrow_error = 0.15;
  return 2 * tool.radius < thinnest ? narrow_error : 0.0;
}

std::vector<Tool> doubt_narrow_tools(std::vector<Tool>& tools, double thinnest) {
  std::vector<Tool> narrow;
  for (Tool& tool : tools) {
    if (const double doubt = doubt_of(tool, thinnest); doubt > 0) {
      tool.slope_error = doubt;
      narrow.push_back(tool);
    }
  }
  return narrow;
}

double depth_share(const Tool& tool, double distance) {
  const double share = std::abs(distance) / tool.radius;
  if (share >= 1) {
    return 0.0;
  }
  switch (tool.profile) {
    case Profile::groove:
      return 1.0;
    case Profile::hollow:
      return std::pow(std::cos(std::numbers::pi * share / 2), 2);
  }
  return 0.0;
}

double mean_depth_share(const Tool& tool, double from, double to) {
  return (integral_to(tool, to) - integral_to(tool, from)) / (to - from);
}

}  // namespace idiophone::bench
