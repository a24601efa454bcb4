#pragma once
// Which bodies contacts strike, within a budget.

#include <cstdint>
#include <span>
#include <vector>

namespace idiophone::engines {

/// All modes of a body are computed while forces act on it, on until the stage chooses again what is heard, and on
/// while what was not chosen fades. So a budget has to limit how many bodies are struck: those with the loudest forces
/// are.
class StruckBodies {
 public:
  /// @param budget  processor time per time of sound; may be infinite
  explicit StruckBodies(double budget) : budget_(budget) {}

  /// A body gets a number. @param cost  while it is struck, processor time per time of sound
  void join(std::size_t body, double cost);

  /// The bodies for which there is room beside those that are struck as loudly. What is struck less loudly takes no
  /// room from them: while it fades, the cost is above the budget. One body has room alone, whatever it costs.
  /// @param loudness  [bodies] of the forces from an audio sample on; below 0: there are none
  /// @return [bodies]
  [[nodiscard]] std::vector<bool> choose(std::span<const double> loudness, std::int64_t start);

  /// The force on a chosen body acts until an audio sample.
  void act(std::size_t body, std::int64_t end);

 private:
  struct Body {
    double cost = 0.0;
    double loudness = 0.0;  ///< of the loudest force since it was not struck
    std::int64_t end = 0;   ///< audio sample at which the forces are over and what they left has faded
  };
  /// Of the other bodies that are struck at an audio sample at least as loudly.
  [[nodiscard]] double cost_of_others(std::size_t body, double loudness, std::int64_t sample) const;

  double budget_;
  std::vector<Body> bodies_;
};

}  // namespace idiophone::engines
