// `idiophone tune`: numbers of a deck that give modes wanted frequencies.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "answer.hpp"
#include "command.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/study/fitting/deck_numbers.hpp"
#include "idiophone/study/fitting/tuning.hpp"
#include "search_watch.hpp"

namespace idiophone::app {

namespace {

struct TuneOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output;      ///< tuned deck to write, if any
  std::string body;                  ///< empty for the first
  std::string target;                ///< frequencies, notes or ratios
  std::optional<std::string> pitch;  ///< of the first of the ratios
  std::vector<std::string> vary;     ///< KEY=LOWEST:HIGHEST
  std::vector<int> modes;            ///< from 1 on; empty for the lowest
  double tolerance = 2.0;            ///< cents
  double a4 = 440.0;                 ///< Hz
  eigenmodes::MassMatrix mass = eigenmodes::MassMatrix::lumped;
  Style style = Style::text;
};

void declare(CLI::App& app, TuneOptions& options) {
  add_deck(app, options.deck, options.overrides);
  app.add_option("--target", options.target, "frequencies or notes, e.g. 187,F#5, or ratios, e.g. 1:4:10")->required();
  app.add_option("--pitch", options.pitch, "note or Hz of the first of the ratios (default: any)");
  app.add_option("--vary", options.vary,
                 "KEY=LOWEST:HIGHEST: number of the deck that may be changed; may be given again")
      ->required()
      ->take_all()
      ->expected(1);
  app.add_option("--mode-numbers", options.modes, "of the modes to tune, at the start (default: the lowest)")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_renamed(app, "--modes", "--mode-numbers");
  add_body(app, options.body);
  app.add_option("--tolerance", options.tolerance, "cents")->capture_default_str();
  app.add_option("--a4", options.a4, "Hz, of the note A4")->capture_default_str();
  add_mass(app, options.mass, "lumped, as the motion has it, or consistent");
  add_output_file(app, options.output, "the tuned deck to write");
  add_json(app, options.style);
}

using fitting::TunedMode;
using fitting::Tuning;
using fitting::Variable;

/// Reads KEY=LOW:HIGH; the deck has the start.
Variable read_variable(const std::string& text, const TuneOptions& options) {
  const auto fail = [&](const std::string& why) { throw std::runtime_error(fmt::format("--vary {}: {}", text, why)); };
  const std::size_t equals = text.find('=');
  const std::size_t colon = text.find(':', equals == std::string::npos ? 0 : equals);
  if (equals == std::string::npos || colon == std::string::npos) {
    fail("expected KEY=LOWEST:HIGHEST, e.g. bodies.bar.parameters.centre=0.003:0.01");
  }
  const auto bound = [&](std::size_t begin, std::size_t end) {
    double value = 0.0;
    const auto [rest, error] = std::from_chars(text.data() + begin, text.data() + end, value);
    if (error != std::errc{} || rest != text.data() + end || !std::isfinite(value)) {
      fail(fmt::format("'{}' is not a number", text.substr(begin, end - begin)));
    }
    return value;
  };
  Variable variable{
      .key = text.substr(0, equals), .lower = bound(equals + 1, colon), .upper = bound(colon + 1, text.size())};
  if (!(variable.lower < variable.upper)) {
    fail("the lowest value must be below the highest");
  }
  variable.start = fitting::number_at(options.deck, options.overrides, variable.key);
  if (variable.start < variable.lower || variable.start > variable.upper) {
    fail(fmt::format("the deck's value, {:g}, is not within these bounds", variable.start));
  }
  return variable;
}

std::vector<Variable> read_variables(const TuneOptions& options) {
  std::vector<Variable> variables;
  for (const std::string& text : options.vary) {
    variables.push_back(read_variable(text, options));
    const auto same = [&](const Variable& other) { return other.key == variables.back().key; };
    if (std::ranges::count_if(variables, same) > 1) {
      throw std::runtime_error(fmt::format("--vary {}: this key is varied already", text));
    }
  }
  return variables;
}

/// The modes to tune: those given, or the lowest ones.
std::vector<int> modes_to_tune(const TuneOptions& options, const fitting::Target& target) {
  std::vector<int> modes = options.modes;
  if (modes.empty()) {
    modes.resize(target.values.size());
    std::iota(modes.begin(), modes.end(), 1);
  }
  if (modes.size() != target.values.size()) {
    throw std::runtime_error(
        fmt::format("--target has {} values, but --mode-numbers {}", target.values.size(), modes.size()));
  }
  for (const int mode : modes) {
    if (mode < 1 || std::ranges::count(modes, mode) > 1) {
      throw std::runtime_error(fmt::format("--mode-numbers: {} is below 1 or given twice", mode));
    }
  }
  return modes;
}

void check_tune(const TuneOptions& options) {
  if (!(options.tolerance > 0 && std::isfinite(options.tolerance))) {
    throw std::runtime_error(fmt::format("--tolerance must be above 0 cents, not {}", options.tolerance));
  }
  if (!(options.a4 > 0 && std::isfinite(options.a4))) {
    throw std::runtime_error(fmt::format("--a4 must be above 0 Hz, not {}", options.a4));
  }
}

std::vector<std::string> overrides_with(const std::vector<std::string>& overrides,
                                        const std::vector<Variable>& variables, const std::vector<double>& values) {
  std::vector<std::string> all = overrides;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    all.push_back(fmt::format("{}={:.12g}", variables[i].key, values[i]));
  }
  return all;
}

