#pragma once
// What a stage consists of, and its time.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "idiophone/instruments/engines/engine_stage.hpp"
#include "idiophone/instruments/score/action.hpp"
#include "idiophone/instruments/touching/contact_sounds.hpp"
#include "stage_bodies.hpp"
#include "stage_proxies.hpp"

namespace idiophone::engines {

class EngineStage::Parts {
 public:
  /// @throws as EngineStage()
  Parts(StageOptions stage_options, const std::vector<SharedMap>& maps, std::vector<Surface> surfaces);

  /// Numbers that bodies have or had.
  [[nodiscard]] std::size_t size() const { return std::max(bodies.size(), proxies.size()); }

  /// The lowest.
  [[nodiscard]] std::size_t free_number() const;

  /// @throws std::runtime_error if there is no such body, or it was removed
  void require_body(std::size_t body) const;

  /// Where contacts are now. @return whether anybody hears them
  bool keep_time(double duration);

  /// What was told of the bodies since the last step.
  void tune();

  /// The bodies that were removed before the step leave when its contacts have struck: what they rested on, or what
  /// rested on them, feels their load until then.
  void let_leave();

  /// What was chosen to be heard since the last call; nothing without a budget.
  void note_choices();

  StageOptions options;
  const std::size_t channels;
  std::size_t surface_count;
  std::shared_ptr<voices::SharedBudget> shared;
  StageBodies bodies;
  StageProxies proxies;
  touching::ContactSounds sounds;
  std::vector<ContactEvent> events;                            // of the step that follows
  std::vector<std::size_t> leaving;                            // bodies that were removed since the last step
  std::vector<std::pair<std::size_t, score::Tuning>> tunings;  // of bodies, since the last step
  double clock = 0.0;                                          // audio sample at which the next step begins
  std::int64_t start = 0;                                      // of the present step
  double pause = 0.0;                                          // since the audio thread rendered last, s
  std::int64_t last_played = 0;
  std::uint64_t left_out = 0;
  StageReport last_report;
  // of the audio thread
  std::atomic<std::int64_t> rendered{0};
  std::array<double, 1024> piece{};
};

}  // namespace idiophone::engines
