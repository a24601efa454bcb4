#include "idiophone/timbre/language/graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graph_builder.hpp"

namespace idiophone::timbre {

namespace {

double loudest_of(std::span<const double> samples) {
  double loudest = 0.0;
  for (const double sample : samples) {
    loudest = std::max(loudest, std::abs(sample));
  }
  return loudest;
}

}  // namespace

Graph::Graph(const Tree& tree, const Bindings& bindings, const SoundStart& sound_start) : rate_(sound_start.rate) {
  GraphBuilder(*this, tree, bindings, sound_start).build();
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
    last_block_ = loudest_of(samples.subspan(begin, count));
    loudest_ = std::max(loudest_, last_block_);
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
  find_endings(count);
}

void Graph::find_endings(std::size_t count) {
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    Vertex& vertex = nodes_[n];
    Value& value = values_[value_of_node_[n]];
    if (value.is_over) {
      continue;
    }
    const auto end = static_cast<double>(first_ + static_cast<std::int64_t>(count));
    value.is_over = end >= vertex.lifetime * rate_;
    if (vertex.memory == 0.0) {
      value.is_over = value.is_over || arguments_are_over(vertex);
      continue;
    }
    const double loudest = loudest_of(std::span(value.samples).first(count * value.width));
    vertex.loudest = std::max(vertex.loudest, loudest);
    const bool is_quiet = loudest <= inaudible_share * vertex.loudest && arguments_are_over(vertex);
    vertex.quiet = is_quiet ? vertex.quiet + static_cast<std::int64_t>(count) : 0;
    value.is_over = value.is_over || static_cast<double>(vertex.quiet) > vertex.memory * rate_;
  }
}

bool Graph::arguments_are_over(const Vertex& vertex) const {
  const auto is_over = [this](std::size_t value) { return values_[value].is_over; };
  switch (vertex.type == nullptr ? EndsWith::none : vertex.type->ends_with) {
    case EndsWith::all:
      return std::ranges::all_of(vertex.arguments, is_over);
    case EndsWith::any:
      return std::ranges::any_of(vertex.arguments, is_over);
    case EndsWith::first:
      return is_over(vertex.arguments.front());
    case EndsWith::last:
      return is_over(vertex.arguments.back());
    case EndsWith::none:
      break;
  }
  return false;
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