/// The part of a key after its last point.
std::string short_name(const Variable& variable) {
  return variable.key.substr(variable.key.rfind('.') + 1);
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

void print_tuning(const Tuning& tuning, const std::vector<Variable>& variables) {
  fmt::print("{:<40}  {:>12}  {:>12}\n", "key", "start", "tuned");
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const std::string bound = bound_text(tuning.bounds[i]);
    fmt::print("{:<40}  {:>12.6g}  {:>12.6g}{}\n", variables[i].key, variables[i].start, tuning.values[i],
               bound.empty() ? "" : fmt::format("  on its {} bound", bound));
  }
  fmt::print("\n{:>10}  {:>4}  {:>12}  {:>12}  {:>10}  {:>12}  {:>7}  {:>10}", "start mode", "mode", "start/Hz",
             "frequency/Hz", "mesh/cents", "wanted/Hz", "cents", "similarity");
  for (const Variable& variable : variables) {
    fmt::print("  {:>12}", short_name(variable));
  }
  fmt::print("\n");
  for (std::size_t m = 0; m < tuning.modes.size(); ++m) {
    const TunedMode& mode = tuning.modes[m];
    fmt::print("{:>10}  {:>4}  {:>12.4f}  {:>12.4f}  {:>10}  {:>12.4f}  {:>+7.2f}  {:>10.3f}", mode.start_mode,
               mode.mode, mode.start, mode.frequency,
               std::isnan(mode.mesh_error) ? "-" : fmt::format("{:+.1f}", mode.mesh_error), mode.wanted, mode.cents,
               mode.similarity);
    for (const double sensitivity : tuning.sensitivities[m]) {
      fmt::print("  {:>+12.3f}", sensitivity * 1e-3);
    }
    fmt::print("\n");
  }
  fmt::print(
      "(mesh: so much the mesh makes the frequency too high, estimated; under each key: cents per 0.001, so cents per "
      "millimetre for a length)\n");
}

