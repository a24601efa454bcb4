#include "controls.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::plugin {

ControlValues usual_values() {
  ControlValues values{};
  std::ranges::transform(control_ports, values.begin(), &ControlPort::usual);
  return values;
}

Controls controls_of(const ControlValues& values) {
  std::size_t next = 0;
  const auto take = [&]() -> double {
    const ControlPort& port = control_ports.at(next);
    const float value = values.at(next++);
    return std::isnan(value) ? port.usual : std::clamp(value, port.least, port.most);
  };
  const auto take_vector = [&] {
    const double x = take(), y = take(), z = take();
    return Vector3(x, y, z);
  };
  Controls controls;
  controls.keyboard = static_cast<Keyboard>(std::lround(take()));
  controls.hammer.mass = take();
  controls.hammer.hardness = take();
  controls.hammer.speed = take();
  controls.place = take_vector();
  controls.size = take();
  controls.friction = take();
  controls.listener = take_vector();
  controls.full_scale = take();
  return controls;
}

}  // namespace idiophone::plugin
