// `idiophone evolve`: breeds timbre trees, by ear or towards a sound.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "answer.hpp"
#include "command.hpp"
#include "idiophone/foundation/markup.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/text_file.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/loop/wav_files.hpp"
#include "idiophone/timbre/evolution/evolution.hpp"

namespace idiophone::app {

namespace {

struct EvolveOptions {
  std::vector<std::filesystem::path> trees;  ///< the ancestors
  std::filesystem::path target;              ///< WAV file to imitate; empty for selection by ear
  std::filesystem::path output = "evolved.tt";
  std::filesystem::path page;  ///< to select by ear; empty with a target
  bool constants = false;      ///< change numbers only
  int population = 40;
  int generations = 40;
  int nodes = 100;  ///< of a tree, at most
  int seed = 1;
  double duration = 2.0;  ///< of a sound on the page, s
  Style style = Style::text;
};

void declare(CLI::App& app, EvolveOptions& options) {
  app.add_option("trees", options.trees, "timbre trees that the others descend from")->required();
  CLI::Option* target =
      app.add_option("--target", options.target, "sound file with one channel that is to be imitated");
  add_output_file(app, options.output, "the tree to write, with a target");
  add_json(app, options.style);
  app.add_option("--page", options.page, "web page to write, on which trees are selected by ear")->excludes(target);
  app.add_option("--duration", options.duration, "s: of a sound on the page")
      ->check(CLI::Range(0.1, 60.0))
      ->capture_default_str();
  app.add_flag("--constants", options.constants, "change numbers only, not the nodes");
  app.add_option("--population", options.population, "trees of a generation")
      ->check(CLI::Range(2, 10000))
      ->capture_default_str();
  app.add_option("--generations", options.generations, "with a target")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_option("--nodes", options.nodes, "numbers, names and lists of a tree, at most")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "of all chance")->capture_default_str();
}

constexpr int rate_of_bred_sounds = 44100;

timbre::BreedingOptions breeding(const EvolveOptions& options) {
  return {.change = options.constants ? timbre::Change::constants : timbre::Change::everything,
          .population = static_cast<std::size_t>(options.population),
          .generations = options.generations,
          .most_nodes = static_cast<std::size_t>(options.nodes),
          .seed = static_cast<std::uint64_t>(options.seed)};
}

/// Number, generation, parents, change, distance and tree of each.
std::string ancestry_table(const std::vector<timbre::Descendant>& trees) {
  std::string table = "number,generation,parents,change,distance_dB,tree\n";
  for (const timbre::Descendant& tree : trees) {
    std::string line = tree.tree;
    std::ranges::replace(line, '\n', ' ');
    std::string quoted;
    for (const char letter : line) {
      quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    table += fmt::format("{},{},{},{},{:.6g},\"{}\"\n", tree.number, tree.generation, fmt::join(tree.parents, " "),
                         tree.change, tree.distance, quoted);
  }
  return table;
}

void imitate(const EvolveOptions& options) {
  const timbre::Target target = timbre::read_target(options.target, rate_of_bred_sounds);
  const bool root = parallel::is_root(MPI_COMM_WORLD);
  const timbre::Evolved evolved =
      timbre::evolve(options.trees, target, breeding(options), MPI_COMM_WORLD, [&](int generation, double distance) {
        if (root && generation % 10 == 0) {
          spdlog::info("generation {}: {:.4g} dB", generation, distance);
        }
      });
  parallel::on_root(MPI_COMM_WORLD, [&] {
    std::filesystem::path ancestry = options.output;
    ancestry.replace_extension(".ancestry.csv");
    write_text(options.output, evolved.best.tree);
    write_text(ancestry, ancestry_table(evolved.ancestry));
    if (options.style == Style::json) {
      const nlohmann::json answer = {{"tree", options.output.string()},
                                     {"distance", evolved.best.distance},
                                     {"ancestor_distance", evolved.distance_before},
                                     {"ancestry", ancestry.string()}};
      print_answer(answer);
    } else {
      spdlog::info("{}: distance {:.4g} dB, of the nearest ancestor {:.4g} dB; ancestry in {}", options.output.string(),
                   evolved.best.distance, evolved.distance_before, ancestry.string());
    }
  });
}

/// Up to the rows. The mark is the page's own name. CSS has its braces twice, for fmt.
constexpr const char* page_head = R"(<!DOCTYPE html>
<html lang="en"><meta charset="utf-8"><title>Timbre trees</title>
<style>body {{ font: 16px sans-serif; margin: 2em }} pre {{ white-space: pre-wrap }} td {{ padding: 0.3em 1em; vertical-align: top }}</style>
<h1>Timbre trees</h1>
<p>Play the sounds, mark those that you like, and breed them again by this command:</p>
<pre id="command">Mark at least one sound.</pre>
<table data-next="{}_next.html">
)";

constexpr const char* page_end = R"(</table>
<script>
for (const sound of document.querySelectorAll("audio")) sound.src = encodeURIComponent(sound.dataset.file);
const inShell = name => /^[\w.+][\w.+-]*$/.test(name) ? name : `'./${name.replaceAll("'", "'\\''")}'`;
const marks = [...document.querySelectorAll("input")];
for (const mark of marks) mark.onchange = () => {
  const files = marks.filter(m => m.checked).map(m => inShell(m.value));
  document.getElementById("command").textContent = files.length === 0 ? "Mark at least one sound."
    : `idiophone evolve ${files.join(" ")} --page ${inShell(document.querySelector("table").dataset.next)} --seed ${1 + Math.floor(1e6 * Math.random())}`;
};
</script>
)";

