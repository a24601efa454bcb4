#pragma once
// Which modes of the bodies on a stage are heard, within a budget. Modes are chosen in groups of neighbours, because
// the processor computes a group as fast as one mode.

#include <span>
#include <vector>

#include "idiophone/instruments/voices/map_detail.hpp"
#include "map_body.hpp"
#include "map_costs.hpp"
#include "masking_threshold.hpp"

namespace idiophone::voices {

/// Allocates in its constructor only.
class ModeChoice {
 public:
  /// @param receivers  that each body is heard by
  ModeChoice(const MapDetail& detail, std::span<MapBody* const> bodies, std::size_t receivers, int rate);

  /// For the interval that begins now. Bodies on which forces act, or whose stretching couples the modes, are heard in
  /// full, whatever they cost. Of the others those groups are heard for which the budget suffices: first what is not
  /// masked, by the priority of the body, then by how far it is above what masks it. What was heard before costs for
  /// another interval, in which it fades. So new groups may have to wait for that long. While bodies are struck,
  /// room is kept for others that may be.
  [[nodiscard]] MapChoice choose(std::span<MapBody* const> bodies, std::int64_t sample);

  /// From the next choice on.
  void set_budget(double budget);

  /// With the budget of another one, whose place it takes.
  void go_on_from(const ModeChoice& other);

  /// Whether the budget has or had a limit, so that something may be unheard.
  [[nodiscard]] bool is_limited() const { return is_limited_; }

 private:
  /// A group of modes that could be heard.
  struct Candidate {
    std::size_t body, group;
    double loudest;           ///< power of its loudest mode, Pa^2
    double priority;          ///< of the body
    bool was_heard;           ///< until now
    double audibility = 0.0;  ///< power of a mode over what masks it, of the mode for which it is largest
  };
  /// What is heard of a body.
  struct Part {
    std::size_t first;  ///< of its groups in those of all bodies
    std::size_t groups;
    bool sounds = false;
    bool is_driven = false;  ///< by forces, or its modes by each other
    bool moves = false;      ///< or the listener does
    double priority = 0.0;
    double cost = 0.0;  ///< of what is heard or fades; 0: nothing does
  };

  void measure(std::span<MapBody* const> bodies, std::int64_t sample);
  void measure(Player& player, std::size_t body, std::int64_t sample);
  void find_audibility(std::span<MapBody* const> bodies);
  void spend();
  [[nodiscard]] double cost_of(const Candidate& candidate) const;
  [[nodiscard]] bool has_room_for(const Candidate& candidate) const;
  void pay(const Candidate& candidate, bool is_heard);
  void claim();
  MapChoice apply(std::span<MapBody* const> bodies);
  [[nodiscard]] std::span<const double> powers(std::size_t group) const;

  MapDetail detail_;
  bool is_limited_;
  MapCosts costs_;
  std::vector<Part> parts_;    // [bodies]
  std::vector<double> power_;  // [groups of all bodies x modes in a group] Pa^2
  std::vector<char> heard_;    // [groups of all bodies]
  std::vector<Candidate> candidates_;
  std::vector<Claim> claims_;  // of the bodies that are heard
  MaskingThreshold threshold_;
  double cost_ = 0.0;     // so far
  double reserve_ = 0.0;  // for bodies that will be struck before the next choice
};

}  // namespace idiophone::voices
