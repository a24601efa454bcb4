#pragma once
// Many bodies with levels of detail (O'Morain 2005, chapter 7): create bodies, strike them, take audio blocks.

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idiophone/instruments/proxies/fracture.hpp"
#include "idiophone/instruments/proxies/proxy.hpp"

namespace idiophone::proxies {

/// What is heard of a proxy.
enum class Sound {
  deviation,  ///< his sum of deviation times area, m3 (section 6.6), wherever the listener is
  pressure    ///< Pa: density/(2 pi distance) times the acceleration of the volume that the faces towards the listener
              ///< sweep (Rayleigh's integral for a small body in a wall), without delay
};

/// What decides which bodies may sound, and in which detail. The greater priority goes first.
///
/// With EngineOptions::priority_of, the application decides.
enum class Priority {
  distance,   ///< the nearest body first: his choice
  loudness,   ///< the greatest impulse per mass and distance first
  fixed,      ///< as the bodies say
  audibility  ///< as loudness; for sound maps, the groups of modes that are heard best over what masks them
};

/// What is known of a body when its priority is asked for.
struct PriorityQuestion {
  std::size_t body = 0;
  double distance = 0.0;   ///< of the listener, m
  double strength = 0.0;   ///< impulse per mass of the strongest force on it, N s/kg
  bool is_behind = false;  ///< the listener looks away from it
  double own = 0.0;        ///< BodyOptions::priority
};

struct EngineOptions {
  int rate = 44100;  ///< audio samples per second
  Integrator integrator = Integrator::symplectic_euler;
  double significant_distance = 1e-10;  ///< m, see ProxyOptions
  Sound sound = Sound::pressure;
  double air_density = 1.204;  ///< kg/m3
  Priority priority = Priority::distance;
  std::function<double(const PriorityQuestion&)> priority_of{};  ///< instead of `priority`, if there is one
  double behind = 1.0;      ///< times the priority of bodies behind the listener, above 0 to 1; not with priority_of
  int largest_divisor = 1;  ///< of the rate of a body: 1, 2, 4, 8 or 16
  std::size_t most_active = 8;                              ///< proxies that may sound at once
  double budget = std::numeric_limits<double>::infinity();  ///< springs per second of sound, of all active proxies
  std::function<double(double priority)> others{};  ///< what others than proxies take of the budget with at least this
                                                    ///< priority; nothing if empty
};

struct BodyOptions {
  std::string name;
  std::vector<std::shared_ptr<const Lattice>> levels;  ///< of one geometry, the finest first; at least one
  double priority = 0.0;                               ///< for Priority::fixed
  Vector3 listener = {0.0, 0.0, 1.0};                  ///< its place in the coordinates of the body, m
  Strength strength{};                                 ///< above which it breaks, while it sounds
};

/// A force on a body over time.
struct Force {
  std::size_t body = 0;
  std::int64_t start = 0;               ///< audio sample; the present one if it is over
  Vector3 at = Vector3::Zero();         ///< point of contact in the coordinates of the body, m
  Vector3 direction = Vector3::Zero();  ///< by which the curve is multiplied
  std::vector<double> curve;            ///< [audio samples] mean in each, N
};

/// A body gets other springs or dampers. What rings goes on with them.
struct Tuning {
  std::size_t body = 0;
  std::int64_t start = 0;  ///< audio sample; the present one if it is over
  double tension = 1.0;    ///< times the springs of the lattice: frequencies are sqrt(tension) times as high
  double friction = 1.0;   ///< times the damping of the lattice
  double size = 1.0;       ///< times the lengths: frequencies are 1/size times as high, forces move it 1/size as much
};

/// The force of an impact: a half sine with a given impulse.
/// @param impulse   N s
/// @param duration  s; at least one audio sample is taken
[[nodiscard]] Force impact(std::size_t body, std::int64_t start, const Vector3& at, const Vector3& impulse,
                           double duration, int rate);

/// Something that the engine chose.
struct Choice {
  enum class Kind {
    begin,  ///< a stable proxy was struck and sounds from now on
    end,    ///< it is stable again
    stop,   ///< it was faded out for a body with a greater priority
    refuse  ///< the force on it was left out: greater priorities sound already, or the budget is too small
  };
  std::int64_t sample = 0;
  std::size_t body = 0;
  Kind kind = Kind::begin;
  std::size_t level = 0;  ///< 0: the finest
  int divisor = 1;        ///< of the rate
  double cost = 0.0;      ///< springs per second of sound, of this proxy
};

/// What an active proxy takes of the budget.
struct Share {
  double priority = 0.0;
  double cost = 0.0;  ///< springs per second of sound
};

/// A part of a body that has broken into several: a body of its own, at rest in the coordinates of the one that broke.
struct Piece {
  std::optional<std::size_t> body{};  ///< its number; none: its springs are too fast to be computed
  double mass = 0.0;                  ///< kg
  Vector3 centre = Vector3::Zero();   ///< of mass, m
  RigidVelocity motion{};             ///< relative to that of the body that broke
};

/// A body has broken into pieces, which go on with its vibration.
struct Fracture {
  std::int64_t sample = 0;
  std::size_t body = 0;
  std::vector<Piece> pieces{};  ///< the heaviest first
  double released = 0.0;        ///< J: energy of the body less that of the pieces, with their motion
};

class Engine {
 public:
  /// @throws std::invalid_argument for an option out of range
  explicit Engine(const EngineOptions& options);
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Adds a body at rest. @return its number: the lowest of those that were removed and have faded, or a new one
  /// @throws std::invalid_argument when it can't be simulated, or shall break and has springs under tension at rest or
  ///         single springs with values of their own
  std::size_t add(BodyOptions body);

