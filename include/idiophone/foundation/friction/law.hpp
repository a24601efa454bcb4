#pragma once
// The numbers of friction with memory.

namespace idiophone::friction {

/// How two surfaces rub on each other; ElastoPlasticFriction says what the numbers do.
struct Law {
  double sticking = 0.8;        ///< largest force without sliding over the load
  double sliding = 0.3;         ///< force of fast sliding over the load; above 0, at most `sticking`
  double stribeck_speed = 0.1;  ///< at which the force has fallen by 63 % of the difference, m/s
  double stiffness = 1e5;       ///< of the bristles, N/m
  double damping = 0.0;         ///< of the bristles, N s/m
  double viscosity = 0.0;       ///< force that grows with the speed, up to `sticking` times the load, N s/m
  double break_away = 0.7;      ///< deflection at which sliding begins over that of fast sliding; below 1
};

}  // namespace idiophone::friction
