#pragma once
// A timbre tree with values for its parameters: checked, and ready to sound.

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "idiophone/timbre/language/binding.hpp"
#include "idiophone/timbre/language/timbre_tree.hpp"
#include "idiophone/timbre/nodes/curve.hpp"
#include "idiophone/timbre/nodes/node_types.hpp"

namespace idiophone::timbre {

/// The nodes of a tree, each after its arguments. Equal subtrees are one node; what depends on constants alone is
/// computed once.
class Graph {
 public:
  /// @throws deck::DeckError with every mistake: wrong names, types and numbers of arguments, nodes that cannot be made
  ///         of their arguments, cycles, parameters without value, bindings without parameter, trees deeper than
  ///         `deepest`
  Graph(const Tree& tree, const Bindings& bindings, const SoundStart& sound_start);

  /// The next samples of the sound. They do not depend on how many are asked for at once.
  /// @throws std::runtime_error for a sample that is not finite, with the place of the node that it comes from
  void render(std::span<double> samples);

  /// Whether all later samples are zero or inaudible: what excites the sound is over, and it has decayed.
  [[nodiscard]] bool has_ended() const { return values_[root_].is_over && last_block_ <= inaudible_share * loudest_; }

  /// Nodes that compute samples.
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }

 private:
  friend class GraphBuilder;
  friend class FaustWriter;

  /// A node, where its arguments are, and its samples of the present block.
  struct Vertex {
    std::unique_ptr<Node> node;
    std::vector<std::size_t> arguments;  // of values_
    std::size_t width = 1;
    const NodeType* type = nullptr;  // null for the curve of a parameter
    deck::Location where;
    std::vector<std::string> texts{};  // of its arguments that are words or texts, empty for others
    double lifetime = std::numeric_limits<double>::infinity();  // s, see NodeType
    double memory = 0.0;                                        // s, see NodeType
    double loudest = 0.0;                                       // of its samples so far
    std::int64_t quiet = 0;                                     // samples since the last audible one
  };
  /// What an expression is: a constant, or the samples of a node.
  struct Value {
    std::size_t width = 1;
    std::vector<double> samples;  // [width] of a constant, [width x block] of a node
    bool is_constant = true;
    bool is_over = false;  // zero or inaudible from now on
  };

  void render_block(std::size_t count);
  void find_endings(std::size_t count);
  [[nodiscard]] bool arguments_are_over(const Vertex& vertex) const;
  [[noreturn]] void complain(std::size_t count) const;

  std::vector<Vertex> nodes_;
  std::vector<std::size_t> value_of_node_;  // [nodes]
  std::vector<Value> values_;
  std::size_t root_ = 0;       // of values_
  std::vector<Input> inputs_;  // of the node that is computed; a member, so that rendering allocates nothing
  std::int64_t first_ = 0;
  double loudest_ = 0.0, last_block_ = 0.0;  // largest magnitudes of all samples, and of the last block
  int rate_;
};

}  // namespace idiophone::timbre
