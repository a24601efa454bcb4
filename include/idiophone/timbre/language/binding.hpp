#pragma once
// What the parameters of a timbre tree are bound to.

#include <map>
#include <memory>
#include <string>
#include <variant>

#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::timbre {

class Curve;

/// A constant, or a function of the scene's time.
struct Binding {
  std::variant<double, std::shared_ptr<const Curve>> value;
  deck::Location where;
};
using Bindings = std::map<std::string, Binding>;  ///< by the parameter's name

}  // namespace idiophone::timbre
