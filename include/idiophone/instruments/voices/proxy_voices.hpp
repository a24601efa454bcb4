#pragma once
// Mass-spring proxies as a voice of many bodies, which share a budget of computing time. It locks nothing, but it
// allocates: played live, it goes into a BufferedVoice.

#include <memory>
#include <string>
#include <vector>

#include "idiophone/instruments/proxies/engine.hpp"
#include "idiophone/instruments/voices/voice.hpp"

namespace idiophone::voices {

/// A force on a body of an engine. @param body  its number there
[[nodiscard]] proxies::Force proxy_force(std::size_t body, const resonators::PointForce& force);

class ProxyVoices : public Voice {
 public:
  /// @param engine    has the bodies, each at the place of the listener
  /// @param bodies    their names
  /// @param centres   [bodies] of mass, m
  /// @param channels  that all get the same sound: that in the middle of the receivers
  ProxyVoices(proxies::Engine engine, std::vector<std::string> bodies, std::vector<Vector3> centres,
              std::size_t channels);

  [[nodiscard]] const std::vector<std::string>& bodies() const override { return bodies_; }
  [[nodiscard]] std::optional<Vector3> centre(std::size_t body) const override { return centres_[body]; }
  void require_tunable(std::size_t body, const score::Tuning& tuning) const override;
  void excite(std::size_t body, const drivers::Excitation& excitation, std::int64_t sent) override;
  void tune(std::size_t body, const score::Tuning& tuning, std::int64_t start) override;
  void hear_at(const ListenerPlace& place) override;
  [[nodiscard]] std::int64_t lead() const override { return engine_.delay(); }
  void render(std::span<double> sound, std::int64_t clock) override;

  /// What the engine chose since the last call. Not while another thread renders.
  [[nodiscard]] std::vector<proxies::Choice> take_choices() { return engine_.take_choices(); }

 private:
  void advance(std::span<double> sound);

  proxies::Engine engine_;
  std::vector<std::string> bodies_;
  std::vector<Vector3> centres_;
  std::size_t channels_;
  std::vector<ListenerPlace> moves_;  // that are not reached, by their end
  std::vector<double> mono_;
};

}  // namespace idiophone::voices
