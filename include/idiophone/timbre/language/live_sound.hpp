#pragma once
// A timbre tree that sounds inside an application, which sets its parameters as time goes by (Hahn 1995: routines that
// are "incorporated directly into the application performing the motion control").

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "idiophone/timbre/language/timbre_tree.hpp"

namespace idiophone::timbre {

class Control;
class Graph;

struct LiveSoundOptions {
  int rate = 44100;                           ///< audio samples per second
  double smoothing = 0.02;                    ///< s, after which 99 % of a change of a parameter are heard; 0: at once
  std::uint64_t seed = 1;                     ///< of the tree's random vectors: equal seeds are the same body
  std::uint64_t start = 0;                    ///< number of the start: other starts have another noise
  std::map<std::string, double> live{};       ///< parameters that set() changes, with their first values
  std::map<std::string, double> constants{};  ///< values of others; without one, a parameter has its default
};

/// One start of a sound. It ends with the object; an application has as many as it likes.
class LiveSound {
 public:
  /// @throws deck::DeckError for a tree that is wrong, for a parameter without a default that has no value, for a
  ///         parameter that is not there, and for a live one where a node needs a number that does not change;
  ///         std::invalid_argument for options out of range
  explicit LiveSound(const Tree& tree, const LiveSoundOptions& options = {});
  ~LiveSound();
  LiveSound(LiveSound&&) noexcept;
  LiveSound& operator=(LiveSound&&) noexcept;
  LiveSound(const LiveSound&) = delete;
  LiveSound& operator=(const LiveSound&) = delete;

  /// Moves a parameter towards a value, from the next block on. Another thread may render meanwhile.
  /// @throws std::invalid_argument for a value that is not finite, or a parameter that is not live
  void set(const std::string& parameter, double value);

  /// The next samples, any number. Allocates nothing and takes no lock.
  /// @throws std::runtime_error for a sample that is not finite, with the place of the node that it comes from
  void render(std::span<double> samples);

  /// How long the magnitude of all samples has been at most `level`, s.
  [[nodiscard]] double silent_for() const;

  /// Below this magnitude a sample counts as silence: 180 dB below 1.
  static constexpr double level = 1e-9;

 private:
  std::map<std::string, std::shared_ptr<Control>> controls_;  // by the parameter's name
  std::unique_ptr<Graph> graph_;
  double silent_samples_ = 0.0;
  int rate_;
};

}  // namespace idiophone::timbre
