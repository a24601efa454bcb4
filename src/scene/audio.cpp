#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

namespace {

constexpr double usual_dc_corner = 10.0;  // Hz
constexpr double papers_dc_loss = 0.1;

}  // namespace

// |H|^2 = (2 - 2 cos w)/(1 + a^2 - 2 a cos w) with a = 1 - alpha and w = 2 pi corner/rate is half of its value at w =
// pi where 2 a = (1 + a^2) cos w, that is a = tan(pi/4 - w/2). Written with tan(w/2) so that a small alpha keeps its
// digits.
double dc_loss_at(double corner, double rate) {
  const double t = std::tan(std::numbers::pi * corner / rate);
  return 2.0 * t / (1.0 + t);
}

DefaultDcBlock default_dc_block(Section& deck) {
  deck.know("audio");  // before radiation in the list of known keys
  const Node* radiation = deck.find("radiation");
  if (radiation == nullptr || radiation->kind != Node::Kind::map) {
    return DefaultDcBlock::corner;
  }
  const auto is_papers = [](const Node& child) { return child.key == "model" && child.text == "huygens"; };
  return std::ranges::any_of(radiation->children, is_papers) ? DefaultDcBlock::paper : DefaultDcBlock::corner;
}

void read_dc_block(Section& section, Audio& audio, double rate, DefaultDcBlock default_dc_block) {
  const bool has_corner = section.find("dc_corner") != nullptr;
  const bool by_loss = section.find("dc_block") != nullptr;
  if (by_loss || (default_dc_block == DefaultDcBlock::paper && !has_corner)) {
    audio.dc_loss = papers_dc_loss;
    section.optional("dc_block", audio.dc_loss, Range{.at_least = 0.0, .below = 1.0});
    section.refuse("dc_corner", "dc_block is given already; give one of the two");
  } else {
    double corner = usual_dc_corner;
    section.optional("dc_corner", corner, Range{.at_least = 0.0, .below = 0.25 * rate, .unit = "Hz"});
    audio.dc_loss = dc_loss_at(corner, audio.rate);
  }
}

bool read(const Node& node, Mistakes& mistakes, Audio& audio, DefaultDcBlock default_dc_block) {
  Section section(node, mistakes);
  // A wrong rate must not bring mistakes in what it bounds.
  const bool rate_known =
      section.optional("rate", audio.rate, Range{.at_least = 2000.0, .at_most = 1e6, .unit = "samples per second"});
  const double rate = rate_known ? audio.rate : infinity;

  audio.max_frequency = std::min(audio.max_frequency, 0.5 * rate);
  section.optional("max_frequency", audio.max_frequency,
                   Range{.at_least = rate_known ? 0.01 * rate : 0.0, .at_most = 0.5 * rate, .unit = "Hz"});
  section.optional("kernel_wavelengths", audio.kernel_wavelengths, Range{.at_least = 1.0, .at_most = 32.0});

  read_dc_block(section, audio, rate, default_dc_block);
  return section.finish();
}

}  // namespace idiophone::scene