/// The trees of the page, each with a sound of its own.
std::vector<timbre::Descendant> audible_children(const EvolveOptions& options) {
  constexpr int most_sounds = 200;
  if (options.population > most_sounds) {
    throw std::runtime_error(
        fmt::format("--population: a page has at most {} sounds; nobody chooses from more by ear", most_sounds));
  }
  std::vector<timbre::Descendant> trees =
      timbre::breed(options.trees, breeding(options), options.duration, rate_of_bred_sounds);
  const std::string advice =
      options.constants ? "breed without --constants or from more trees" : "breed from more trees or with more --nodes";
  if (trees.empty()) {
    throw std::runtime_error("no change of these trees can be heard; " + advice);
  }
  if (trees.size() < static_cast<std::size_t>(options.population)) {
    spdlog::warn("only {} of {} children sound different from their parents and siblings; {}", trees.size(),
                 options.population, advice);
  }
  return trees;
}

/// The page, and a sound and a tree beside it for each row.
void offer(const EvolveOptions& options) {
  const std::string stem = options.page.stem().string();
  const std::filesystem::path folder = options.page.parent_path();
  const std::vector<timbre::Descendant> trees = audible_children(options);
  std::string page = fmt::format(page_head, in_markup(stem));
  for (const timbre::Descendant& tree : trees) {
    const std::string name = fmt::format("{}_{:03}", stem, tree.number);
    write_text(folder / (name + ".tt"), tree.tree);
    loop::write_wav(
        folder / (name + ".wav"),
        timbre::sound_of_descendant(tree, options.trees.front().parent_path(), options.duration, rate_of_bred_sounds),
        {.rate = rate_of_bred_sounds, .full_scale = 1.0, .full_scale_key = "nothing", .unit = "1"});
    page += fmt::format(
        "<tr><td><label><input type=checkbox value=\"{0}.tt\"> {0}</label><td><audio controls "
        "data-file=\"{0}.wav\"></audio><td><pre>{1} of {2}\n{3}</pre>\n",
        in_markup(name), tree.change, fmt::join(tree.parents, " and "), in_markup(tree.tree));
  }
  write_text(options.page, page + page_end);
  if (options.style == Style::json) {
    print_answer(nlohmann::json{{"page", options.page.string()}, {"sounds", trees.size()}});
  } else {
    spdlog::info("{}: {} sounds to choose from", options.page.string(), trees.size());
  }
}

int evolve(const EvolveOptions& options) {
  if (options.target.empty() == options.page.empty()) {
    throw std::runtime_error("give --target, a sound to imitate, or --page, to select by ear");
  }
  loop::require_folder_of(options.page.empty() ? options.output : options.page);
  if (options.page.empty()) {
    imitate(options);
  } else {
    parallel::on_root(MPI_COMM_WORLD, [&] { offer(options); });
  }
  return loop::exit_finished;
}

}  // namespace

Command evolve_command() {
  return make_command<EvolveOptions>("evolve", "breed timbre trees, by ear or towards a sound", Ranks::any, declare,
                                     evolve);
}

}  // namespace idiophone::app
