#include "loss_section.hpp"

#include <algorithm>
#include <functional>
#include <vector>

namespace idiophone::scene {

namespace {

const Range tangent{.at_least = 0.0, .at_most = 0.3};
const Range of_band{.at_least = 1e-3, .at_most = 1e6, .unit = "Hz"};

}  // namespace

bool read(const Node& node, Mistakes& mistakes, std::array<double, 2>& range, const FrequencyBand& /*rule*/) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    return mistakes.add(node, "expected a list of 2 numbers (Hz), e.g. [20, 20000], found " + describe(node));
  }
  std::array<double, 2> found{};
  if (!read(node.children[0], mistakes, found[0], of_band) || !read(node.children[1], mistakes, found[1], of_band)) {
    return false;
  }
  if (found[0] >= found[1]) {
    return mistakes.add(node,
                        fmt::format("must ascend, found {} and {}", node.children[0].text, node.children[1].text));
  }
  range = found;
  return true;
}

Node to_node(const std::array<double, 2>& range, const FrequencyBand& /*rule*/) {
  Node list;
  list.kind = Node::Kind::list;
  for (const double frequency : range) {
    list.children.push_back(to_node(frequency, Range{}));
  }
  return list;
}

/// [frequency, loss factor]
static bool read(const Node& node, Mistakes& mistakes, LossFactor::Point& point) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    return mistakes.add(node, "expected [frequency, loss factor], found " + describe(node));
  }
  const Range positive{.at_least = 1e-7, .at_most = tangent.at_most};
  return deck::read(node.children[0], mistakes, point.frequency, of_band) &&
         deck::read(node.children[1], mistakes, point.value, positive);
}

static bool read(const Node& node, Mistakes& mistakes, DirectionalLoss& loss) {
  Section section(node, mistakes);
  section.required("young", loss.young, tangent);
  section.required("shear", loss.shear, tangent);
  return section.finish();
}

namespace {

/// A list of points over the frequency.
void read_curve(const Node& node, Mistakes& mistakes, LossFactor& loss) {
  std::vector<LossFactor::Point>& curve = loss.curve;
  if (node.children.size() < 2) {
    mistakes.add(node, "give at least two points [frequency, loss factor], or a number");
    return;
  }
  if (!deck::read(node, mistakes, curve)) {
    return;
  }
  if (std::ranges::adjacent_find(curve, std::greater_equal(), &LossFactor::Point::frequency) != curve.end()) {
    mistakes.add(node, "the frequencies of the points must ascend");
    return;
  }
  loss.value = std::ranges::max(curve, {}, &LossFactor::Point::value).value;
  loss.band = {curve.front().frequency, curve.back().frequency};
}

/// A number, the word `table`, a list of points, or a section of directions.
void read_value(const Node& node, Section& section, LossFactor& loss, const std::optional<LossFactor>& table) {
  if (node.kind == Node::Kind::list) {
    read_curve(node, section.mistakes(), loss);
  } else if (node.kind == Node::Kind::map) {
    DirectionalLoss& directions = loss.directions.emplace();
    read(node, section.mistakes(), directions);
    loss.value = std::max(directions.young.maxCoeff(), directions.shear.maxCoeff());
  } else if (node.text != "table") {
    section.optional("loss_factor", loss.value, tangent);
  } else if (table) {
    loss.value = table->value;
  } else {
    section.refuse("loss_factor", "can't be 'table' without a shipped material; name one with the key from");
  }
}

}  // namespace

void read_loss(Section& section, Damping& damping, const std::optional<LossFactor>& table) {
  LossFactor loss;
  if (const Node* value = section.find("loss_factor")) {
    loss.where = value->where;
    read_value(*value, section, loss, table);
  } else {
    section.refuse("band", "has no meaning without a loss_factor");
    section.refuse("mechanisms", "has no meaning without a loss_factor");
    section.optional("loss_factor", loss.value, tangent);
  }
  if (loss.curve.empty()) {
    section.optional("band", loss.band, frequency_band);
  } else {
    section.refuse("band", "has no meaning with a loss_factor over the frequency: its band is that of the points");
  }
  section.optional("mechanisms", loss.mechanisms, Range{.at_least = 1, .at_most = 12});
  if (loss.value > 0) {
    damping.loss = loss;
  }
}

}  // namespace idiophone::scene
