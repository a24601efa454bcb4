#include "modes_options.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace idiophone::app {

void declare(CLI::App& app, ModesOptions& options) {
  add_deck(app, options.deck, options.overrides);
  add_body(app, options.body);
  app.add_option("--modes", options.count, "number of modes, the lowest")->capture_default_str();
  add_renamed(app, "--count", "--modes");
  add_mass(app, options.mass, "lumped, as the motion has it, or consistent");
  app.add_option("--shift", options.shift,
                 "Hz below zero from where the search begins (default: from the body's size)");
  app.add_option("--references", options.references, "Hz,Hz,...: to compare with (default: the deck's)")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--tolerance", options.tolerance, "cents, of matches with references")->capture_default_str();
  app.add_flag("--in-air", options.in_air, "with the mass and the resistance of the air (docs/use/modes.md)");
  add_estimates(app, options.estimates);
  const auto ask_for_bounds = [&options] {
    options.bounds = true;
    options.mass = eigenmodes::MassMatrix::consistent;
  };
  app.add_flag_callback("--bounds", ask_for_bounds,
                        "with two-sided bounds, by the consistent mass (docs/method/bounds.md)")
      ->excludes("--mass")
      ->excludes("--in-air");
  app.add_flag("--pictures", options.pictures, "writes pictures of the shapes, too, as NAME_modes.svg");
  add_output_folder(app, options.output, "folder of the results");
  add_json(app, options.style);
}

void check(const ModesOptions& options) {
  const auto refuse = [](const std::string& option, const std::string& wanted, double value) {
    throw std::runtime_error(fmt::format("{} must be {}, not {}", option, wanted, value));
  };
  if (options.count < 1) {
    refuse("--modes", "at least 1", options.count);
  }
  if (options.shift && !(*options.shift >= 0 && std::isfinite(*options.shift))) {
    refuse("--shift", "0 Hz or above", *options.shift);
  }
  if (!(options.tolerance > 0)) {
    refuse("--tolerance", "above 0 cents", options.tolerance);
  }
  for (const double frequency : options.references) {
    if (!(frequency > 0 && std::isfinite(frequency))) {
      refuse("--references", "frequencies above 0 Hz", frequency);
    }
  }
}

void refuse_with_joints(const ModesOptions& options, const scene::Solids& solids) {
  const std::array<std::pair<bool, std::string>, 3> asked = {
      {{options.in_air, "--in-air"}, {options.bounds, "--bounds"}, {options.pictures, "--pictures"}}};
  for (const auto& [is_asked, option] : asked) {
    if (is_asked) {
      throw std::runtime_error(option + " is for a body without joints: leave it out");
    }
  }
  if (const std::string why = eigenmodes::why_no_estimates(solids);
      options.estimates == eigenmodes::Estimates::all && !why.empty()) {
    throw std::runtime_error(fmt::format("--estimate is not possible: {}. Or leave it out", why));
  }
}

}  // namespace idiophone::app
