// `idiophone tune`: numbers of a deck that give modes wanted frequencies.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "answer.hpp"
#include "command.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/study/fitting/deck_numbers.hpp"
#include "idiophone/study/fitting/tuning.hpp"
#include "search_watch.hpp"
#include "target_options.hpp"
#include "tuning_answer.hpp"

namespace idiophone::app {

namespace {

struct TuneOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output;  ///< tuned deck to write, if any
  std::string body;              ///< empty for the first
  TargetOptions target;
  std::vector<std::string> vary;     ///< KEY=LOWEST:HIGHEST
  double tolerance = 2.0;            ///< cents
  std::vector<std::string> decays;   ///< MODE=SECONDS
  double decay_tolerance = 5.0;      ///< percent
  std::vector<std::string> levels;   ///< LISTENER=DB, LISTENER=at_least:DB or LISTENER=at_most:DB
  double level_tolerance = 0.5;      ///< dB
  std::vector<std::string> avoided;  ///< LOWEST:HIGHEST or MIDDLE~CENTS
  std::vector<std::string> scatter;  ///< KEY=DEVIATION
  double within = 5.0;               ///< cents, of a body that is in tune
  eigenmodes::MassMatrix mass = eigenmodes::MassMatrix::lumped;
  Style style = Style::text;
};

void declare(CLI::App& app, TuneOptions& options) {
  add_deck(app, options.deck, options.overrides);
  add_target(app, options.target);
  app.add_option("--vary", options.vary,
                 "KEY=LOWEST:HIGHEST: number of the deck that may be changed; may be given again")
      ->required()
      ->take_all()
      ->expected(1);
  add_renamed(app, "--modes", "--mode-numbers");
  add_body(app, options.body);
  app.add_option("--tolerance", options.tolerance, "cents")->capture_default_str();
  app.add_option("--decay-time", options.decays,
                 "MODE=SECONDS: decay time (T60) of a mode, by its number at the start; may be given again")
      ->take_all()
      ->expected(1);
  app.add_option("--decay-tolerance", options.decay_tolerance, "percent, of decay times")->capture_default_str();
  app.add_option("--level", options.levels,
                 "LISTENER=DB, LISTENER=at_least:DB or LISTENER=at_most:DB: A-weighted sound exposure level (LAE) of "
                 "the deck's blows at a listener; may be given again")
      ->take_all()
      ->expected(1);
  app.add_option("--level-tolerance", options.level_tolerance, "dB, of levels")->capture_default_str();
  app.add_option("--avoid", options.avoided,
                 "LOWEST:HIGHEST, Hz or notes, or A4~50, a distance in cents: where no mode shall be; may be given "
                 "again")
      ->take_all()
      ->expected(1);
  app.add_option(
         "--scatter", options.scatter,
         "KEY=DEVIATION: standard deviation of a number from body to body, or in percent (=2%), for the yield; may "
         "be given again")
      ->take_all()
      ->expected(1);
  app.add_option("--within", options.within, "cents, at which a body counts as in tune for the yield")
      ->capture_default_str();
  add_mass(app, options.mass, "lumped, as the motion has it, or consistent");
  add_output_file(app, options.output, "the tuned deck to write");
  add_json(app, options.style);
}

using fitting::Tuning;
using fitting::Variable;

void check_tune(const TuneOptions& options) {
  if (!(options.tolerance > 0 && std::isfinite(options.tolerance))) {
    throw std::runtime_error(fmt::format("--tolerance must be above 0 cents, not {}", options.tolerance));
  }
  if (!(options.decay_tolerance > 0 && std::isfinite(options.decay_tolerance))) {
    throw std::runtime_error(fmt::format("--decay-tolerance must be above 0 percent, not {}", options.decay_tolerance));
  }
  if (!(options.level_tolerance > 0 && std::isfinite(options.level_tolerance))) {
    throw std::runtime_error(fmt::format("--level-tolerance must be above 0 dB, not {}", options.level_tolerance));
  }
  if (!(options.within > 0 && std::isfinite(options.within))) {
    throw std::runtime_error(fmt::format("--within must be above 0 cents, not {}", options.within));
  }
}

/// @tparam Number  Variable or fitting::Scatter
template <class Number>
std::vector<std::string> overrides_with(const std::vector<std::string>& overrides, const std::vector<Number>& numbers,
                                        const std::vector<double>& values) {
  std::vector<std::string> all = overrides;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    all.push_back(fmt::format("{}={:.12g}", numbers[i].key, values[i]));
  }
  return all;
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

/// Says what is not as it was wanted. @return the exit status
int judge(const TuningAnswer& answer, const TuneOptions& options) {
  const Tuning& tuning = answer.tuning;
  if (tuning.is_tuned && (answer.in_tune || options.scatter.empty())) {
    return loop::exit_finished;
  }
  if (tuning.is_tuned) {
    spdlog::error("stopped before it was known how many bodies are in tune");
    return loop::exit_resumable;
  }
  if (tuning.stopped) {
    spdlog::error("stopped after {} eigenvalue problems: the values are the best ones so far", tuning.solves);
    return loop::exit_resumable;
  }
  spdlog::error("{}; vary more numbers, or widen their bounds{}{}{}",
                missed_remark(tuning, options.tolerance, options.decay_tolerance),
                bounds_remark(tuning, answer.variables),
                tuning.refusal.empty() ? "" : ". The last shape that was refused: ", tuning.refusal);
  return loop::exit_failed;
}

/// @throws std::runtime_error for a text with another form, and a mode that is given twice
std::vector<fitting::WantedDecay> wanted_decays(const std::vector<std::string>& texts) {
  std::vector<fitting::WantedDecay> decays;
  for (const std::string& text : texts) {
    decays.push_back(fitting::read_wanted_decay(text));
    if (std::ranges::count(decays, decays.back().mode, &fitting::WantedDecay::mode) > 1) {
      throw std::runtime_error(fmt::format("--decay-time {}: this mode is given twice", text));
    }
  }
  return decays;
}

/// What a search shall reach.
fitting::TuningOptions tuning_options(const TuneOptions& options, const fitting::Target& target) {
  fitting::TuningOptions wanted{.modes = modes_to_tune(options.target, target),
                                .tolerance = options.tolerance,
                                .decays = wanted_decays(options.decays),
                                .decay_tolerance = options.decay_tolerance,
                                .level_tolerance = options.level_tolerance,
                                .body = options.body,
                                .mass = options.mass};
  std::ranges::transform(options.levels, std::back_inserter(wanted.levels), fitting::read_wanted_level);
  std::ranges::transform(options.avoided, std::back_inserter(wanted.avoided),
                         [&](const std::string& text) { return fitting::read_band(text, options.target.a4); });
  return wanted;
}

/// What the command computes of a deck, and shows how far it is.
struct Work {
  const TuneOptions& options;
  const fitting::Target& target;
  loop::PieceProgress progress = search_progress(options.style);

