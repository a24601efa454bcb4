#include "tuning_answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "idiophone/run/loop/facts.hpp"

namespace idiophone::app {

namespace {

using fitting::AvoidedBand;
using fitting::TunedDecay;
using fitting::TunedLevel;
using fitting::TunedMode;
using fitting::Tuning;
using fitting::Variable;
using fitting::WantedLevel;

/// The part of a key after its last point.
std::string short_name(const std::string& key) {
  return key.substr(key.rfind('.') + 1);
}

/// "lower" or "upper"; empty for a value between its bounds.
std::string bound_text(fitting::Bound bound) {
  switch (bound) {
    case fitting::Bound::none:
      return "";
    case fitting::Bound::lower:
      return "lower";
    case fitting::Bound::upper:
      return "upper";
  }
  return "";
}

/// Of a row of a table, per 0.001 of each variable.
void print_sensitivities(const std::vector<double>& sensitivities, int digits) {
  for (const double sensitivity : sensitivities) {
    fmt::print("  {:>12}", std::isnan(sensitivity) ? "-" : fmt::format("{:+.{}f}", sensitivity * 1e-3, digits));
  }
}

void print_values(const Tuning& tuning, const std::vector<Variable>& variables) {
  fmt::print("{:<40}  {:>12}  {:>12}\n", "key", "start", "tuned");
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const std::string bound = bound_text(tuning.bounds[i]);
    fmt::print("{:<40}  {:>12.6g}  {:>12.6g}{}\n", variables[i].key, variables[i].start, tuning.values[i],
               bound.empty() ? "" : fmt::format("  on its {} bound", bound));
  }
}

void print_modes(const Tuning& tuning, const std::vector<Variable>& variables) {
  fmt::print("\n{:>10}  {:>4}  {:>12}  {:>12}  {:>10}  {:>12}  {:>7}  {:>10}", "start mode", "mode", "start/Hz",
             "frequency/Hz", "mesh/cents", "wanted/Hz", "cents", "similarity");
  for (const Variable& variable : variables) {
    fmt::print("  {:>12}", short_name(variable.key));
  }
  fmt::print("  kind\n");
  for (std::size_t m = 0; m < tuning.modes.size(); ++m) {
    const TunedMode& mode = tuning.modes[m];
    fmt::print("{:>10}  {:>4}  {:>12.4f}  {:>12.4f}  {:>10}  {:>12.4f}  {:>+7.2f}  {:>10.3f}", mode.start_mode,
               mode.mode, mode.start, mode.frequency,
               std::isnan(mode.mesh_error) ? "-" : fmt::format("{:+.1f}", mode.mesh_error), mode.wanted, mode.cents,
               mode.similarity);
    print_sensitivities(tuning.sensitivities[m], 3);
    fmt::print("  {}\n", mode.kind);
  }
  fmt::print(
      "(mesh: so much the mesh makes the frequency too high, estimated; under each key: cents per 0.001, so cents per "
      "millimetre for a length)\n");
}

void print_decays(const Tuning& tuning, const std::vector<Variable>& variables) {
  if (tuning.decays.empty()) {
    return;
  }
  fmt::print("\n{:>10}  {:>4}  {:>12}  {:>12}  {:>12}  {:>8}", "start mode", "mode", "start/s", "decay time/s",
             "wanted/s", "percent");
  for (const Variable& variable : variables) {
    fmt::print("  {:>12}", short_name(variable.key));
  }
  fmt::print("\n");
  for (const TunedDecay& decay : tuning.decays) {
    fmt::print("{:>10}  {:>4}  {:>12.4g}  {:>12.4g}  {:>12.4g}  {:>+8.2f}", decay.start_mode, decay.mode, decay.start,
               decay.decay_time, decay.wanted, decay.percent);
    print_sensitivities(decay.sensitivities, 3);
    fmt::print("\n");
  }
  fmt::print("(decay time: T60, by the material and the supports, without air; under each key: percent per 0.001)\n");
}

/// "at least 70 dB"
std::string wanted_text(const WantedLevel& wanted) {
  switch (wanted.kind) {
    case WantedLevel::Kind::equal:
      return fmt::format("{:g} dB", wanted.level);
    case WantedLevel::Kind::at_least:
      return fmt::format("at least {:g} dB", wanted.level);
    case WantedLevel::Kind::at_most:
      return fmt::format("at most {:g} dB", wanted.level);
  }
  return "";
}

void print_levels(const Tuning& tuning, const std::vector<Variable>& variables) {
  if (tuning.levels.empty()) {
    return;
  }
  fmt::print("\n{:<16}  {:>12}  {:>12}  {:>16}", "listener", "start/dB", "LAE/dB", "wanted");
  for (const Variable& variable : variables) {
    fmt::print("  {:>12}", short_name(variable.key));
  }
  fmt::print("\n");
  for (const TunedLevel& level : tuning.levels) {
    fmt::print("{:<16}  {:>12.2f}  {:>12.2f}  {:>16}", level.wanted.listener, level.start, level.level,
               wanted_text(level.wanted));
    print_sensitivities(level.sensitivities, 4);
    fmt::print("\n");
  }
  fmt::print(
      "(LAE: A-weighted sound exposure level of the deck's blows, re 20 uPa; under each key: dB per 0.001, 0 beyond a "
      "limit)\n");
}

/// "equal", "at_least" or "at_most".
std::string kind_text(WantedLevel::Kind kind) {
  switch (kind) {
    case WantedLevel::Kind::equal:
      return "equal";
    case WantedLevel::Kind::at_least:
      return "at_least";
    case WantedLevel::Kind::at_most:
      return "at_most";
  }
  return "";
}

/// "mode 3 at 401.20 Hz, mode 4 at 410.00 Hz"
std::string modes_in(const AvoidedBand& avoided) {
  std::vector<std::string> modes;
  for (std::size_t i = 0; i < avoided.modes.size(); ++i) {
    modes.push_back(fmt::format("mode {} at {:.2f} Hz", avoided.modes[i], avoided.frequencies[i]));
  }
  return fmt::format("{}", fmt::join(modes, ", "));
}

void print_avoided(const Tuning& tuning) {
  for (const AvoidedBand& avoided : tuning.avoided) {
    fmt::print("\nbetween {:.2f} and {:.2f} Hz: {}\n", avoided.band.lower, avoided.band.upper,
               avoided.modes.empty() ? "no mode" : modes_in(avoided));
  }
}

void print_in_tune(const InTune& in_tune, const std::vector<TunedMode>& modes) {
  fmt::print("\n{:.1f} % of the bodies are within {:g} cents\n{:<40}  {:>12}  {:>12}", 100 * in_tune.yield.share,
             in_tune.within, "scatter", "mean", "deviation");
  for (const TunedMode& mode : modes) {
    fmt::print("  {:>9}", fmt::format("mode {}", mode.mode));
  }
  fmt::print("\n");
  for (std::size_t i = 0; i < in_tune.scatters.size(); ++i) {
    const fitting::Scatter& scatter = in_tune.scatters[i];
    fmt::print("{:<40}  {:>12.6g}  {:>12.6g}", scatter.key, scatter.mean, scatter.deviation);
    for (const std::vector<double>& effects : in_tune.yield.effects) {
      fmt::print("  {:>+9.2f}", effects[i]);
    }
    fmt::print("\n");
  }
  fmt::print("{:<68}", "all together");
  for (const double deviation : in_tune.yield.deviations) {
    fmt::print("  {:>9.2f}", deviation);
  }
  fmt::print("\n(under each mode: cents for one standard deviation)\n");
}

/// @param values  [variables] null for NaN
nlohmann::json by_key(const std::vector<double>& values, const std::vector<Variable>& variables) {
  nlohmann::json object = nlohmann::json::object();
  for (std::size_t i = 0; i < variables.size(); ++i) {
    object[variables[i].key] = loop::number_or_null(values[i]);
  }
  return object;
}

nlohmann::json to_json(const InTune& in_tune, const std::vector<TunedMode>& modes) {
  nlohmann::json answer = {{"share", in_tune.yield.share},
                           {"within", in_tune.within},
                           {"scatter", nlohmann::json::object()},
                           {"modes", nlohmann::json::array()}};
  for (const fitting::Scatter& scatter : in_tune.scatters) {
    answer["scatter"][scatter.key] = {{"mean", scatter.mean}, {"deviation", scatter.deviation}};
  }
  for (std::size_t m = 0; m < modes.size(); ++m) {
    nlohmann::json effects = nlohmann::json::object();
    for (std::size_t i = 0; i < in_tune.scatters.size(); ++i) {
      effects[in_tune.scatters[i].key] = in_tune.yield.effects[m][i];
    }
    answer["modes"].push_back(
        {{"mode", modes[m].mode}, {"deviation", in_tune.yield.deviations[m]}, {"effects", effects}});
  }
  return answer;
}

}  // namespace

