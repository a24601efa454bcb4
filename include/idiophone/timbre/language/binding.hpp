#pragma once
// What the parameters of a timbre tree are bound to.

#include <map>
#include <memory>
#include <string>
#include <variant>

#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::timbre {

class Curve;
class Control;

/// A number that a program sets while the sound plays.
struct LiveValue {
  std::shared_ptr<const Control> control;
  double smoothing = 0.0;  ///< time after which 99 % of a change are done, s
};

/// A constant, a function of the scene's time, or a number that a program sets.
struct Binding {
  std::variant<double, std::shared_ptr<const Curve>, LiveValue> value;
  deck::Location where;
};
using Bindings = std::map<std::string, Binding>;  ///< by the parameter's name

}  // namespace idiophone::timbre
