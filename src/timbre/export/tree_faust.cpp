#include "idiophone/timbre/export/tree_faust.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "faust_nodes.hpp"
#include "idiophone/timbre/language/graph.hpp"
#include "idiophone/timbre/nodes/curve_node.hpp"

namespace idiophone::timbre {

namespace {

/// A binding that may change, so that the parameter stays a node of its own.
Binding slider_binding(const Parameter& parameter) {
  return {.value = std::make_shared<const Curve>(std::vector{0.0}, std::vector{parameter.default_value.value_or(1.0)},
                                                 timbre::Interpolation::hold),
          .where = parameter.where};
}

/// Every parameter without default becomes a slider, and of the others those that may change with time.
Bindings sliders_of(const Tree& tree, const SoundStart& sound_start) {
  Bindings bindings;
  for (const Parameter& parameter : tree.parameters) {
    if (!parameter.default_value) {
      bindings[parameter.name] = slider_binding(parameter);
    }
  }
  static_cast<void>(Graph(tree, bindings, sound_start));  // its mistakes have nothing to do with sliders
  for (const Parameter& parameter : tree.parameters) {
    Bindings tried = bindings;
    tried[parameter.name] = slider_binding(parameter);
    try {
      static_cast<void>(Graph(tree, tried, sound_start));
      bindings = std::move(tried);
    } catch (const deck::DeckError&) {
      continue;  // it has to be a number
    }
  }
  return bindings;
}

std::string slider(const Tree& tree, const deck::Location& where) {
  const auto parameter = std::ranges::find_if(tree.parameters, [&](const Parameter& candidate) {
    return candidate.where.line == where.line && candidate.where.column == where.column;
  });
  const double value = parameter->default_value.value_or(1.0);
  const double bound = value == 0.0 ? 1.0 : 10.0 * std::abs(value);
  return fmt::format(R"(hslider("{}", {}, {}, {}, {}))", parameter->name, value, value > 0.0 ? 0.0 : -bound, bound,
                     bound / 1000.0);
}

/// An expression with its arguments, and with a noise of its own.
std::string filled_in(const std::string& pattern, const std::vector<std::string>& arguments, const std::string& noise) {
  std::string text;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] != '$') {
      text += pattern[i];
    } else if (pattern[++i] == 'n') {
      text += noise;
    } else {
      text += arguments[pattern[i] - '0'];
    }
  }
  return text;
}

std::string faust_number(double number) {
  return fmt::format("({:.17e})", number);
}

/// A curve as a cubic polynomial between each two times; each is given by its values at 0, 1/4, 1/2 and 3/4.
std::string faust_curve(const std::vector<double>& times, const std::vector<double>& values,
                        timbre::Interpolation interpolation) {
  const Curve curve(times, values, interpolation);
  std::string text = faust_number(values.back());
  for (std::size_t i = times.size() - 1; i-- > 0;) {
    const double quarter = 0.25 * (times[i + 1] - times[i]);
    const auto y = [&](int quarters) { return curve.at(times[i] + quarters * quarter); };
    text = fmt::format("select2(time < {}, {}, newton((time - {})/{}, {}, {}, {}, {}))", faust_number(times[i + 1]),
                       text, faust_number(times[i]), faust_number(quarter), faust_number(values[i]),
                       faust_number(y(1) - values[i]), faust_number(y(2) - 2.0 * y(1) + values[i]),
                       faust_number(y(3) - 3.0 * y(2) + 3.0 * y(1) - values[i]));
  }
  return fmt::format("select2(time < {}, {}, {})", faust_number(times.front()), text, faust_number(values.front()));
}

}  // namespace

/// Writes the nodes of a graph one after another.
class FaustWriter {
 public:
  FaustWriter(const Tree& tree, const Graph& graph) : tree_(tree), graph_(graph) {}

  std::string program() {
    std::string nodes;
    for (std::size_t n = 0; n < graph_.nodes_.size(); ++n) {
      const std::size_t value = graph_.value_of_node_[n];
      for (std::size_t component = 0; component < graph_.values_[value].width; ++component) {
        nodes += fmt::format("{} = {};\n", name(value, component), node(graph_.nodes_[n], component));
      }
    }
    return fmt::format(
        "// The timbre tree {}. Compile it with -double.\n{}noise(n) = no.noises({}, n);\n\n{}process = {};\n",
        tree_.file.filename().string(), faust_definitions(), std::max(noises_, 1), nodes, name(graph_.root_, 0));
  }

 private:
  [[nodiscard]] std::string name(std::size_t value, std::size_t component) const {
    const Graph::Value& found = graph_.values_[value];
    const std::size_t index = found.width == 1 ? 0 : component;
    return found.is_constant ? faust_number(found.samples[index]) : fmt::format("v{}_{}", value, index);
  }

  std::string node(const Graph::Vertex& vertex, std::size_t component) {
    if (vertex.type == nullptr) {
      return slider(tree_, vertex.where);
    }
    std::vector<std::string> arguments;
    for (const std::size_t argument : vertex.arguments) {
      arguments.push_back(name(argument, component));
    }
    const std::string& kind = vertex.type->name;
    if (std::string join = faust_join(kind, arguments); !join.empty()) {
      return join;
    }
    if (kind == "combine") {
      return combination(vertex);
    }
    if (kind == "fir") {
      return finite_response(vertex, component);
    }
    if (kind == "keyframe") {
      return keyframes(vertex);
    }
    const auto pattern = faust_nodes().find(kind);
    if (pattern == faust_nodes().end()) {
      throw deck::DeckError(vertex.where, fmt::format("({} ...) can't be written in Faust", kind));
    }
    const bool has_noise = pattern->second.find("$n") != std::string::npos;
    return filled_in(pattern->second, arguments, has_noise ? fmt::format("noise({})", noises_++) : "");
  }

  [[nodiscard]] std::string combination(const Graph::Vertex& vertex) const {
    const std::size_t width =
        std::max(graph_.values_[vertex.arguments[0]].width, graph_.values_[vertex.arguments[1]].width);
    std::vector<std::string> terms;
    for (std::size_t component = 0; component < width; ++component) {
      terms.push_back(name(vertex.arguments[0], component) + "*" + name(vertex.arguments[1], component));
    }
    return fmt::format("{}", fmt::join(terms, " + "));
  }

  [[nodiscard]] std::string finite_response(const Graph::Vertex& vertex, std::size_t component) const {
    std::vector<std::string> taps;
    std::ranges::transform(graph_.values_[vertex.arguments[1]].samples, std::back_inserter(taps), faust_number);
    return fmt::format("({} : fi.fir(({})))", name(vertex.arguments[0], component), fmt::join(taps, ", "));
  }

  [[nodiscard]] std::string keyframes(const Graph::Vertex& vertex) const {
    timbre::Interpolation interpolation = timbre::Interpolation::linear;
    static_cast<void>(find_interpolation(vertex.texts.front(), interpolation));  // checked when the node was made
    std::vector<double> times, values;
    for (std::size_t a = 0; a < vertex.arguments.size(); ++a) {
      (a % 2 == 0 ? times : values).push_back(graph_.values_[vertex.arguments[a]].samples.front());
    }
    return faust_curve(times, values, interpolation);
  }

  const Tree& tree_;
  const Graph& graph_;
  int noises_ = 0;  // so far
};

std::string faust_program(const std::filesystem::path& file) {
  const Tree tree = read_tree_file(file);
  const SoundStart sound_start;
  const Graph graph(tree, sliders_of(tree, sound_start), sound_start);
  return FaustWriter(tree, graph).program();
}

}  // namespace idiophone::timbre
