#pragma once
// The modes of a body as resonators: each mode is a complex number z that turns and shrinks by the same factor in each
// audio sample, which is exact, z' = (i w_d - d) z + phi F. A new factor keeps z, so frequencies and decay rates can
// change while the body sounds.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/instruments/resonators/force_piece.hpp"
#include "idiophone/instruments/resonators/mode_group.hpp"
#include "idiophone/instruments/resonators/stretched_modes.hpp"

namespace idiophone::resonators {

/// A force that acts in the present block.
struct Drive {
  std::span<const ForcePiece> force;   ///< [samples] N
  std::span<const ModeGroup> by_mean;  ///< [groups] phi times Resonator::by_mean
  std::span<const ModeGroup> by_slope;
  bool acts = true;  ///< false: the force is over and only its rise is left
};

struct BodyInContact;
struct ContactSide;
class PointContacts;

class ResonatorBank {
 public:
  static constexpr std::size_t most_samples = 64;  ///< in a block
  static constexpr std::size_t most_outputs = 8;

  /// At rest.
  /// @param turns       Resonator::turn of each mode
  /// @param stretching  of the modes where their vibrations may be large
  explicit ResonatorBank(std::span<const Complex> turns, std::optional<StretchedModes> stretching = std::nullopt);

  [[nodiscard]] std::size_t groups() const { return turns_.size(); }

  /// Changes the factors and keeps the state. No allocation.
  /// @param turns  [groups]
  /// @param size   of the body over that for which the stretching is
  void retune(std::span<const ModeGroup> turns, double size);

  /// Output o in sample i, before the force of sample i acts, is the sum over the modes of Re(gain (z - z_F)). z_F is
  /// the state in which a mode follows the force and its rise at the beginning of sample i, if both are slow:
  /// DampedOscillator::static_state() and rising_state(). No allocation. The numbers do not depend on how samples are
  /// divided into blocks.
  /// @param drives  of `samples` samples each
  /// @param gains   [outputs x groups]
  /// @param sound   [samples x outputs], samples <= most_samples, outputs 1, 2, 4 or 8
  void advance(std::span<const Drive> drives, std::span<const ModeGroup> gains, std::size_t outputs,
               std::span<double> sound);

  /// Whether stretching couples the modes while these drives act.
  [[nodiscard]] bool stretches(std::span<const Drive> drives) const;

  /// What stretching stores, J.
  [[nodiscard]] double stretching_energy() const { return stretching_ ? stretching_->stored_energy() : 0.0; }

  /// The largest rotation angle of the body's parts while they were stretched, root mean square, rad. Any thread may
  /// ask.
  [[nodiscard]] double largest_rotation() const { return stretching_ ? stretching_->largest_rotation() : 0.0; }

  /// Multiply-adds of the stretching in an audio sample; 0 without.
  [[nodiscard]] std::size_t stretching_operations() const;

  /// The same sample by sample: while contacts act, too, whose forces are found, or stretching couples the modes. See
  /// advance_together() for several bodies.
  void advance(std::span<const Drive> drives, PointContacts& contacts, std::span<const ModeGroup> gains,
               std::size_t outputs, std::span<double> sound);

  /// From now on only these groups are heard while nothing drives them. Those that leave fall evenly to silence within
  /// `fade` samples, those that return rise as long. The others ring on unheard and cost nothing. A force makes all
  /// groups heard at once, each as loud as it was then. Not before the last fade is over. No allocation.
  /// @param heard  [groups]
  void choose(std::span<const char> heard, std::size_t fade);

  /// Whether any group that moves is heard. If not, rest() can take the place of advance() without drives.
  [[nodiscard]] bool is_heard() const;
  /// Whether a group is heard, or on its way to it.
  [[nodiscard]] bool hears(std::size_t group) const {
    return parts_[group] == Part::heard || parts_[group] == Part::returns;
  }
  void rest(std::size_t samples);

  /// Brings the states to the present audio sample. No allocation.
  void catch_up();

  /// [groups] As given.
  [[nodiscard]] std::span<const ModeGroup> turns() const { return turns_; }

  /// [groups] z of the modes, when they are of the present audio sample.
  [[nodiscard]] std::span<const ModeGroup> states() const { return states_; }

  /// Sets modes that are far below anything audible to zero, so that no number becomes denormal. Those that are not
  /// heard wait for that until choose(). Where the stretching is so small that it is not heard, it ends.
  void silence();

  /// Whether anything moves.
  [[nodiscard]] bool sounds() const;

  /// z of a mode, m sqrt(kg)/s.
  [[nodiscard]] Complex state(std::size_t mode) const;

 private:
  /// What is heard of a group.
  enum class Part : char { heard, returns, leaves, unheard };

  template <std::size_t outputs>
  void advance_all(std::span<const Drive> drives, std::span<const ModeGroup> gains, std::span<double> sound);
  template <std::size_t outputs>
  void drive_all(std::span<const Drive> drives, std::span<const ModeGroup> gains, std::span<double> sound);
  friend void advance_together(std::span<const BodyInContact> bodies, PointContacts& contacts);
  void begin_samples();
  template <std::size_t outputs>
  void advance_freely(const BodyInContact& body, std::span<ContactSide> sides, std::size_t sample);
  void stretch(std::span<ContactSide> sides);
  void add_forces(std::span<const ContactSide> sides, const PointContacts& contacts);
  template <std::size_t outputs>
  void leave_out_following(const BodyInContact& body, std::size_t sample) const;
  template <std::size_t outputs>
  void ring_all(std::span<const ModeGroup> gains, std::span<double> sound);
  template <std::size_t outputs>
  void add_ringing(Part part, std::span<const ModeGroup> gains, std::span<double> sound);
  void silence_modes();
  /// The state of a group at the present audio sample.
  [[nodiscard]] ModeGroup present(std::size_t group) const;
  /// All groups, as loud as they are: what is not heard is at rest.
  void hear_all();
  /// By which groups are multiplied, so many samples from now. @return 0 to 1
  [[nodiscard]] double weight_of(Part part, std::size_t sample) const;

  std::vector<ModeGroup> turns_, states_;  // [groups]
  std::size_t behind_ = 0;                 // audio samples by which the states are behind the present one
  std::vector<char> moving_;               // [groups]
  std::vector<Part> parts_;                // [groups]
  bool has_choice_ = false;                // some group is not plainly heard
  std::size_t fade_ = 0, faded_ = 0;       // audio samples of the fade, and since it began
  std::size_t unheard_ = 0;                // audio samples by which groups that are not heard are behind
  std::optional<StretchedModes> stretching_;
  std::vector<ModeGroup> before_;  // [groups] states at the beginning of a sample, where modes stretch
};

}  // namespace idiophone::resonators
