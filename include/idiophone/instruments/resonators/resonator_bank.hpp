#pragma once
// The modes of a body as resonators: each mode is a complex number z that turns and shrinks by the same factor in each
// audio sample, which is exact, z' = (i w_d - d) z + phi F. A new factor keeps z, so frequencies and decay rates can
// change while the body sounds.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "idiophone/instruments/resonators/damped_oscillator.hpp"
#include "idiophone/instruments/resonators/point_forces.hpp"

namespace idiophone::resonators {

/// Bytes of the processor's vector registers: GCC computes with wider vectors several times as slowly.
#if defined(__AVX512F__)
inline constexpr std::size_t register_size = 64;
#elif defined(__AVX__)
inline constexpr std::size_t register_size = 32;
#else
inline constexpr std::size_t register_size = 16;
#endif

/// One number for each of as many modes as fit into a register.
using ModePack = double __attribute__((vector_size(register_size)));
inline constexpr std::size_t modes_in_pack = register_size / sizeof(double);

/// Packs that are computed at once, because each operation waits for the one before.
inline constexpr std::size_t packs_in_group = 4;
inline constexpr std::size_t modes_in_group = packs_in_group * modes_in_pack;

/// A complex number for each mode of a group.
struct ModeGroup {
  std::array<ModePack, packs_in_group> real{}, imaginary{};
};

/// One complex number a mode in groups; what is missing in the last group is zero.
[[nodiscard]] std::vector<ModeGroup> in_groups(std::span<const Complex> values);

/// Of a mode of a group. @param mode  its number there, or in all groups
[[nodiscard]] Complex value_of(const ModeGroup& group, std::size_t mode);

/// A force that acts in the present block.
struct Drive {
  std::span<const ForcePiece> force;   ///< [samples] N
  std::span<const ModeGroup> by_mean;  ///< [groups] phi times Resonator::by_mean
  std::span<const ModeGroup> by_slope;
  bool acts = true;  ///< false: the force is over and only its rise is left
};

class PointContacts;

class ResonatorBank {
 public:
  static constexpr std::size_t most_samples = 64;  ///< in a block
  static constexpr std::size_t most_outputs = 8;

  /// At rest. @param turns  Resonator::turn of each mode
  explicit ResonatorBank(std::span<const Complex> turns);

  [[nodiscard]] std::size_t groups() const { return turns_.size(); }

  /// Changes the factors and keeps the state. No allocation. @param turns  [groups]
  void retune(std::span<const ModeGroup> turns);

  /// Output o in sample i, before the force of sample i acts, is the sum over the modes of Re(gain (z - z_F)). z_F is
  /// the state in which a mode follows the force and its rise at the beginning of sample i, if both are slow:
  /// DampedOscillator::static_state() and rising_state(). No allocation. The numbers do not depend on how samples are
  /// divided into blocks.
  /// @param drives  of `samples` samples each
  /// @param gains   [outputs x groups]
  /// @param sound   [samples x outputs], samples <= most_samples, outputs 1, 2, 4 or 8
  void advance(std::span<const Drive> drives, std::span<const ModeGroup> gains, std::size_t outputs,
               std::span<double> sound);

  /// The same while contacts act, too. Their forces are found sample by sample.
  void advance(std::span<const Drive> drives, PointContacts& contacts, std::span<const ModeGroup> gains,
               std::size_t outputs, std::span<double> sound);

  /// From now on only these groups are heard while nothing drives them. Those that leave fall evenly to silence within
  /// `fade` samples, those that return rise as long. The others ring on unheard and cost nothing. A force makes all
  /// groups heard at once, each as loud as it was then. Not before the last fade is over. No allocation.
  /// @param heard  [groups]
  void choose(std::span<const char> heard, std::size_t fade);

  /// Whether any group that moves is heard. If not, rest() can take the place of advance() without drives.
  [[nodiscard]] bool is_heard() const;
  void rest(std::size_t samples);

  /// Brings the states to the present audio sample. No allocation.
  void catch_up();

  /// [groups] z of the modes, when they are of the present audio sample.
  [[nodiscard]] std::span<const ModeGroup> states() const { return states_; }

  /// Sets modes that are far below anything audible to zero, so that no number becomes denormal.
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
  template <std::size_t outputs>
  void touch_all(std::span<const Drive> drives, PointContacts& contacts, std::span<const ModeGroup> gains,
                 std::span<double> sound);
  template <std::size_t outputs>
  void ring_all(std::span<const ModeGroup> gains, std::span<double> sound);
  template <std::size_t outputs>
  void add_ringing(Part part, std::span<const ModeGroup> gains, std::span<double> sound);
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
};

}  // namespace idiophone::resonators
