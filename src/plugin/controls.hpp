#pragma once
// The control ports of the plugin, and what their values mean.

#include <array>
#include <cstddef>

#include "idiophone/foundation/types.hpp"
#include "idiophone/instruments/score/score.hpp"

namespace idiophone::plugin {

/// Which body a key strikes.
enum class Keyboard {
  tuned,   ///< one of the first map, as large as makes its lowest mode sound at the pitch of the key
  scaled,  ///< one of the first map: as it is for the key 60, half as large an octave above
  bodies   ///< the first map for the key 60, the next one for the key 61; after the last one comes the first again
};

/// A control port, as the bundle describes it.
struct ControlPort {
  const char* symbol;
  float least, most, usual;
};

inline constexpr std::array<ControlPort, 13> control_ports = {{{"keyboard", 0, 2, 0},
                                                               {"mass", 1e-4F, 10, 0.02F},
                                                               {"hardness", 1e5F, 1e11F, 1e8F},
                                                               {"speed", 0.01F, 20, 2},
                                                               {"place_x", -1, 1, 0.4F},
                                                               {"place_y", -1, 1, 0.3F},
                                                               {"place_z", -1, 1, 1},
                                                               {"size", 0.1F, 10, 1},
                                                               {"friction", 0, 100, 1},
                                                               {"listener_x", -10, 10, 0},
                                                               {"listener_y", -10, 10, 0},
                                                               {"listener_z", -10, 10, 1},
                                                               {"full_scale", 1e-4F, 100, 1}}};

/// One value for each control port.
using ControlValues = std::array<float, control_ports.size()>;

struct Controls {
  Keyboard keyboard = Keyboard::tuned;
  score::Hammer hammer;                ///< its speed belongs to velocity 127
  Vector3 place = Vector3::Zero();     ///< of the blow in the box around the body, -1 to 1 along each axis
  double size = 1.0, friction = 1.0;   ///< score::Tuning of all bodies
  Vector3 listener = Vector3::Zero();  ///< from the centre of the first map, m
  double full_scale = 1.0;             ///< pressure that becomes 1, Pa
};

/// The usual values.
[[nodiscard]] ControlValues usual_values();

/// Values out of the range of their port are limited to it; what is no number has the usual value.
[[nodiscard]] Controls controls_of(const ControlValues& values);

}  // namespace idiophone::plugin