  /// A body fades within 2 ms, and forces that wait for it are forgotten. Nothing can be told of it from then on.
  /// @throws std::invalid_argument when there is no such body, or it broke: its pieces stay
  void remove(std::size_t body);

  /// Whether a body is computed: it sounds or fades.
  [[nodiscard]] bool sounds(std::size_t body) const;

  /// The listener moved, or the body did: its loudness and its priority change at once, what is heard of its
  /// triangles within 10 ms.
  /// @param listener  in the coordinates of the body, m
  /// @param front     in which the listener looks, likewise; zero: nothing is behind it
  void move_listener(std::size_t body, const Vector3& listener, const Vector3& front = Vector3::Zero());

  /// @throws std::invalid_argument when there is no such body or level
  void require_level(std::size_t body, std::size_t level) const;

  /// From now on, a body sounds with this level of detail when it is struck; none: the engine chooses. Until it is
  /// stable, it goes on with the present one.
  /// @throws std::invalid_argument when there is no such body or level
  void set_level(std::size_t body, std::optional<std::size_t> level);

  /// BodyOptions::priority. @throws std::invalid_argument when there is no such body, or it is not finite
  void set_priority(std::size_t body, double priority);

  /// Changes the limits. Bodies of the smallest priorities are faded out until the others keep within them.
  /// @param budget  springs per second of sound. @throws std::invalid_argument when one is not above 0
  void set_limits(double budget, std::size_t most_active);

  /// Does the same for the present limits, when EngineOptions::others take more.
  void keep_limits();

  /// What the active proxies take of the budget.
  [[nodiscard]] std::vector<Share> shares() const;

  /// A force that begins at its start.
  /// @throws std::invalid_argument when there is no such body, or numbers are not finite
  void add(Force force);

  /// Forces and tunings that begin at one sample act in this order: tunings first.
  /// @throws std::invalid_argument when there is no such body, or it can't be tuned so
  void add(const Tuning& tuning);

  /// @throws std::invalid_argument when there is no such body, or it can't be tuned so
  void require_tunable(const Tuning& tuning) const;

  /// The next audio samples, in the unit of the sound. The numbers do not depend on how samples are divided into blocks
  /// if forces and tunings are added before their start.
  void render(std::span<double> sound);

  /// The same, for an application that moves the sounds to its listeners itself: the sound of each body at 1 m in the
  /// direction of its listener, [bodies x samples]; [samples] without bodies. A piece that comes off meanwhile sounds
  /// with the body that broke.
  void render_each(std::span<double> sounds);

  /// The audio sample that is rendered next.
  [[nodiscard]] std::int64_t now() const;

  /// Audio samples by which sounds are late.
  [[nodiscard]] std::int64_t delay() const;

  /// What was chosen since the last call.
  [[nodiscard]] std::vector<Choice> take_choices();

  /// Bodies that broke since the last call. Their pieces are bodies from then on; forces on the body that broke act on
  /// the piece that is nearest, with the share of the mass that the piece has.
  [[nodiscard]] std::vector<Fracture> take_fractures();

  [[nodiscard]] std::size_t active() const;  ///< proxies that sound

  /// Of a body or a piece. Its only level is the present one if it has cracks.
  [[nodiscard]] const BodyOptions& body(std::size_t body) const;

  /// Whether a body did not fall apart into pieces.
  [[nodiscard]] bool is_whole(std::size_t body) const;

  /// The vibration of a body that is whole, at the level that sounds or sounded last.
  [[nodiscard]] Fragment motion(std::size_t body) const;

  /// Springs per second of sound of a level at a divisor of the rate.
  [[nodiscard]] double cost(std::size_t body, std::size_t level, int divisor) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace idiophone::proxies
