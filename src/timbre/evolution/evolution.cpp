#include "idiophone/timbre/evolution/evolution.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "breeding.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/timbre/language/graph.hpp"
#include "known_sounds.hpp"

namespace idiophone::timbre {

namespace {

constexpr double first_spread = 0.4, last_spread = 0.004;  // of constants, over the generations

/// A descendant with its tree as such.
struct Individual {
  Descendant facts;
  Tree tree;
};

/// Whether a change of a tree, which is valid, is wanted.
using Acceptance = std::function<bool(const Tree&)>;

/// Breeds one generation after another.
class Breeder {
 public:
  Breeder(const std::vector<std::filesystem::path>& ancestors, const BreedingOptions& options, int rate)
      : options_(options), rate_(rate), dice_(options.seed) {
    for (const std::filesystem::path& file : ancestors) {
      Individual ancestor{.facts = {.number = next_number_++, .change = "ancestor"}, .tree = read_tree_file(file)};
      static_cast<void>(Graph(ancestor.tree, {}, {.rate = rate}));  // says what is wrong
      ancestor.facts.tree = to_text(ancestor.tree);
      ancestors_.push_back(std::move(ancestor));
    }
  }

  [[nodiscard]] const std::vector<Individual>& ancestors() const { return ancestors_; }

  /// Children of some parents, each drawn by chance.
  /// @param spread  of constants
  std::vector<Individual> children(
      const std::vector<Individual>& parents, std::size_t count, int generation, double spread,
      const Acceptance& accept = [](const Tree&) { return true; }) {
    std::vector<Individual> born;
    while (born.size() < count) {
      Individual child = parents[dice_.below(parents.size())];
      const int parent = child.facts.number;
      child.facts = {.number = next_number_++, .generation = generation, .parents = {parent}};
      change(child, parents, spread, accept);
      child.facts.tree = to_text(child.tree);
      born.push_back(std::move(child));
    }
    return born;
  }

 private:
  /// Changes that make no valid tree, or none that is wanted, are drawn again; after many, the child stays like its
  /// parent.
  void change(Individual& child, const std::vector<Individual>& parents, double spread, const Acceptance& accept) {
    const Tree before = child.tree;
    const int parent = child.facts.parents.front();
    const std::size_t most = std::max(options_.most_nodes, size_of(before));
    for (int attempt = 0; attempt < 30; ++attempt) {
      child.tree = before;
      child.facts.parents = {parent};
      const double kind = options_.change == Change::constants ? 0.0 : dice_.uniform();
      if (kind < 0.5) {
        child.facts.change = "constants";
        change_constants(child.tree, parents, spread);
      } else if (kind < 0.7) {
        child.facts.change = "node";
        mutate_node(child.tree, dice_);
      } else {
        const Individual& other = parents[dice_.below(parents.size())];
        child.facts.change = "crossover";
        child.facts.parents.push_back(other.facts.number);
        cross(child.tree, other.tree, dice_);
      }
      if (is_valid(child.tree, rate_, most) && accept(child.tree)) {
        return;
      }
    }
    child.tree = before;
    child.facts.change = "none";
    child.facts.parents = {parent};
  }

  void change_constants(Tree& tree, const std::vector<Individual>& parents, double spread) {
    if (dice_.uniform() < 0.5) {
      mutate_constants(tree, spread, dice_);
    } else {
      const std::size_t from = dice_.below(parents.size()), to = dice_.below(parents.size());
      mutate_by_difference(tree, parents[from].tree, parents[to].tree, dice_);
    }
  }

