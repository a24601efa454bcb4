#pragma once
// A timbre tree as a voice: each blow starts its sound, with parameters that say how strong the blow was. It allocates:
// played live, it goes into a BufferedVoice.

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/instruments/voices/arrivals.hpp"
#include "idiophone/instruments/voices/head_filter.hpp"
#include "idiophone/instruments/voices/moving_points.hpp"
#include "idiophone/instruments/voices/voice.hpp"
#include "idiophone/timbre/language/graph.hpp"

namespace idiophone::timbre {

/// The parameters `force` (N, the largest), `impulse` (N s) and `speed` (m/s) are those of what excites it; `size`,
/// `friction` and `tension` those of the last tuning, or 1. All others have their defaults. It sounds from the place of
/// the force, as loud at 1 m as the tree says; if there is no listener, as the tree says.
class TreeVoice : public voices::Voice {
 public:
  /// @param seed  of its random numbers
  /// @throws deck::DeckError for a tree that is wrong, or that has other parameters without a default
  TreeVoice(Tree tree, std::string name, voices::Audience audience, std::uint64_t seed, int rate);

  [[nodiscard]] const std::vector<std::string>& bodies() const override { return bodies_; }
  [[nodiscard]] std::optional<Vector3> centre(std::size_t /*body*/) const override { return {}; }
  void require_tunable(std::size_t body, const score::Tuning& tuning) const override;
  void excite(std::size_t body, const drivers::Excitation& excitation, std::int64_t sent) override;
  void tune(std::size_t body, const score::Tuning& tuning, std::int64_t start) override;
  void hear_at(const voices::ListenerPlace& place) override;
  /// @throws std::runtime_error for a node whose samples are not finite
  void render(std::span<double> sound, std::int64_t clock) override;

 private:
  /// What is asked for: a start of the sound, or a tuning of later ones.
  struct Request {
    std::int64_t start = 0;
    std::optional<drivers::Strength> strength;
    Vector3 at = Vector3::Zero();
    score::Tuning tuning;
  };
  /// A start that sounds.
  struct Instance {
    Graph graph;
    Vector3 at;
    std::int64_t quiet = 0;  ///< audio samples since it was heard
    double gain = 1.0;
    bool fades = false;
  };

  void ask(Request request);
  [[nodiscard]] bool has_parameter(const std::string& name) const;
  [[nodiscard]] Bindings bindings_of(const drivers::Strength& strength) const;
  void start_due();
  void start(const Request& request);
  /// The sound of all instances: added to the plain sound, or on its way to the receivers.
  void emit(std::size_t count);
  void send(const Instance& instance, std::size_t count);
  void take(std::span<double> sound);
  void take_with_head(std::span<double> sound);
  void turn_head();

  Tree tree_;
  std::vector<std::string> bodies_;
  voices::Audience audience_;
  std::uint64_t seed_;
  int rate_;
  score::Tuning tuning_;
  std::deque<Request> requests_;            // by their start
  voices::MovingPoints points_;             // where the listener is; none if nobody hears
  std::vector<Instance> instances_;         // in the order of their starts
  std::vector<voices::Arrivals> arrivals_;  // [points]
  std::optional<voices::HeadFilter> head_;
  std::optional<Vector3> head_target_;  // place from which the head is to hear next
  std::int64_t head_left_ = 0;          // audio samples of the change to the next responses
  Vector3 last_at_ = Vector3::Zero();   // of the last start
  std::vector<double> sound_, plain_;   // [block]
  std::int64_t now_ = 0;
  std::uint64_t starts_ = 0;
};

}  // namespace idiophone::timbre
