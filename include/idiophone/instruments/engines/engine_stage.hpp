#pragma once
// Bodies that sound in a game or a simulator (docs/use/engines.md). Only the standard library is needed.

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "idiophone/instruments/touching/contact_events.hpp"

namespace idiophone::sound_maps {
struct SoundMap;
}
namespace idiophone::proxies {
struct StoredBody;
}

namespace idiophone::engines {

using touching::ContactEvent, touching::Surface, touching::Triple;

/// Where a body is: from the coordinates of its sound map or proxy to those of the world.
struct Pose {
  Triple position{};                          ///< of the origin of the map or proxy, m
  std::array<double, 4> turn = {0, 0, 0, 1};  ///< unit quaternion x, y, z, w
};

/// A sound map that any number of bodies share.
using SharedMap = std::shared_ptr<const sound_maps::SoundMap>;

/// Reads a voice file, which `idiophone export MAP.map.h5 --voice FILE.voice` writes.
/// @throws std::runtime_error when it can't be read, is no voice file, is damaged or of another version
[[nodiscard]] SharedMap read_map(const std::filesystem::path& file);
/// @param bytes  of the whole file
/// @param name   of the file, for messages
[[nodiscard]] SharedMap read_map(std::span<const char> bytes, const std::string& name);

/// A mass-spring proxy that any number of bodies share: masses and springs, in one or several levels of detail.
using SharedProxy = std::shared_ptr<const proxies::StoredBody>;

/// Reads a proxy file, which `idiophone export DECK --proxy FILE.proxy` writes.
/// @throws std::runtime_error when it can't be read, is no proxy file, is damaged or of another version
[[nodiscard]] SharedProxy read_proxy(const std::filesystem::path& file);
/// @param bytes  of the whole file
/// @param name   of the file, for messages
[[nodiscard]] SharedProxy read_proxy(std::span<const char> bytes, const std::string& name);

/// What an engine needs to know of a map or a proxy to move its body.
struct BodyFacts {
  std::string body;      ///< its name
  double mass = 0.0;     ///< kg
  Triple centre{};       ///< of mass, in the coordinates of the map or proxy, m
  Triple low{}, high{};  ///< corners of the box around its surface, m
  double young = 2e11;   ///< Young's modulus, Pa; of steel where the map has no material
  double poisson = 0.3;  ///< Poisson's ratio; likewise; of proxies 1/4
};
[[nodiscard]] BodyFacts facts_of(const SharedMap& map);
[[nodiscard]] BodyFacts facts_of(const SharedProxy& proxy);

/// How the body differs from its map or proxy.
struct Tuning {
  double tension = 1.0;   ///< of proxies: times the stiffness of the springs, 1e-4 to 1e4
  double friction = 1.0;  ///< times the damping by the material, 0 to 1e6
  double size = 1.0;      ///< times the lengths, of the same material, 0.01 to 100
};

struct StageOptions {
  int rate = 48000;                                         ///< audio samples per second, 8000 to 384000
  std::vector<Triple> ears = {{0, 0, 1}};                   ///< places of the receivers at first, m; 1 to 4: channels
  double latency = 0.02;                                    ///< s, by which sound follows contacts at least
  double budget = std::numeric_limits<double>::infinity();  ///< processor time per time of sound, of maps and proxies
                                                            ///< together; what is less audible is left out
  double speed = 1.0;                                       ///< of the machine, for the budget: measured_speed()
  std::size_t most_strokes = 16;                            ///< contacts that scrape or roll at once; fewer if
                                                            ///< they would cost over a quarter of the budget
  std::uint64_t seed = 1;                                   ///< of roughness and of unknown moments
  std::size_t most_proxies = 8;                             ///< proxies that may sound at once, at least 1
  double air_density = 1.204;                               ///< around proxies, kg/m3; maps have their own
  double air_speed = 343.0;                                 ///< of sound around proxies, m/s; likewise
};

/// How fast this machine computes sound maps, relative to the machine on which the costs were measured. Bodies are
/// rendered for some 0.1 s of processor time. What else the machine does then makes it slower.
[[nodiscard]] double measured_speed();

/// What happened lately.
struct StageReport {
  std::size_t sounding = 0;    ///< bodies with maps; this and the next four only with a budget
  std::size_t modes = 0;       ///< of these bodies
  std::size_t heard = 0;       ///< of these modes
  double cost = 0.0;           ///< of what is heard or fades, processor time per time of sound, as it is estimated
  double loss = 0.0;           ///< share of the power that is left out
  std::size_t strokes = 0;     ///< contacts that scrape or roll
  std::uint64_t impacts = 0;   ///< so far
  std::uint64_t left_out = 0;  ///< strokes and forces for which there was no room, and contacts while nobody
                               ///< rendered, so far
  std::size_t proxies = 0;     ///< that sound
  double proxy_cost = 0.0;     ///< of these, processor time per time of sound, as it is estimated
  std::uint64_t gaps = 0;      ///< times when proxies fell silent because step() was late, so far
};

/// Sound maps and proxies that contacts excite. One thread calls render(), another one all else.
class EngineStage {
 public:
  /// @param bodies    from the beginning; may be none
  /// @param surfaces  at least one
  /// @throws std::runtime_error for numbers out of their range
  EngineStage(StageOptions options, const std::vector<SharedMap>& bodies, std::vector<Surface> surfaces);
  EngineStage(const EngineStage&) = delete;
  EngineStage(EngineStage&&) = delete;
  EngineStage& operator=(const EngineStage&) = delete;
  EngineStage& operator=(EngineStage&&) = delete;
  ~EngineStage();

