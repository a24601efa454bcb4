// What `idiophone identify` answers.

#include "identification_answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "idiophone/run/loop/facts.hpp"
#include "idiophone/scene/euler_angles.hpp"
#include "materials_section.hpp"

namespace idiophone::app {

namespace {

using fitting::AssignedLine;
using fitting::FurtherLine;
using fitting::FurtherSize;
using fitting::Identification;
using fitting::IdentifiedConstant;

nlohmann::json coordinates(const Vector3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

/// "3", or "3-4" for two modes of one frequency.
std::string mode_text(int first, int count) {
  return count == 1 ? fmt::format("{}", first) : fmt::format("{}-{}", first, first + count - 1);
}

void print_constants(const Identification& found) {
  fmt::print("{:<12}  {:>12}  {:>12}  {:>12}\n", "constant", "value", "+- (95 %)", "in the deck");
  for (const IdentifiedConstant& constant : found.constants) {
    fmt::print("{:<12}  {:>12.6g}  {:>12.3g}  {:>12.6g}{}\n", constant.name, constant.value, constant.half_width,
               constant.start, constant.determined ? "" : "  not determined");
  }
}

void print_equivalent_turns(const Identification& found) {
  if (!found.equivalent_turns.empty()) {
    fmt::print("the lines fit as well, by the symmetry of the body, with turns about x, y, z by\n");
  }
  for (const Vector3& turns : found.equivalent_turns) {
    fmt::print("{:>12.4f}, {:.4f}, {:.4f} degrees\n", turns[0], turns[1], turns[2]);
  }
}

/// The key grain of the body in a deck; empty where no turns were fitted.
std::string grain_section(const Identification& found, const std::string& body) {
  if (!found.grain) {
    return {};
  }
  return fmt::format("bodies:\n  {}:\n    grain: {{euler: [{:.4f}]}}\n", body,
                     fmt::join(scene::euler_angles(*found.grain), ", "));
}

void print_lines(const Identification& found) {
  fmt::print("\n{:>4}  {:>13}  {:>7}  {:>13}  {:>7}\n", "line", "measured/Hz", "mode", "computed/Hz", "cents");
  int number = 0;
  for (const AssignedLine& line : found.lines) {
    fmt::print("{:>4}  {:>13.3f}  ", ++number, line.line.frequency);
    if (line.modes == 0) {
      fmt::print("{:>7}  {:>13}  {:>7}\n", "-", "false line", "-");
    } else {
      fmt::print("{:>7}  {:>13.3f}  {:>+7.2f}{}\n", mode_text(line.first_mode, line.modes), line.computed, line.cents,
                 line.is_split    ? "  split"
                 : line.is_fitted ? ""
                                  : "  predicted");
    }
  }
  for (const auto& [first, count, frequency] : found.missing) {
    fmt::print("{:>4}  {:>13}  {:>7}  {:>13.3f}  {:>7}\n", "-", "not measured", mode_text(first, count), frequency,
               "-");
  }
  if (found.fitted_rms) {
    fmt::print("rms of the fitted lines: {:.2f} cents; chi-squared: {:.1f} of {} degrees of freedom\n",
               *found.fitted_rms, found.chi_squared, found.freedom);
  }
  if (found.tested_rms) {
    fmt::print("rms of the predicted lines: {:.2f} cents\n", *found.tested_rms);
  }
}

void print_further_lines(const Identification& found) {
  if (found.further.empty()) {
    return;
  }
  fmt::print(
      "\nfurther lines, each with the interval of the constant that it would leave:\n{:<12}  {:>7}  {:>13}  {:>12}  "
      "{}\n",
      "constant", "mode", "computed/Hz", "+- (95 %)", "strike or listen at/m, along");
  for (const FurtherLine& line : found.further) {
    fmt::print("{:<12}  {:>7}  {:>13.3f}  {:>12.3g}  [{:.4g}], [{:.2f}]\n", line.constant,
               mode_text(line.first_mode, line.modes), line.frequency, line.half_width, fmt::join(line.place, ", "),
               fmt::join(line.direction, ", "));
  }
}

void print_further_sizes(const Identification& found) {
  if (found.sizes.empty()) {
    return;
  }
  fmt::print(
      "\nother specimens, each with the interval of the constant that its lowest lines would leave by themselves:\n"
      "{:<12}  {:>5}  {:>13}  {:>12}  {}\n",
      "constant", "lines", "up to/Hz", "+- (95 %)", "size/m");
  for (const FurtherSize& size : found.sizes) {
    fmt::print("{:<12}  {:>5}  {:>13.3f}  {:>12.3g}  {:.4g}: {:g} times as long along [{:.2f}]\n", size.constant,
               size.lines, size.highest, size.half_width, fmt::join(size.extents, " x "), size.factor,
               fmt::join(size.along, ", "));
  }
}

}  // namespace

void print(const Identification& found, const std::string& body) {
  print_constants(found);
  print_equivalent_turns(found);
  print_lines(found);
  print_further_lines(found);
  print_further_sizes(found);
  fmt::print("\n{}{}", materials_section(found.material), grain_section(found, body));
}

nlohmann::json identification_facts(const Identification& found) {
  nlohmann::json answer = {{"accepted", found.doubts.empty()},
                           {"stopped", found.stopped},
                           {"doubts", found.doubts},
                           {"volume", found.volume},
                           {"density", found.material.density},
                           {"solves", found.solves},
                           {"constants", nlohmann::json::object()},
                           {"lines", nlohmann::json::array()},
                           {"not_measured", nlohmann::json::array()},
                           {"further_lines", nlohmann::json::array()},
                           {"further_sizes", nlohmann::json::array()},
                           {"fitted_rms", loop::number_or_null(found.fitted_rms.value_or(NAN))},
                           {"chi_squared", found.chi_squared},
                           {"degrees_of_freedom", found.freedom},
                           {"predicted_rms", loop::number_or_null(found.tested_rms.value_or(NAN))},
                           {"materials", materials_section(found.material)},
                           {"grain", nullptr},
                           {"equivalent_turns", nlohmann::json::array()}};
  if (found.grain) {
    answer["grain"] = {{"euler", coordinates(scene::euler_angles(*found.grain))}};
  }
  for (const Vector3& turns : found.equivalent_turns) {
    answer["equivalent_turns"].push_back(coordinates(turns));
  }
  for (const IdentifiedConstant& constant : found.constants) {
    answer["constants"][constant.name] = {{"value", constant.value},
                                          {"half_width", loop::number_or_null(constant.half_width)},
                                          {"in_the_deck", constant.start},
                                          {"determined", constant.determined},
                                          {"would_be_determined", constant.would_be_determined},
                                          {"has_no_effect", constant.has_no_effect}};
  }
  for (const AssignedLine& line : found.lines) {
    nlohmann::json entry = {{"measured", line.line.frequency},
                            {"mode", nullptr},
                            {"fitted", line.is_fitted},
                            {"split", line.is_split},
                            {"mesh_error", line.is_fitted ? nlohmann::json(line.mesh_error) : nlohmann::json()}};
    if (line.modes > 0) {
      entry["mode"] = line.first_mode;
      entry["modes"] = line.modes;
      entry["computed"] = line.computed;
      entry["cents"] = line.cents;
    }
    answer["lines"].push_back(entry);
  }
  for (const FurtherLine& line : found.further) {
    answer["further_lines"].push_back({{"constant", line.constant},
                                       {"mode", line.first_mode},
                                       {"modes", line.modes},
                                       {"frequency", line.frequency},
                                       {"half_width", line.half_width},
                                       {"at", coordinates(line.place)},
                                       {"along", coordinates(line.direction)}});
  }
  for (const FurtherSize& size : found.sizes) {
    answer["further_sizes"].push_back({{"constant", size.constant},
                                       {"factor", size.factor},
                                       {"along", coordinates(size.along)},
                                       {"size", coordinates(size.extents)},
                                       {"lines", size.lines},
                                       {"up_to", size.highest},
                                       {"half_width", size.half_width},
                                       {"determined", size.is_determined}});
  }
  for (const auto& [first, count, frequency] : found.missing) {
    answer["not_measured"].push_back({{"mode", first}, {"modes", count}, {"frequency", frequency}});
  }
  return answer;
}

}  // namespace idiophone::app
