#pragma once
// The kinds of nodes that a timbre tree can have; docs/use/timbre_trees.md has the same table.

#include <fmt/format.h>

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/timbre/nodes/random.hpp"
#include "idiophone/timbre/nodes/sound_node.hpp"

namespace idiophone::timbre {

/// The start of a sound, which all its nodes know; by default the first one of a scene's first sound.
struct SoundStart {
  int rate = 44100;                             ///< audio samples per second
  double start = 0.0;                           ///< of the sound, in the time of the scene, s
  std::uint64_t body_seed = joined_seed(1, 0);  ///< of random vectors: the same each time that the sound starts
  std::uint64_t start_seed = joined_seed(joined_seed(1, 0), 0);  ///< of noise: another one each time
};

/// What has fallen to this part of its beginning, or of its loudest sample, cannot be heard: 180 dB less.
inline constexpr double inaudible_share = 1e-9;

struct Argument {
  enum class Kind {
    signal,  ///< anything: a number, a vector or a signal
    number,  ///< known before the sound begins, for all components alike
    vector,  ///< known before the sound begins
    word,
    text  ///< in quotes
  };
  std::string name;
  Kind kind = Kind::signal;
  std::optional<double> default_value{};
};

/// A node that is to be made.
struct Call {
  const SoundStart& sound_start;
  const deck::Location& where;
  std::filesystem::path folder;                  ///< that relative names of files start from
  std::vector<std::vector<double>> constants{};  ///< [arguments] the values of constants, empty for others
  std::vector<std::string> texts{};              ///< [arguments] of words and texts, empty for others
  std::size_t width = 1;                         ///< the largest of the arguments'

  /// The number that an argument is.
  [[nodiscard]] double number(std::size_t argument) const { return constants[argument].front(); }
  /// The value of a constant for one component.
  [[nodiscard]] double constant(std::size_t argument, std::size_t component) const {
    const std::vector<double>& values = constants[argument];
    return values.size() == 1 ? values.front() : values[component];
  }
  /// @throws deck::DeckError if the argument is a constant and one of its values is not good
  template <class Good>
  void require(std::size_t argument, const Good& is_good, const std::string& expected) const {
    for (const double value : constants[argument]) {
      if (!is_good(value)) {
        throw deck::DeckError(where, fmt::format("{}, not {}", expected, value));
      }
    }
  }
  /// A state for each component: make(component).
  template <class Make>
  [[nodiscard]] auto states(const Make& make_state) const {
    std::vector<decltype(make_state(std::size_t{0}))> all;
    for (std::size_t component = 0; component < width; ++component) {
      all.push_back(make_state(component));
    }
    return all;
  }
};

/// Which arguments end a node: when they are over, its samples are zero from then on, or decay and are over when
/// they were inaudible for the time of its memory.
enum class EndsWith { none, all, any, first, last };

struct NodeType {
  std::string name;
  std::vector<Argument> arguments{};
  std::string description;                                   ///< one sentence for the documentation
  std::function<std::unique_ptr<Node>(const Call&)> make{};  ///< may throw deck::DeckError
  bool repeats = false;                                      ///< the last argument may be there any number of times
  bool is_timeless = false;  ///< depends on its arguments alone, not on time or on earlier samples
  std::function<std::size_t(const Call&)> width = [](const Call& call) { return call.width; };
  EndsWith ends_with = EndsWith::none;
  /// Time since the sound began (s) after which its samples are zero or inaudible whatever the arguments do.
  std::function<double(const Call&)> lifetime = [](const Call&) { return std::numeric_limits<double>::infinity(); };
  /// How long ago samples of its arguments can be that still act (s), for a node that decays after them.
  std::function<double(const Call&)> memory = [](const Call&) { return 0.0; };

  /// "(sine frequency [phase = 0])"
  [[nodiscard]] std::string usage() const;
};

/// All kinds, by topic, then those that were added.
[[nodiscard]] const std::deque<NodeType>& node_types();

/// Makes more kinds known to all trees. Call it before another thread reads or builds trees.
/// @throws std::invalid_argument for a name that is known already, as a node or as a constant
void add_node_types(std::vector<NodeType> types);

/// Null if there is none of this name.
[[nodiscard]] const NodeType* find_node_type(const std::string& name);

/// Whether the word is a constant of its own: pi or rate.
[[nodiscard]] bool is_constant_word(const std::string& word);

// The topics.
[[nodiscard]] std::vector<NodeType> functions();
[[nodiscard]] std::vector<NodeType> oscillators();
[[nodiscard]] std::vector<NodeType> noises();
[[nodiscard]] std::vector<NodeType> filters();
[[nodiscard]] std::vector<NodeType> delays();
[[nodiscard]] std::vector<NodeType> recordings();
[[nodiscard]] std::vector<NodeType> vectors();

/// A node of independent components; see ComponentNode.
template <class State>
[[nodiscard]] std::unique_ptr<Node> component_node(std::vector<State> states) {
  return std::make_unique<ComponentNode<State>>(std::move(states));
}

}  // namespace idiophone::timbre
