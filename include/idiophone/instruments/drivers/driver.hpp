#pragma once
// Whoever asks bodies to sound, in the order of time: a score, players, or the motion of a result.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "idiophone/instruments/drivers/event.hpp"

namespace idiophone::drivers {

class Driver {
 public:
  Driver() = default;
  virtual ~Driver() = default;
  Driver(const Driver&) = delete;
  Driver(Driver&&) = delete;
  Driver& operator=(const Driver&) = delete;
  Driver& operator=(Driver&&) = delete;

  /// Adds what is to happen before an audio sample and was not asked for yet.
  /// @param now  audio sample at which begins what a player asks for
  virtual void ask(std::int64_t now, std::int64_t until, std::vector<Event>& events) = 0;

  /// Whether somebody plays, so that only a signal ends the performance.
  [[nodiscard]] virtual bool is_live() const { return false; }

  /// What it could not ask for, in words for the end of a performance; empty if there is nothing to say.
  [[nodiscard]] virtual std::string complaint() const { return {}; }
};

using Drivers = std::vector<std::unique_ptr<Driver>>;

/// Events that are known before, each asked for in time.
class KnownEvents : public Driver {
 public:
  /// @param events  in any order; those of one start keep their order
  explicit KnownEvents(std::vector<Event> events);

  void ask(std::int64_t now, std::int64_t until, std::vector<Event>& events) override;

 private:
  std::vector<Event> events_;  // by their start
  std::size_t next_ = 0;
};

/// The events of a score, whose forces are computed when they are asked for.
class ScoreDriver : public Driver {
 public:
  /// @param events  in any order; those of one time keep their order
  /// @param seed    of roughness
  ScoreDriver(std::vector<score::ScoreEvent> events, std::uint64_t seed, int rate);

  void ask(std::int64_t now, std::int64_t until, std::vector<Event>& events) override;

 private:
  std::vector<score::ScoreEvent> events_;  // by their time
  std::uint64_t seed_;
  int rate_;
  std::size_t next_ = 0;
};

}  // namespace idiophone::drivers