  [[nodiscard]] std::size_t channels() const;

  /// A body joins: it can be placed and struck at once, and sounds as if it had been there from the start. Takes
  /// memory; render() goes on meanwhile.
  /// @return its number, the lowest that is free: those of the start count from 0
  /// @throws std::runtime_error without a map
  std::size_t add(const SharedMap& map);

  /// The same with a proxy. step() computes its sound up to the next step; render() plays what is ready.
  /// @throws std::runtime_error without a proxy, or when its springs are too fast for the rate
  std::size_t add(const SharedProxy& proxy);

  /// A body leaves. What was told of it happens in the step that follows; then it fades within 1024 audio samples. Its
  /// number is free when it has faded; until then nothing can be told of it.
  /// @throws std::runtime_error if there is no such body
  void remove(std::size_t body);

  /// From the next step on, the body is there. @throws std::runtime_error as for contact()
  void place(std::size_t body, const Pose& pose);

  /// From the next step on, a body has other springs, damping or lengths, whether it sounds or not. What rings goes on.
  /// @throws std::runtime_error as for contact(), for a tension of a map, numbers out of their range, and springs that
  ///   would be too fast for the rate
  void tune(std::size_t body, const Tuning& tuning);

  /// From the next step on, the ears are there. @param ears  as many as there are channels, m
  void listen(std::span<const Triple> ears);

  /// What happened in the step that follows.
  /// @throws std::runtime_error for a body or a surface that there is not, a body that touches itself, a normal that is
  ///   no unit vector, and numbers out of their range
  void contact(const ContactEvent& event);

  /// The contacts since the last call happened in a step of the physics.
  /// @param duration  1e-5 to 1 s
  void step(double duration);

  /// So far.
  [[nodiscard]] StageReport report();

  /// The audio thread's part: the next samples, Pa, [frames x channels]. Takes no lock and no memory.
  /// @throws std::runtime_error when `sound` is not whole frames
  void render(std::span<double> sound);
  /// The same in single precision. @param full_scale  pressure that becomes 1, above 0 Pa
  void render(std::span<float> sound, double full_scale);

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace idiophone::engines
