#include "idiophone/study/bench/cut_list.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "idiophone/foundation/deck/section.hpp"
#include "idiophone/foundation/deck/tree.hpp"

namespace idiophone::bench {

using deck::Mistakes;
using deck::Node;
using deck::Range;
using deck::Section;

static bool read(const Node& node, Mistakes& mistakes, Cut& cut) {
  Section section(node, mistakes);
  std::string tool;
  if (section.required("tool", tool)) {
    try {
      cut.tool = read_tools({tool}).front();
    } catch (const std::runtime_error&) {
      mistakes.add(*section.find("tool"),
                   fmt::format("'{}' is not a tool: write router:RADIUS or sander:RADIUS", tool));
    }
  }
  section.required("place", cut.place, Range{.at_least = -1e6, .at_most = 1e6, .unit = "m"});
  section.required("depth", cut.depth, Range{.above = 0, .at_most = 1e3, .unit = "m"});
  return section.finish();
}

std::vector<Cut> read_cuts(const std::filesystem::path& file, const Side& side) {
  std::vector<Cut> cuts;
  std::string made_at = name_of(side);
  Mistakes mistakes;
  const Node tree = deck::read_tree(deck::read_text(file), file.string(), {}, mistakes);
  Section section(tree, mistakes);
  section.optional("side", made_at);
  if (made_at != name_of(side)) {
    mistakes.add(*section.find("side"), fmt::format("these cuts were made at the side {}, but {} is to be cut: give "
                                                    "--side {}",
                                                    made_at, name_of(side), made_at));
  }
  section.required("cuts", cuts);
  section.finish();
  mistakes.raise();
  return cuts;
}

std::string text_of(const std::vector<Cut>& cuts, const Side& side) {
  std::string text = fmt::format("side: {}\n{}", name_of(side), cuts.empty() ? "cuts: []\n" : "cuts:\n");
  for (const Cut& cut : cuts) {
    text += fmt::format("  - {{tool: \"{}:{:g}\", place: {:.5f}, depth: {:.6f}}}\n", cut.tool.name, cut.tool.radius,
                        cut.place, cut.depth);
  }
  return text;
}

}  // namespace idiophone::bench
