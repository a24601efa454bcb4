#pragma once
// From the contacts of a physics engine to forces at audio rate.

#include <map>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "idiophone/instruments/touching/contact_events.hpp"
#include "idiophone/instruments/touching/contact_track.hpp"
#include "idiophone/instruments/touching/led_stroke.hpp"

namespace idiophone::touching {

/// A force on the first body of a contact, and the opposite one on the second.
struct ContactForce {
  std::array<std::int32_t, 2> bodies{};
  resonators::PointForce force;  ///< in the world
  double impulse = 0.0;          ///< of an impact, N s; infinite for a stroke, which lasts
};

class ContactSounds {
 public:
  /// @param surfaces  checked
  /// @param masses    of the bodies, kg
  ContactSounds(std::vector<Surface> surfaces, std::vector<double> masses, int rate, std::size_t most_strokes,
                std::uint64_t seed);

  /// What the contacts of a step do from an audio sample on.
  /// @param events    checked
  /// @param duration  of the step, s
  [[nodiscard]] std::vector<ContactForce> step(std::span<const ContactEvent> events, std::int64_t start,
                                               double duration);

  /// A body gets a number. @param mass  kg
  void join(std::size_t body, double mass);

  /// What scrapes or rolls on a body comes to its end, and its loads are forgotten.
  void leave(std::size_t body);

  [[nodiscard]] std::size_t strokes() const { return strokes_; }
  [[nodiscard]] std::uint64_t impacts() const { return impacts_; }
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }

 private:
  struct Contact {
    ContactTrack track;
    ContactEvent last;  ///< with the impulse of the whole step
    std::optional<LedStroke> stroke;
    bool is_refused = false;  ///< its stroke was left out
  };
  [[nodiscard]] double mass_of(const ContactEvent& event) const;
  void gather(std::span<const ContactEvent> events);
  void add_impact(const Contact& contact, double impulse, std::vector<ContactForce>& forces);
  void lead_stroke(Contact& contact, double load);
  void add_stroke(Contact& contact, std::vector<ContactForce>& forces);

  std::vector<Surface> surfaces_;
  std::vector<double> masses_;
  int rate_;
  std::size_t most_strokes_;
  std::mt19937_64 random_;
  std::map<std::uint64_t, Contact> contacts_;
  std::int64_t start_ = 0;  // audio sample of the step
  double duration_ = 0.0;   // of the step, s
  std::size_t strokes_ = 0;
  std::uint64_t impacts_ = 0, left_out_ = 0;
};

}  // namespace idiophone::touching
