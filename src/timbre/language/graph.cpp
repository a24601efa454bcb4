#include "idiophone/timbre/language/graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graph_builder.hpp"

namespace idiophone::timbre {

Graph::Graph(const Tree& tree, const Bindings& bindings, const Surroundings& surroundings) : rate_(surroundings.rate) {
  GraphBuilder(*this, tree, bindings, surroundings).build();
}

void Graph::render(std::span<double> samples) {
  const Value& root = values_[root_];
  for (std::size_t begin = 0; begin < samples.size(); begin += GraphBuilder::largest_block) {
    const std::size_t count = std::min(GraphBuilder::largest_block, samples.size() - begin);
    render_block(count);
    for (std::size_t i = 0; i < count; ++i) {
      samples[begin + i] = root.samples[root.is_constant ? 0 : i];
    }
    if (!std::ranges::all_of(samples.subspan(begin, count), [](double sample) { return std::isfinite(sample); })) {
      complain(count);
    }
    first_ += static_cast<std::int64_t>(count);
  }
}

void Graph::render_block(std::size_t count) {
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    Vertex& vertex = nodes_[n];
    inputs_.clear();
    for (const std::size_t argument : vertex.arguments) {
      const Value& value = values_[argument];
      inputs_.push_back({value.samples.data(), value.is_constant ? 0 : value.width, value.width == 1 ? 0U : 1U});
    }
    vertex.node->render({first_, count, vertex.width}, inputs_,
                        std::span(values_[value_of_node_[n]].samples).first(count * vertex.width));
  }
}

void Graph::complain(std::size_t count) const {
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Vertex& vertex = nodes_[n];
    const Value& value = values_[value_of_node_[n]];
    const auto samples = std::span(value.samples).first(count * value.width);
    const auto bad = std::ranges::find_if_not(samples, [](double sample) { return std::isfinite(sample); });
    if (bad != samples.end()) {
      const auto sample = first_ + (bad - samples.begin()) / static_cast<std::ptrdiff_t>(value.width);
      throw std::runtime_error(
          fmt::format("{}: ({} ...) is not finite {:.6g} s after the sound began; its arguments are "
                      "out of range (docs/method/timbre.md)",
                      deck::to_string(vertex.where), vertex.type == nullptr ? "parameter" : vertex.type->name,
                      static_cast<double>(sample) / rate_));
    }
  }
  throw std::runtime_error("a constant of the tree is not finite");
}

}  // namespace idiophone::timbre
