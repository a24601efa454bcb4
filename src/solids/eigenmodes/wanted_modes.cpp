#include "wanted_modes.hpp"

#include <algorithm>
#include <utility>

namespace idiophone::eigenmodes {

Options wanted_modes(std::span<const scene::Body> assembly) {
  Options options;
  int count = 0;
  for (const scene::Body& body : assembly) {
    if (body.modal && body.modal->up_to) {
      options.up_to = std::max(options.up_to.value_or(0.0), *body.modal->up_to);
    } else if (body.modal) {
      count += body.modal->count.value_or(options.count);
    }
  }
  options.count = count;
  return options;
}

const scene::ModalModel& most_demanding(std::span<const scene::Body> assembly) {
  const auto demand = [](const scene::Body& body) {
    return body.modal ? std::pair(body.modal->up_to.value_or(0.0), body.modal->count.value_or(0)) : std::pair(-1.0, 0);
  };
  return *std::ranges::max_element(assembly, {}, demand)->modal;
}

}  // namespace idiophone::eigenmodes
