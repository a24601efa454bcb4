#include "idiophone/study/bench/cut_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "idiophone/foundation/deck/section.hpp"
#include "idiophone/foundation/deck/tree.hpp"

namespace idiophone::bench {

using deck::Mistakes;
using deck::Node;
using deck::Range;
using deck::Section;

namespace {

constexpr Range hertz{.at_least = 1e-3, .at_most = 1e9, .unit = "Hz"};
constexpr Range uncertainties{.at_least = 0.01, .at_most = 1200.0, .unit = "cents"};
constexpr Range metres{.at_least = -1e6, .at_most = 1e6, .unit = "m"};

/// Where the body has the middles of cuts, m.
struct Ends {
  double low, high;
};

void check_width(const Tool& tool, const Node& node, const Ends& ends, Mistakes& mistakes) {
  const double least = suitable_radii(ends.high - ends.low).least;
  if (tool.radius < least) {
    mistakes.add(node,
                 fmt::format("the cut is narrower than the plan resolves on this body: the radius of its tool must "
                             "be at least {:.4g} m",
                             least));
  }
}

}  // namespace

static bool read(const Node& node, Mistakes& mistakes, Cut& cut, const Ends& ends) {
  Section section(node, mistakes);
  std::string tool;
  if (section.required("tool", tool)) {
    try {
      cut.tool = read_tools({tool}).front();
      check_width(cut.tool, *section.find("tool"), ends, mistakes);
    } catch (const std::runtime_error&) {
      mistakes.add(*section.find("tool"),
                   fmt::format("'{}' is not a tool: write router:RADIUS or sander:RADIUS", tool));
    }
  }
  if (section.required("place", cut.place, metres) && (cut.place < ends.low || cut.place > ends.high)) {
    mistakes.add(*section.find("place"), fmt::format("the middle of the cut is not on the body, which lies from {:.4g} "
                                                     "to {:.4g} m",
                                                     ends.low, ends.high));
  }
  section.required("depth", cut.depth, Range{.above = 0, .at_most = 1e3, .unit = "m"});
  return section.finish();
}

static bool read(const Node& node, Mistakes& mistakes, Tap& tap) {
  Section section(node, mistakes);
  int cuts = 0;
  std::vector<double> lines, errors;
  section.required("cuts", cuts, Range{.at_least = 0, .at_most = 1e6});
  section.optional("at", tap.at, metres);
  if (section.required("lines", lines, hertz) && lines.empty()) {
    mistakes.add(*section.find("lines"), "is empty; a tap has at least one frequency");
  }
  if (section.required("uncertainties", errors, uncertainties) && errors.size() != lines.size()) {
    mistakes.add(*section.find("uncertainties"),
                 fmt::format("has {} numbers for {} lines: write one for each", errors.size(), lines.size()));
  }
  tap.cuts = static_cast<std::size_t>(std::max(cuts, 0));
  for (std::size_t l = 0; l < std::min(lines.size(), errors.size()); ++l) {
    tap.lines.push_back({.frequency = lines[l], .uncertainty = errors[l]});
  }
  std::ranges::sort(tap.lines, {}, &fitting::Line::frequency);
  return section.finish();
}

/// Taps are in the order of time, and no tap comes after cuts that are not there.
static void check_order(const Past& past, const Node& node, Mistakes& mistakes) {
  std::size_t before = 0;
  for (const Tap& tap : past.taps) {
    if (tap.cuts < before || tap.cuts > past.cuts.size()) {
      mistakes.add(node, fmt::format("a tap after {} cuts follows one after {}, and there are {} cuts: taps are in the "
                                     "order of time",
                                     tap.cuts, before, past.cuts.size()));
    }
    before = tap.cuts;
  }
}

Past read_past(const std::filesystem::path& file, const Side& side, const std::array<double, 2>& ends) {
  Past past;
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
  section.required("cuts", past.cuts, Ends{ends[0], ends[1]});
  section.optional("taps", past.taps);
  if (const Node* taps = section.find("taps")) {
    check_order(past, *taps, mistakes);
  }
  section.finish();
  mistakes.raise();
  return past;
}

std::string text_of(const Past& past, const Side& side) {
  std::string text = fmt::format("side: {}\n{}", name_of(side), past.cuts.empty() ? "cuts: []\n" : "cuts:\n");
  for (const Cut& cut : past.cuts) {
    text += fmt::format("  - {{tool: \"{}:{:g}\", place: {:.7g}, depth: {:.7g}}}\n", cut.tool.name, cut.tool.radius,
                        cut.place, cut.depth);
  }
  text += past.taps.empty() ? "" : "taps:\n";
  for (const Tap& tap : past.taps) {
    std::vector<double> lines, errors;
    std::ranges::transform(tap.lines, std::back_inserter(lines), &fitting::Line::frequency);
    std::ranges::transform(tap.lines, std::back_inserter(errors), &fitting::Line::uncertainty);
    text += fmt::format("  - {{cuts: {}, lines: [{:.4f}], uncertainties: [{:.3g}]", tap.cuts, fmt::join(lines, ", "),
                        fmt::join(errors, ", "));
    text += tap.at ? fmt::format(", at: [{:g}, {:g}, {:g}]}}\n", tap.at->x(), tap.at->y(), tap.at->z()) : "}\n";
  }
  return text;
}

}  // namespace idiophone::bench