  /// The scene with values of numbers, for which the deck has others.
  template <class Number>
  [[nodiscard]] fitting::SceneOf scene_of(const std::vector<std::string>& overrides,
                                          const std::vector<Number>& numbers) const {
    return [&deck = options.deck, overrides, numbers](const std::vector<double>& values) {
      return scene::read_deck(deck, overrides_with(overrides, numbers, values));
    };
  }

  [[nodiscard]] Tuning tuned(const std::vector<Variable>& variables) {
    fitting::TuningOptions wanted = tuning_options(options, target);
    wanted.watch = watch_by(progress);
    return fitting::tune(scene_of(options.overrides, variables), variables, target, wanted);
  }

  /// Of the tuned shape; none without numbers that scatter, and where a signal ended the work.
  [[nodiscard]] std::optional<InTune> in_tune(const Tuning& tuning, const std::vector<Variable>& variables) {
    if (options.scatter.empty() || tuning.stopped) {
      return {};
    }
    const std::vector<std::string> overrides = overrides_with(options.overrides, variables, tuning.values);
    std::vector<fitting::Scatter> scatters = fitting::read_scatters(options.scatter, options.deck, overrides);
    std::vector<int> modes;
    std::ranges::transform(tuning.modes, std::back_inserter(modes), &fitting::TunedMode::mode);
    std::optional yield = fitting::yield_of(scene_of(overrides, scatters), scatters, target,
                                            {.modes = modes,
                                             .within = options.within,
                                             .body = options.body,
                                             .mass = options.mass,
                                             .watch = watch_by(progress)});
    return yield ? std::optional(InTune{std::move(scatters), options.within, std::move(*yield)}) : std::nullopt;
  }
};

int tune(const TuneOptions& options) {
  check_tune(options);
  const fitting::Target target = target_of(options.target);
  const std::vector<Variable> variables = fitting::read_variables(options.vary, options.deck, options.overrides);
  static_cast<void>(fitting::read_scatters(options.scatter, options.deck, options.overrides));  // mistakes come first
  const auto [tuning, in_tune] = [&] {
    Work work{options, target};
    Tuning found = work.tuned(variables);
    std::optional<InTune> share = work.in_tune(found, variables);
    return std::pair(std::move(found), std::move(share));
  }();
  const TuningAnswer answer{tuning, variables, in_tune};
  if (options.style == Style::json) {
    print_answer(to_json(answer));
  } else {
    print(answer);
  }
  if (!options.output.empty()) {
    write_deck(options, tuning, variables);
  }
  return judge(answer, options);
}

}  // namespace

Command tune_command() {
  return make_command<TuneOptions>("tune", "find numbers of a deck that give its modes wanted frequencies", Ranks::one,
                                   declare, tune);
}

}  // namespace idiophone::app
