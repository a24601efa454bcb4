#pragma once
// The contacts that act on a body, or on several bodies that touch each other.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "idiophone/instruments/resonators/contact.hpp"
#include "idiophone/instruments/resonators/resonator_bank.hpp"
#include "idiophone/instruments/resonators/smooth_rise.hpp"

namespace idiophone::resonators {

/// Where a contact touches a body.
struct TouchedPoint {
  std::size_t body = 0;  ///< of those that touch each other
  const ContactPoint* point = nullptr;
};

/// What one body has of a contact.
struct ContactSide {
  std::size_t contact;        ///< its number among those that act
  const ContactPoint* point;  ///< of the body
  SmoothRise rise;            ///< of the force
  double free = 0.0;          ///< way of the point in the present audio sample without contacts, m
  double yield = 0.0;         ///< stretching lowers the compliance of two points by the product of theirs, (m/N)^1/2
  std::array<ForcePiece, ResonatorBank::most_samples> pieces{};  ///< of the force, in each sample of the block
};

/// The contacts feel each other through the bodies. Allocates in its constructor only.
class PointContacts {
 public:
  static constexpr std::size_t most = 16;          ///< that can come and go on a body
  static constexpr std::size_t most_staying = 16;  ///< points of a body in contacts that stay

  /// @param bodies   that touch each other
  /// @param staying  contacts that stay, of all bodies together
  explicit PointContacts(int rate, std::size_t bodies = 1, std::size_t staying = 0);

  /// All stay where they are until remove().
  /// @param points  one or two
  void add(Contact& contact, std::span<const TouchedPoint> points);
  void add(Contact& contact, const ContactPoint& point) {
    const TouchedPoint touched{.body = 0, .point = &point};
    add(contact, {&touched, 1});
  }
  void remove(const Contact& contact);

  /// Called when the points have changed. Realtime-safe.
  void find_compliance();

  [[nodiscard]] std::size_t count() const { return touches_.size(); }

  /// Of one body.
  [[nodiscard]] std::span<ContactSide> sides(std::size_t body) { return sides_[body]; }

  /// Finds the forces of the next audio sample, whose free ways and yields the sides have: one after the other until
  /// they change no more, at most 100 times. From the 20th time on, a step of Newton's method follows each time,
  /// because stiff contacts near each other settle slowly. A single contact is exact. The contacts take the sample.
  /// @param sample  of the block, in which the forces are kept
  void advance(std::size_t sample);

  /// On the body of a side, in the last audio sample, N.
  [[nodiscard]] double force(const ContactSide& side) const { return forces_[side.contact]; }

 private:
  struct Touch {
    Contact* contact;
    double before = 0.0;  // force in the last sample, N
  };
  void gather();
  [[nodiscard]] double way(std::size_t touch) const;
  void find_forces();
  double settle();
  [[nodiscard]] double misfit() const;
  void find_newton_forces();
  void correct();
  void keep(std::size_t sample);

  int rate_;
  std::vector<Touch> touches_;
  std::vector<std::vector<ContactSide>> sides_;  // [bodies]
  std::vector<double> modes_compliance_;        // [contacts x contacts] way of the first for a force at the second, m/N
  std::vector<double> compliance_;              // [contacts x contacts] the same with what stretching takes away
  std::vector<double> free_, forces_;           // [contacts] m, N
  std::vector<double> matrix_, newton_forces_;  // of Newton's method: [contacts x contacts], [contacts] N
};

}  // namespace idiophone::resonators
