#pragma once
// What can be done to a body. The events of a score, notes and messages all say it in these words.

#include <cstddef>
#include <optional>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/bowing.hpp"
#include "idiophone/scene/course.hpp"
#include "idiophone/scene/signal.hpp"

namespace idiophone::score {

/// A rigid hammer with a round head.
struct Hammer {
  double mass = 0.0;      ///< kg
  double hardness = 0.0;  ///< of the contact by Hertz' law, force = hardness (approach)^(3/2), N/m^(3/2)
  double speed = 0.0;     ///< before the contact, m/s

  /// Of a contact with a body that does not give way, s: 2.9433 (approach)/(speed) with the largest approach
  /// (5 mass speed^2/(4 hardness))^(2/5); K. L. Johnson, Contact Mechanics (1985), section 11.4.
  [[nodiscard]] double contact_duration() const;
};

/// A hammer strikes a body.
struct HammerBlow {
  Vector3 at = Vector3::Zero();          ///< the nearest point of the surface is struck, m
  Vector3 direction = Vector3::UnitZ();  ///< of the force on the body; unit vector
  Hammer hammer;
};

/// A mallet strikes a body and feels how it gives way.
struct MalletBlow {
  HammerBlow blow;
  double loss = 0.0;  ///< of the contact by Hunt and Crossley's law, s/m
};

/// Any force over time.
struct AppliedForce {
  Vector3 at = Vector3::Zero();     ///< the nearest point of the surface, m
  Vector3 force = Vector3::Zero();  ///< N
  scene::Signal signal;             ///< that the force is multiplied by; finite

  /// Time (s) after which it is zero; infinite if it has no end.
  [[nodiscard]] double end() const;
};

/// Height of a rough surface: waves whose power falls as 1/frequency^exponent.
struct Roughness {
  double height = 0.0;     ///< root of the mean square, m
  double exponent = 1.0;   ///< 0: white
  double longest = 5e-3;   ///< wavelength, m
  double shortest = 2e-5;  ///< wavelength, m
};

/// A tool is drawn over the surface (scraping), or a ball rolls over it.
struct Stroke {
  enum class Kind { scrape, roll };
  Kind kind = Kind::scrape;
  Vector3 from = Vector3::Zero(), to = Vector3::Zero();  ///< m; straight; the nearest points of the surface are touched
  Vector3 direction = Vector3::UnitZ();                  ///< of the load on the body; unit vector
  double speed = 0.0;                                    ///< of the contact, m/s
  double load = 0.0;                                     ///< that presses the tool on, N
  double mass = 0.0;                                     ///< of the tool or ball, kg
  double hardness = 0.0;                                 ///< as Hammer::hardness, N/m^(3/2)
  double size = 1e-4;                                    ///< diameter of the contact, which smooths the roughness, m
  double friction = 0.0;                                 ///< coefficient; zero when rolling
  Roughness roughness;
};

/// A bow, or a finger, rubs a body and feels its vibration.
struct Bow : scene::Bowing {
  Vector3 at = Vector3::Zero();  ///< the nearest point of the surface is rubbed, m
};

/// How a contact gives way, by the law of resonators::ElasticContact.
struct Elasticity {
  double hardness = 0.0;  ///< N/m^exponent
  double exponent = 1.5;  ///< by Hertz' law for round surfaces; 1: a linear spring
  double loss = 0.0;      ///< by Hunt and Crossley's law, s/m
};

/// A point of a body that can touch something.
struct PointOfBody {
  std::size_t body = 0;          ///< index of the sound map
  Vector3 at = Vector3::Zero();  ///< the nearest point of the surface, m
};

/// A mass that lies or falls on a body.
struct LooseMass {
  double mass = 0.0;  ///< kg
  double load = 0.0;  ///< that presses it towards the body, e.g. its weight, N; above 0
};

/// A point of a body and a rigid stop, a loose mass, or a point of the same or another body touch each other whenever
/// the gap between them closes.
struct BodyContact {
  PointOfBody point;
  Vector3 direction = Vector3::UnitZ();  ///< of the force on the body of `point`; unit vector
  std::optional<PointOfBody> other;      ///< the force on its body is opposite
  std::optional<LooseMass> mass;         ///< neither: a rigid stop
  scene::Course gap;                     ///< while nothing vibrates, m; negative: preloaded
  Elasticity elasticity;
};

/// The body gets another size or material.
struct Tuning {
  double size = 1.0;      ///< times the lengths of the sound map, of the same material
  double friction = 1.0;  ///< times the decay of the sound map by the material
  double tension = 1.0;   ///< of proxies: times the stiffness of the springs
};

/// How a proxy is computed from now on, and the limits of all proxies. What is empty stays as it is.
struct Detail {
  std::optional<int> level;        ///< of detail, 0: the finest; -1: as the budget allows
  std::optional<double> priority;  ///< of the body, for --priority order
  std::optional<double> budget;    ///< of all proxies, processor time per time of sound
  std::optional<int> most_active;  ///< proxies that may sound at once
};

}  // namespace idiophone::score
