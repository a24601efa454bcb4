#pragma once
// Modes that stretch their body, in time: the force of stretching in each audio sample
// (docs/method/large_amplitudes.md).

#include <atomic>
#include <cstddef>
#include <span>
#include <vector>

#include "idiophone/foundation/stretching/stretching_energy.hpp"
#include "idiophone/instruments/resonators/mode_group.hpp"

namespace idiophone::resonators {

using stretching::StretchingEnergy;

/// A number that one thread sets and others read. A copy is independent.
class SharedNumber {
 public:
  SharedNumber() = default;
  SharedNumber(const SharedNumber& other) : number_(other.now()) {}
  SharedNumber& operator=(const SharedNumber& other) {
    set(other.now());
    return *this;
  }
  ~SharedNumber() = default;
  [[nodiscard]] double now() const { return number_.load(std::memory_order_relaxed); }
  void set(double number) { number_.store(number, std::memory_order_relaxed); }

 private:
  std::atomic<double> number_ = 0.0;
};

/// The force is constant in an audio sample, and the modes move exactly under it. It is -g p: g is the gradient of
/// p = sqrt(2 (V + offset)) in the middle of the sample, p the mean of its values at the ends. p goes on by g times the
/// way of the modes, so the energy of the modes and p^2/2 - offset always have the same sum (the
/// scalar auxiliary variable of J. Shen, J. Xu and J. Yang, J. Comput. Phys. 353, 2018; explicit: S. Bilbao, M.
/// Ducceschi and F. Zama, J. Comput. Phys. 472, 2023).
class StretchedModes {
 public:
  /// At rest.
  /// @param rotation  T, [modes x modes] 1/(kg m2): q . T q is the mean square of the rotation angle in the body
  /// @param turns     [groups] as ResonatorBank has them
  StretchedModes(StretchingEnergy energy, std::span<const double> rotation, std::span<const ModeGroup> turns, int rate);

  /// Keeps the stored energy. No allocation.
  /// @param size  of the body over that for which the energy is
  void retune(std::span<const ModeGroup> turns, double size);

  /// Whether the stretching counts.
  [[nodiscard]] bool acts() const { return acts_; }
  void wake() { acts_ = true; }
  /// Ends it if its energy was below 1e-5 of that of the modes since the last call: -100 dB.
  void rest_if_small();

  /// Finds the force of an audio sample. No allocation.
  /// @param before  [groups] z at the beginning
  /// @param free    [groups] z at the end without this force
  void find_force(std::span<const ModeGroup> before, std::span<const ModeGroup> free);

  /// [groups] By how much the mean root 1 lowers z at the end of the sample.
  [[nodiscard]] std::span<const ModeGroup> pull() const { return pull_; }
  /// Mean of p, J^1/2, if nothing but the free motion acts.
  [[nodiscard]] double free_root() const { return free_root_; }
  /// By how much the mean root rises with g times a further way of the modes.
  [[nodiscard]] double rise() const { return 1.0 / (2.0 + response_); }

  /// The sample is over: z loses the pull, and the energy is stored.
  /// @param mean_root  free_root(), and what further forces add
  void end(std::span<ModeGroup> after, double mean_root);

  /// [groups] z of modes that only follow the force, at the beginning of the sample that is over. What is heard of the
  /// modes has to be without it, as for any force (ResonatorBank::advance()).
  [[nodiscard]] std::span<const ModeGroup> following() const { return following_; }

  /// The largest rotation angle so far while the stretching counted, root mean square over the body, rad. Any thread
  /// may ask.
  [[nodiscard]] double largest_rotation() const { return largest_rotation_.now(); }

  [[nodiscard]] double stored_energy() const { return stored_; }  ///< J
  [[nodiscard]] std::size_t operations() const { return energy_.operations(); }

 private:
  /// A number for each mode of a group.
  using GroupNumbers = std::array<ModePack, packs_in_group>;
  /// What a group has at a rate.
  struct Factors {
    ModeGroup half_turn;     ///< in half an audio sample
    ModeGroup by_mean;       ///< z for a constant force of 1 in a sample, s
    ModeGroup by_following;  ///< z of a mode that follows a force of 1, s
    ModeGroup by_change;     ///< what a change of the force by 1 in a sample adds to that, s
    GroupNumbers period;     ///< displacement over the imaginary part of z, s
    GroupNumbers slip;       ///< decay over damped frequency
    GroupNumbers stiffness;  ///< w^2, 1/s^2
  };

  [[nodiscard]] double energy_of(std::span<const ModeGroup> states) const;
  void find_middle(std::span<const ModeGroup> before);
  void watch_rotation();
  void find_gradient(double energy_of_modes);
  void correct_drift(double energy_of_modes);
  void find_response();
  void follow(double mean_root);

  StretchingEnergy energy_;
  std::vector<float> rotation_;  // T
  SharedNumber largest_rotation_;
  int until_watched_ = 0;  // audio samples
  double rate_;
  float places_scale_ = 1.0F, bend_ = 1.0F;  // of the size
  std::vector<Factors> factors_;             // [groups]
  std::vector<float> places_, slopes_;       // [modes in groups] in the middle of the sample
  std::vector<GroupNumbers> ways_;           // [groups] of the sample without the force
  std::vector<GroupNumbers> gradient_;       // [groups] g
  std::vector<ModeGroup> pull_;              // [groups]
  std::vector<GroupNumbers> forces_;         // [groups] of the sample before
  std::vector<ModeGroup> following_;         // [groups]
  double stored_ = 0.0;                      // p^2/2 - offset, J
  double offset_ = 0.0;                      // J
  double root_ = 0.0;                        // p at the beginning of the sample
  double level_ = 0.0;                       // sqrt(2 (V + offset)) in its middle
  double free_root_ = 0.0;
  double response_ = 0.0;       // g times the way of the modes for a force of g
  double largest_share_ = 0.0;  // of V in the energy of the modes since rest_if_small()
  bool acts_ = false;
};

}  // namespace idiophone::resonators
