#pragma once
// What an engine knows: its voices, what waits for its time, and the pieces of bodies that broke.

#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <vector>

#include "idiophone/instruments/proxies/engine.hpp"
#include "proxy_voice.hpp"

namespace idiophone::proxies {

struct Engine::State {
  EngineOptions options;
  std::vector<Voice> voices;
  std::deque<Force> waiting;   // by their start, then in the order of their arrival
  std::deque<Tuning> tunings;  // likewise
  std::vector<Choice> choices;
  std::vector<Fracture> fractures;
  std::set<std::size_t> removed;                           // numbers that are free as soon as they do not sound
  std::map<std::size_t, std::vector<std::size_t>> pieces;  // of bodies that broke
  std::map<std::size_t, std::size_t> parents;              // of pieces
  std::int64_t now = 0;
  std::vector<double> alone;  // of one body

  [[nodiscard]] std::size_t number_of(const Voice& voice) const {
    return static_cast<std::size_t>(&voice - voices.data());
  }

  /// @throws std::invalid_argument
  void require_body(std::size_t body) const;

  /// Active voices, those of the smallest priority first.
  [[nodiscard]] std::vector<Voice*> active();

  void note(const Voice& voice, Choice::Kind kind, std::int64_t sample);

  /// The budget without what others take of it with at least this priority.
  [[nodiscard]] double budget_for(double priority) const;

  /// Fades out bodies of smaller priorities until one more body with this cost has room. Returns whether it has.
  bool make_room(double priority, double cost, std::int64_t sample);

  /// The most expensive detail for which there is budget. A body with the greatest priority may take all that is left;
  /// others may take their share of the budget, or the cheapest detail.
  [[nodiscard]] std::size_t choose_detail(const Voice& voice, double priority);

  /// Fades out bodies of the smallest priorities until the others keep within the limits.
  void keep_limits();

  /// A force on a body in pieces acts on the nearest one, with the share of the mass that this has: what strikes or
  /// rests on it moves the piece as it would have moved the body, and can't press a splinter with the force for a body.
  void begin(Force force, std::int64_t sample);

  void begin_due(std::int64_t sample);

  /// kg
  [[nodiscard]] double mass_of(std::size_t body) const { return voices[body].body().levels.front()->inertia().mass; }

  /// A body, or the piece of it that is nearest to a point.
  [[nodiscard]] std::size_t present_body(std::size_t body, const Vector3& point) const;

  /// The springs and masses of each body break that are overloaded more than those near them.
  void break_overloaded();

  static void crack(Voice& voice, const Fragment& cracked);

  void fracture(std::size_t body, const Fragment& whole, std::vector<Fragment> parts);

  /// A piece begins to sound if there is room for it.
  Piece add_piece(std::size_t body, Fragment& part);

  /// The body that was there when `count` bodies were: this one, or that of which it is a piece.
  [[nodiscard]] std::size_t ancestor(std::size_t body, std::size_t count) const;

  /// From now until a force or tuning begins, or a body may break.
  [[nodiscard]] std::size_t samples_without_change(std::size_t most) const;

  /// The next audio samples of the bodies that sound.
  /// @param render  renders a voice for some samples from an offset on. Returns the number after which it is stable
  template <class Render>
  void advance(std::size_t samples, const Render& render) {
    for (std::size_t done = 0; done < samples;) {
      begin_due(now);
      break_overloaded();
      const std::size_t count = samples_without_change(samples - done);
      for (Voice& voice : voices) {
        if (voice.sounds()) {
          const std::size_t sounded = render(voice, done, count);
          if (!voice.sounds()) {
            note(voice, Choice::Kind::end, now + static_cast<std::int64_t>(sounded));
          }
        }
      }
      now += static_cast<std::int64_t>(count);
      done += count;
    }
  }
};

}  // namespace idiophone::proxies
