#pragma once
// Timbre trees that are bred (Hahn 1995, "Growing timbre trees"; Koza 1992; Sims 1991): mutation, crossover, and
// selection by ear or by the distance to a recorded sound.

#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace idiophone::timbre {

/// What breeding may change.
enum class Change {
  constants,  ///< numbers and defaults of parameters
  everything  ///< nodes as well
};

struct BreedingOptions {
  Change change = Change::everything;
  std::size_t population = 40;  ///< trees of a generation
  int generations = 40;
  std::size_t most_nodes = 100;  ///< of a tree: numbers, names and lists
  std::uint64_t seed = 1;
};

/// A tree and where it comes from.
struct Descendant {
  int number = 0;  ///< counts all trees that were ever bred
  int generation = 0;
  std::vector<int> parents{};  ///< their numbers: none, one or two
  std::string change{};        ///< "ancestor", "constants", "node", "crossover", or "none" if no change was possible
  std::string tree{};          ///< its text
  double distance = 0.0;       ///< to the target, dB; 0 without a target
};

/// The least distance of two sounds that can be told apart by ear, dB: that of two steady sines a third of a semitone
/// apart, or of two decays whose times differ by a tenth.
inline constexpr double audible_distance = 3.0;

/// One generation of sounds that can be heard. Each of them is at least `audible_distance` from its parents and from
/// all others, when all are equally loud. For each, a bounded number of changes is tried: there are fewer trees than
/// the population if no other change can be heard, perhaps none.
/// @param ancestors  files of trees
/// @param duration   of a sound, s, at least 0.1
/// @throws deck::DeckError for a wrong tree; std::runtime_error for an ancestor whose samples are not finite
[[nodiscard]] std::vector<Descendant> breed(const std::vector<std::filesystem::path>& ancestors,
                                            const BreedingOptions& options, double duration, int rate);

/// The first seconds of a tree with the defaults of its parameters, scaled to a loudest sample of 1.
[[nodiscard]] std::vector<double> sound_of_descendant(const Descendant& descendant, const std::filesystem::path& folder,
                                                      double duration, int rate);

/// A sound to imitate.
struct Target {
  std::vector<double> samples;
  int rate = 44100;  ///< per second
};

/// A sound file with one channel. @throws std::runtime_error if it can't be read
[[nodiscard]] Target read_target(const std::filesystem::path& file, int rate);

/// How different a sound is from a target, dB: the root mean square of the differences of their log spectra, in
/// blocks of 2048 and of 256 samples, plus that of their envelopes. Levels more than 60 dB below the loudest one of the
/// target count as 60 dB below. The overall level counts, too.
class SoundDistance {
 public:
  explicit SoundDistance(const Target& target);

  /// @param sound  as long as the target
  [[nodiscard]] double operator()(const std::vector<double>& sound) const;

  /// The distance to the target of another one, which is as long.
  [[nodiscard]] double to(const SoundDistance& other) const;

 private:
  /// Levels of the target in one division into blocks, and the lowest one that counts, dB.
  struct Levels {
    std::vector<double> wanted;
    double floor;

    /// Root mean square of the differences, levels below the floor raised to it.
    [[nodiscard]] double rms_difference(const std::vector<double>& levels) const;
  };
  static Levels with_floor(std::vector<double> wanted);
  [[nodiscard]] std::vector<double> spectra(const std::vector<double>& sound, std::size_t block) const;

  int rate_;
  Levels fine_, coarse_, envelope_;
};

/// What an evolution found.
struct Evolved {
  Descendant best;
  double distance_before = 0.0;      ///< of the nearest ancestor, dB
  std::vector<Descendant> ancestry;  ///< of all generations, by number
};

/// Called after each generation with its number and the least distance (dB).
using GenerationReport = std::function<void(int generation, double distance)>;

/// Breeds towards a target. The ranks share the trees of a generation; the result does not depend on their number.
/// Collective.
/// @throws deck::DeckError for a wrong ancestor
[[nodiscard]] Evolved evolve(const std::vector<std::filesystem::path>& ancestors, const Target& target,
                             const BreedingOptions& options, MPI_Comm communicator, const GenerationReport& report);

}  // namespace idiophone::timbre
