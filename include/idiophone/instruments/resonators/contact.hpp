#pragma once
// Contacts that feel the vibration of the body that they touch.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/instruments/resonators/resonator_bank.hpp"
#include "idiophone/instruments/resonators/smooth_rise.hpp"

namespace idiophone::resonators {

/// How a player wants a contact to be.
struct ContactMotion {
  double speed = 0.0;  ///< along the surface, m/s
  double load = 0.0;   ///< N
};

/// What touches a body at one point. Its force is constant over an audio sample. Then the force times the way of the
/// point is exactly the work that the modes get.
class Contact {
 public:
  Contact() = default;
  virtual ~Contact() = default;
  Contact(const Contact&) = delete;
  Contact(Contact&&) = delete;
  Contact& operator=(const Contact&) = delete;
  Contact& operator=(Contact&&) = delete;

  /// On the body in the next audio sample, N, if the point goes `free + compliance force`. Realtime-safe.
  /// @param free        way of the point in the sample without this force, m
  /// @param compliance  m/N; not negative
  [[nodiscard]] virtual double force(double free, double compliance) const = 0;

  /// The sample is over. Realtime-safe.
  /// @param way    of the point, m
  /// @param force  that it had, N
  virtual void advance(double way, double force) = 0;

  /// From now on a player leads it, if anybody can. Realtime-safe.
  /// @param samples  in which the motion is reached, evenly
  virtual void lead(const ContactMotion& /*motion*/, std::int64_t /*samples*/) {}

  /// Whether it has left the body for good. Realtime-safe.
  [[nodiscard]] virtual bool is_over() const { return false; }
};

/// A point of a body and a direction, as its modes have them.
struct ContactPoint {
  std::vector<ModeGroup> displacement;  ///< [groups] Re(displacement z) summed over the modes, m
  std::vector<ModeGroup> by_mean;       ///< [groups] as in Drive
  std::vector<ModeGroup> by_slope;      ///< [groups] zero, because the force has no slope
  double lowest = 0.0;                  ///< angular frequency of the lowest mode, rad/s; above 0
};

/// The contacts that act on a body. They feel each other through it. Allocates in its constructor only.
class PointContacts {
 public:
  static constexpr std::size_t most = 16;

  explicit PointContacts(int rate) : rate_(rate) { touches_.reserve(most); }

  /// At most `most`. Both stay where they are until remove().
  void add(Contact& contact, const ContactPoint& point);
  void remove(const Contact& contact);

  /// Called when the points have changed. Realtime-safe.
  void find_compliance();

  [[nodiscard]] std::size_t count() const { return touches_.size(); }
  [[nodiscard]] const ContactPoint& point(std::size_t touch) const { return *touches_[touch].point; }

  /// The forces of the next audio sample, found one after the other until they change no more, at most 100 times. A
  /// single contact is exact. The contacts take the sample.
  /// @param free    way of each point in the sample without contacts, m
  /// @param yields  stretching lowers the compliance of two points by the product of theirs, (m/N)^1/2
  /// @param sample  of the block, in which the force is kept
  /// @return [contacts] N
  std::span<const double> advance(std::span<const double> free, std::span<const double> yields, std::size_t sample);

  /// Of one contact over the samples of the block.
  [[nodiscard]] std::span<const ForcePiece> pieces(std::size_t touch, std::size_t samples) const {
    return std::span(touches_[touch].pieces).first(samples);
  }

 private:
  struct Touch {
    Contact* contact;
    const ContactPoint* point;
    SmoothRise rise;
    double before = 0.0;  ///< force in the last sample, N
    std::array<ForcePiece, ResonatorBank::most_samples> pieces{};
  };
  void keep(Touch& touch, double force, std::size_t sample) const;
  [[nodiscard]] double compliance(std::span<const double> yields, std::size_t touch, std::size_t other) const;
  [[nodiscard]] double way(std::span<const double> free, std::span<const double> yields, std::size_t touch) const;

  int rate_;
  std::vector<Touch> touches_;
  std::array<std::array<double, most>, most> compliance_{};  // way of the first point for a force at the second, m/N
  std::array<double, most> forces_{};
};

}  // namespace idiophone::resonators