void print(const TuningAnswer& answer) {
  print_values(answer.tuning, answer.variables);
  print_modes(answer.tuning, answer.variables);
  print_decays(answer.tuning, answer.variables);
  print_levels(answer.tuning, answer.variables);
  print_avoided(answer.tuning);
  if (answer.in_tune) {
    print_in_tune(*answer.in_tune, answer.tuning.modes);
  }
}

nlohmann::json to_json(const TuningAnswer& answer) {
  const auto& [tuning, variables, in_tune] = answer;
  nlohmann::json facts = {{"tuned", tuning.is_tuned},           {"stopped", tuning.stopped},
                          {"bounds", nlohmann::json::object()}, {"solves", tuning.solves},
                          {"values", nlohmann::json::object()}, {"modes", nlohmann::json::array()}};
  for (std::size_t i = 0; i < variables.size(); ++i) {
    facts["values"][variables[i].key] = tuning.values[i];
    const std::string bound = bound_text(tuning.bounds[i]);
    facts["bounds"][variables[i].key] = bound.empty() ? nlohmann::json() : nlohmann::json(bound);
  }
  for (std::size_t m = 0; m < tuning.modes.size(); ++m) {
    const TunedMode& mode = tuning.modes[m];
    nlohmann::json entry = {{"start_mode", mode.start_mode},
                            {"mode", mode.mode},
                            {"start", mode.start},
                            {"frequency", mode.frequency},
                            {"wanted", mode.wanted},
                            {"cents", mode.cents},
                            {"similarity", mode.similarity},
                            {"sensitivities", by_key(tuning.sensitivities[m], variables)},
                            {"mesh_error", loop::number_or_null(mode.mesh_error)},
                            {"kind", mode.kind}};
    facts["modes"].push_back(entry);
  }
  facts["decays"] = nlohmann::json::array();
  for (const TunedDecay& decay : tuning.decays) {
    facts["decays"].push_back({{"start_mode", decay.start_mode},
                               {"mode", decay.mode},
                               {"start", decay.start},
                               {"decay_time", decay.decay_time},
                               {"wanted", decay.wanted},
                               {"percent", decay.percent},
                               {"sensitivities", by_key(decay.sensitivities, variables)}});
  }
  facts["levels"] = nlohmann::json::array();
  for (const TunedLevel& level : tuning.levels) {
    facts["levels"].push_back({{"listener", level.wanted.listener},
                               {"kind", kind_text(level.wanted.kind)},
                               {"start", level.start},
                               {"level", level.level},
                               {"wanted", level.wanted.level},
                               {"reached", level.is_reached},
                               {"sensitivities", by_key(level.sensitivities, variables)}});
  }
  facts["avoided"] = nlohmann::json::array();
  for (const AvoidedBand& avoided : tuning.avoided) {
    facts["avoided"].push_back({{"lower", avoided.band.lower},
                                {"upper", avoided.band.upper},
                                {"modes", avoided.modes},
                                {"frequencies", avoided.frequencies}});
  }
  facts["in_tune"] = in_tune ? to_json(*in_tune, tuning.modes) : nlohmann::json();
  return facts;
}

