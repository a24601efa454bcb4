#pragma once
// From the expressions of a tree to the nodes of a graph, with every check.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/foundation/deck/mistakes.hpp"
#include "idiophone/timbre/language/graph.hpp"

namespace idiophone::timbre {

class GraphBuilder {
 public:
  /// Samples that a node computes at once, at most.
  static constexpr std::size_t largest_block = 64;

  /// @param graph  is filled
  GraphBuilder(Graph& graph, const Tree& tree, const Bindings& bindings, const SoundStart& sound_start)
      : graph_(graph), tree_(tree), bindings_(bindings), sound_start_(sound_start) {}

  void build();

 private:
  using Value = std::optional<std::size_t>;  // index into the graph's values; none after a mistake

  /// A definition, and what became of it.
  struct Named {
    const Definition* definition = nullptr;
    bool is_open = false;
    bool is_done = false;
    Value value;
  };

  void check_bindings();
  Value build(const Expression& expression, int depth);
  Value build_word(const Expression& word, int depth);
  Value build_parameter(const Parameter& parameter);
  /// The node of a binding that is not a constant.
  [[nodiscard]] std::unique_ptr<Node> changing_value(const Binding& binding) const;
  Value build_definition(Named& named, const Expression& word, int depth);
  Value build_call(const Expression& call, int depth);
  /// @param arguments  expressions
  Value build_node(const NodeType& type, const deck::Location& where, std::span<const Expression> arguments, int depth);
  bool check_count(const NodeType& type, const deck::Location& where, std::size_t count);
  /// The argument's value, or its text, and the width of the call; false after a mistake.
  bool take_argument(const NodeType& type, const Argument& argument, const Expression& expression, Call& call,
                     std::vector<std::size_t>& values, int depth);
  Value make(const NodeType& type, const Call& call, std::vector<std::size_t> values);

  std::size_t constant(std::vector<double> values);
  std::size_t add_value(std::size_t width);
  std::size_t add_vertex(Graph::Vertex vertex);
  [[nodiscard]] std::string kind_of(std::size_t value) const;
  Value complain(const deck::Location& where, const std::string& message);
  [[nodiscard]] std::vector<std::string> known_words() const;

  Graph& graph_;
  const Tree& tree_;
  const Bindings& bindings_;
  const SoundStart& sound_start_;
  deck::Mistakes mistakes_;
  bool is_too_deep_ = false;
  std::vector<std::string> open_;            // definitions that are being built, for messages about cycles
  std::map<std::string, Named> named_;       // by name
  std::map<std::string, Value> parameters_;  // by name
  std::map<std::string, std::size_t> same_;  // values by what they are made of
};

}  // namespace idiophone::timbre