nlohmann::json tuning_facts(const Tuning& tuning, const std::vector<Variable>& variables) {
  nlohmann::json answer = {{"tuned", tuning.is_tuned},           {"stopped", tuning.stopped},
                           {"bounds", nlohmann::json::object()}, {"solves", tuning.solves},
                           {"values", nlohmann::json::object()}, {"modes", nlohmann::json::array()}};
  for (std::size_t i = 0; i < variables.size(); ++i) {
    answer["values"][variables[i].key] = tuning.values[i];
    const std::string bound = bound_text(tuning.bounds[i]);
    answer["bounds"][variables[i].key] = bound.empty() ? nlohmann::json() : nlohmann::json(bound);
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
                            {"sensitivities", nlohmann::json::object()},
                            {"mesh_error", loop::number_or_null(mode.mesh_error)}};
    for (std::size_t i = 0; i < variables.size(); ++i) {
      entry["sensitivities"][variables[i].key] = tuning.sensitivities[m][i];
    }
    answer["modes"].push_back(entry);
  }
  return answer;
}

/// Writes the deck with the tuned numbers.
void write_deck(const TuneOptions& options, const Tuning& tuning, const std::vector<Variable>& variables) {
  std::vector<std::pair<std::string, double>> numbers;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    numbers.emplace_back(variables[i].key, tuning.values[i]);
  }
  const std::string text = fitting::with_numbers(options.deck, numbers);
  if (!(std::ofstream(options.output) << text).flush()) {
    throw std::runtime_error(fmt::format("can't write {}", options.output.string()));
  }
  spdlog::info("{}: the tuned deck", options.output.string());
  if (!options.overrides.empty()) {
    spdlog::warn("{} does not have the values of --set", options.output.string());
  }
  if (std::filesystem::weakly_canonical(options.output).parent_path() !=
      std::filesystem::weakly_canonical(options.deck).parent_path()) {
    spdlog::warn("relative file names in {} start from its own folder, which is not that of {}",
                 options.output.string(), options.deck.string());
  }
}

/// The numbers that sit on a bound, as the end of a sentence; empty if none does.
std::string bounds_remark(const Tuning& tuning, const std::vector<Variable>& variables) {
  std::vector<std::string> stuck;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (const std::string bound = bound_text(tuning.bounds[i]); !bound.empty()) {
      stuck.push_back(fmt::format("{} ({} bound)", variables[i].key, bound));
    }
  }
  return stuck.empty() ? "" : fmt::format(". On a bound: {}", fmt::join(stuck, ", "));
}

/// Says what is not as it was wanted. @return the exit status
int judge(const Tuning& tuning, const std::vector<Variable>& variables, double tolerance) {
  if (tuning.is_tuned) {
    return loop::exit_finished;
  }
  if (tuning.stopped) {
    spdlog::error("stopped after {} eigenvalue problems: the values are the best ones so far", tuning.solves);
    return loop::exit_resumable;
  }
  spdlog::error("not all modes are within {:g} cents; vary more numbers, or widen their bounds{}{}{}", tolerance,
                bounds_remark(tuning, variables),
                tuning.refusal.empty() ? "" : ". The last shape that was refused: ", tuning.refusal);
  return loop::exit_failed;
}

int tune(const TuneOptions& options) {
  check_tune(options);
  const fitting::Target target = fitting::read_target(options.target, options.pitch, options.a4);
  const std::vector<int> modes = modes_to_tune(options, target);
  const std::vector<Variable> variables = read_variables(options);
  const auto scene_of = [&](const std::vector<double>& values) {
    return scene::read_deck(options.deck, overrides_with(options.overrides, variables, values));
  };
  const Tuning tuning = [&] {
    loop::PieceProgress progress = search_progress(options.style);
    return fitting::tune(scene_of, variables, target,
                         {.modes = modes,
                          .tolerance = options.tolerance,
                          .body = options.body,
                          .mass = options.mass,
                          .watch = watch_by(progress)});
  }();
  if (options.style == Style::json) {
    print_answer(tuning_facts(tuning, variables));
  } else {
    print_tuning(tuning, variables);
  }
  if (!options.output.empty()) {
    write_deck(options, tuning, variables);
  }
  return judge(tuning, variables, options.tolerance);
}

}  // namespace

Command tune_command() {
  return make_command<TuneOptions>("tune", "find numbers of a deck that give its modes wanted frequencies", Ranks::one,
                                   declare, tune);
}

}  // namespace idiophone::app