std::string missed_remark(const Tuning& tuning, double tolerance, double decay_tolerance) {
  std::vector<std::string> missed;
  if (std::ranges::any_of(tuning.modes, [&](const TunedMode& mode) { return std::abs(mode.cents) > tolerance; })) {
    missed.push_back(fmt::format("not all modes are within {:g} cents", tolerance));
  }
  for (const TunedDecay& decay : tuning.decays) {
    if (std::abs(std::log(decay.decay_time / decay.wanted)) > decay_tolerance / 100) {
      missed.push_back(
          fmt::format("mode {} decays in {:.4g} s instead of {:.4g} s", decay.mode, decay.decay_time, decay.wanted));
    }
  }
  for (const TunedLevel& level : tuning.levels) {
    if (!level.is_reached) {
      missed.push_back(fmt::format("the blows have {:.1f} dB at {} instead of {}", level.level, level.wanted.listener,
                                   wanted_text(level.wanted)));
    }
  }
  for (const AvoidedBand& avoided : tuning.avoided) {
    if (!avoided.modes.empty()) {
      missed.push_back(fmt::format("between {:.2f} and {:.2f} Hz there is {}", avoided.band.lower, avoided.band.upper,
                                   modes_in(avoided)));
    }
  }
  return missed.empty() ? "several modes are too near to a band that is to be avoided"
                        : fmt::format("{}", fmt::join(missed, ", and "));
}

std::string bounds_remark(const Tuning& tuning, const std::vector<Variable>& variables) {
  std::vector<std::string> stuck;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (const std::string bound = bound_text(tuning.bounds[i]); !bound.empty()) {
      stuck.push_back(fmt::format("{} ({} bound)", variables[i].key, bound));
    }
  }
  return stuck.empty() ? "" : fmt::format(". On a bound: {}", fmt::join(stuck, ", "));
}

}  // namespace idiophone::app