  BreedingOptions options_;
  int rate_;
  Dice dice_;
  int next_number_ = 0;
  std::vector<Individual> ancestors_;
};

std::vector<double> sound_of(const Tree& tree, std::size_t samples, int rate) {
  std::vector<double> sound(samples);
  Graph(tree, {}, {.rate = rate}).render(sound);
  return sound;
}

/// Infinite for a tree that does not sound.
double distance_of(const Tree& tree, const Target& target, const SoundDistance& distance) {
  try {
    return distance(sound_of(tree, target.samples.size(), target.rate));
  } catch (const std::exception&) {
    return std::numeric_limits<double>::infinity();
  }
}

/// Every rank measures its share. Collective.
void measure(std::vector<Individual>& trees, const Target& target, const SoundDistance& distance,
             MPI_Comm communicator) {
  std::vector<double> distances(trees.size());
  const auto ranks = static_cast<std::size_t>(parallel::size_of(communicator));
  for (auto i = static_cast<std::size_t>(parallel::rank_of(communicator)); i < trees.size(); i += ranks) {
    distances[i] = distance_of(trees[i].tree, target, distance);
  }
  parallel::reduce(distances, MPI_SUM, communicator);  // all ranks but one have zeros
  for (std::size_t i = 0; i < trees.size(); ++i) {
    trees[i].facts.distance = distances[i];
  }
}

bool is_nearer(const Individual& a, const Individual& b) {
  return a.facts.distance < b.facts.distance;
}

}  // namespace

std::vector<Descendant> breed(const std::vector<std::filesystem::path>& ancestors, const BreedingOptions& options,
                              double duration, int rate) {
  Breeder breeder(ancestors, options, rate);
  KnownSounds sounds(duration, rate);
  for (const Individual& ancestor : breeder.ancestors()) {
    sounds.add(ancestor.tree);
  }
  const auto is_new = [&](const Tree& tree) { return sounds.add_if_new(tree); };
  std::vector<Descendant> descendants;
  for (const Individual& child : breeder.children(breeder.ancestors(), options.population, 1, first_spread, is_new)) {
    if (child.facts.change != "none") {
      descendants.push_back(child.facts);
    }
  }
  return descendants;
}

std::vector<double> sound_of_descendant(const Descendant& descendant, const std::filesystem::path& folder,
                                        double duration, int rate) {
  std::vector<double> sound =
      sound_of(parse_tree(descendant.tree, folder / "descendant.tt"), static_cast<std::size_t>(duration * rate), rate);
  double loudest = 0.0;
  for (const double sample : sound) {
    loudest = std::max(loudest, std::abs(sample));
  }
  for (double& sample : sound) {
    sample /= loudest > 0.0 ? loudest : 1.0;
  }
  return sound;
}

Evolved evolve(const std::vector<std::filesystem::path>& ancestors, const Target& target,
               const BreedingOptions& options, MPI_Comm communicator, const GenerationReport& report) {
  Breeder breeder(ancestors, options, target.rate);
  std::vector<Individual> parents = breeder.ancestors();
  const SoundDistance distance(target);
  measure(parents, target, distance, communicator);
  Evolved evolved;
  evolved.distance_before = std::ranges::min_element(parents, is_nearer)->facts.distance;
  for (const Individual& parent : parents) {
    evolved.ancestry.push_back(parent.facts);
  }
  const std::size_t survivors = std::max<std::size_t>(2, options.population / 4);
  for (int generation = 1; generation <= options.generations; ++generation) {
    const double progress = static_cast<double>(generation - 1) / std::max(1, options.generations - 1);
    const double spread = first_spread * std::pow(last_spread / first_spread, progress);
    std::vector<Individual> trees = breeder.children(parents, options.population, generation, spread);
    measure(trees, target, distance, communicator);
    for (const Individual& tree : trees) {
      evolved.ancestry.push_back(tree.facts);
    }
    trees.insert(trees.end(), parents.begin(), parents.end());
    std::ranges::stable_sort(trees, is_nearer);
    trees.resize(std::min(survivors, trees.size()));
    parents = std::move(trees);
    report(generation, parents.front().facts.distance);
  }
  evolved.best = parents.front().facts;
  return evolved;
}

}  // namespace idiophone::timbre
