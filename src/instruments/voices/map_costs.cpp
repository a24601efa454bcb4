#include "map_costs.hpp"

#include "idiophone/instruments/resonators/mode_group.hpp"
#include "idiophone/instruments/voices/shared_budget.hpp"

namespace idiophone::voices {

namespace {

// Processor time for an audio sample on the machine of usual_speed, s; benchmark_stage, benchmark_engines and
// benchmark_resonators measure it.
constexpr double ringing_mode = 7e-11, ringing_mode_of_output = 8e-11, moving_mode_of_output = 1.45e-10;
constexpr double driven_mode = 5.5e-10;
constexpr double body_of_output = 3.2e-8, moving_body_of_output = 4.3e-8;
constexpr double choice = 8e-9, choice_of_mode = 4e-11;
constexpr double multiply_add = 5e-11;

}  // namespace

MapCosts::MapCosts(int rate, double speed, std::size_t receivers) : outputs_(static_cast<double>(receivers)) {
  const double scale = rate * usual_speed / speed, of_modes = scale * resonators::modes_in_group;
  body_ = scale * body_of_output;
  moving_body_ = scale * moving_body_of_output;
  group_ = of_modes * ringing_mode;
  group_of_output_ = of_modes * ringing_mode_of_output;
  moving_group_of_output_ = of_modes * moving_mode_of_output;
  driven_group_ = of_modes * driven_mode;
  choice_ = scale * choice;
  choice_of_group_ = of_modes * choice_of_mode;
  multiply_add_ = scale * multiply_add;
}

}  // namespace idiophone::voices
