#pragma once
// Open Sound Control over UDP, through liblo (docs/use/play.md, OSC).

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "idiophone/instruments/score/score.hpp"

namespace idiophone::drivers {

/// What messages ask for. May throw std::exception, which becomes a warning.
struct OscActions {
  std::function<void(const score::ScoreEvent&)> play;
  /// A stroke that goes on, with the name that the player gives it. @param stroke  has a score::Stroke or a score::Bow
  std::function<void(const std::string& name, const score::ScoreEvent& stroke)> begin_stroke{};
  std::function<void(const std::string& name, double speed, double load)> change_stroke{};  ///< m/s, N
  std::function<void(const std::string& name)> end_stroke{};
  std::function<void(const Vector3& position)> move_listener;  ///< m
};

class OscServer {
 public:
  static constexpr std::size_t most_packets = 64;  ///< that a poll handles

  /// @param address  of this machine, as a number: 127.0.0.1 hears this machine only, 0.0.0.0 all networks
  /// @param port     UDP; 0 takes any free port
  /// @param bodies   their names, as messages have them
  /// @throws std::runtime_error when the port can't be used
  OscServer(const std::string& address, int port, std::vector<std::string> bodies, OscActions actions);
  ~OscServer();
  OscServer(const OscServer&) = delete;
  OscServer(OscServer&&) = delete;
  OscServer& operator=(const OscServer&) = delete;
  OscServer& operator=(OscServer&&) = delete;

  /// Handles the packets that have come in, without waiting; at most `most_packets`, and none after 10 ms, so that a
  /// flood of them holds nothing up. Logs messages that are wrong, with the reason.
  void poll();

  /// The UDP port on which it hears.
  [[nodiscard]] int port() const;

  /// Messages that were wrong.
  [[nodiscard]] std::size_t refused() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// An argument of a message as text: a word, or a number.
using OscArguments = std::vector<std::string>;

/// The event of a message, in YAML: /blow, /scrape, /bow, ... with their arguments in order, or /event with a text.
/// @throws std::runtime_error when there is no such address, or the number of arguments is wrong
[[nodiscard]] std::string event_text(const std::string& address, const OscArguments& arguments);

}  // namespace idiophone::drivers
