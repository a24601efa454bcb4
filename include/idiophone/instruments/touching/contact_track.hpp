#pragma once
// What of a contact's impulses is an impact, and what a load that lasts.

namespace idiophone::touching {

/// A physics engine reports an impulse in each step, also for what rests, rolls or trembles. An impact at each of them
/// would sound like a machine gun. So an impulse is an impact only as far as it exceeds what the contact was used to:
/// an envelope of its impulses, which falls by a factor of e within 0.1 s.
class ContactTrack {
 public:
  struct Share {
    double impact = 0.0;  ///< N s
    double load = 0.0;    ///< N; zero if nothing touched for 0.1 s
  };

  /// @param impulse   of a step, N s
  /// @param duration  of the step, s
  Share follow(double impulse, double duration);

  /// Since the last impulse, s.
  [[nodiscard]] double silence() const { return silence_; }

 private:
  double envelope_ = 0.0;  // N s
  double load_ = 0.0;      // N
  double silence_ = 0.0;
};

}  // namespace idiophone::touching
