#include "idiophone/foundation/element/deck_keys.hpp"

#include <fmt/format.h>

namespace idiophone::element {

std::string deck_keys(Type type) {
  const std::string order = has_choice_of_orders(type)
                                ? fmt::format(", order: {{plane: {}, thickness: {}}}", type.plane, type.thickness)
                                : "";
  return fmt::format("element: {}{}", name(type), order);
}

}  // namespace idiophone::element
