#pragma once
// Strokes and bows that a player begins, leads and ends.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "idiophone/instruments/drivers/event.hpp"
#include "idiophone/instruments/resonators/running_stroke.hpp"

namespace idiophone::drivers {

class LiveStrokes {
 public:
  static constexpr std::size_t most = 16;  ///< that go on at once

  /// @param seed  of roughness
  /// @param lead  audio samples by which voices know ahead what begins
  /// @param patience  s, after which a stroke ends that nobody changes, because its player may be gone; none: never
  LiveStrokes(std::uint64_t seed, int rate, std::int64_t lead, std::optional<double> patience = std::nullopt)
      : seed_(seed), rate_(rate), lead_(lead), patience_(patience) {}

  /// @param name  that the player gives the stroke; no other that goes on has it
  /// @param now   audio sample
  /// @throws std::runtime_error when one has the name, or too many go on
  void begin(const std::string& name, std::size_t body, const score::Stroke& stroke, std::int64_t now);
  void begin(const std::string& name, std::size_t body, const score::Bow& bow, std::int64_t now);

  /// @param speed  m/s, 0 to 1000; of a bow also against its direction, from -1000 on
  /// @param load   N, 0 to 1e6
  /// @throws std::runtime_error when there is no such stroke, or no such speed or load
  void change(const std::string& name, double speed, double load);

  /// @throws std::runtime_error when there is no such stroke
  void end(const std::string& name);

  /// Whether one of the name goes on.
  [[nodiscard]] bool has(const std::string& name) const;

  /// Adds the forces that come next, and ends strokes of players that are gone. @param now  audio sample
  void ask(std::int64_t now, std::vector<Event>& events);

 private:
  /// Its forces are computed block by block.
  struct Stroke {
    resonators::RunningStroke forces;
    Strength strength;
    std::int64_t next;  ///< audio sample
    bool begins = true;
  };
  struct Running {
    std::size_t body;
    std::variant<Stroke, TouchLead> contact;  ///< a bow is where the player wants it to be
    std::int64_t heard;                       ///< audio sample at which the player last spoke of it
  };
  void require_room_for(const std::string& name) const;
  Running& find(const std::string& name);
  void go_on(std::size_t body, Stroke& stroke, std::vector<Event>& events) const;
  void end_forgotten();

  std::uint64_t seed_;
  int rate_;
  std::int64_t lead_;
  std::optional<double> patience_;  // s
  std::int64_t now_ = 0;            // audio sample
  std::map<std::string, Running> running_;
  std::vector<std::pair<std::size_t, Stroke>> ending_;  // with their bodies
  std::vector<Event> of_bows_;                          // that were not asked for yet
};

}  // namespace idiophone::drivers
