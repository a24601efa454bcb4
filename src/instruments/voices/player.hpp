#pragma once
// The audio thread's part of a sound map: renders the body, as commands say. A ContactGroup calls it. The audio thread
// never locks, allocates or frees.

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "audio_commands.hpp"
#include "idiophone/instruments/outputs/ring.hpp"
#include "idiophone/instruments/proxies/engine.hpp"
#include "idiophone/instruments/voices/voice.hpp"
#include "mapped_sound.hpp"

namespace idiophone::voices {

class Player {
 public:
  /// @param most_commands  MapDetail::most_commands
  Player(MappedSound sound, std::size_t receivers, int rate, std::size_t most_commands);

  /// Control thread: sends a command and leaves null. Leaves it alone and returns false if there are too many. There is
  /// always room for one ReceptionChange that is for good.
  bool send(Command& command);

  /// Control thread: frees the commands that are done.
  void collect();

  /// Once, before the first piece.
  /// @param contacts  of the bodies that touch each other
  /// @param body      the number of this one among them
  /// @param touches   whether it is in a contact that stays
  void join(resonators::PointContacts& contacts, std::size_t body, bool touches);
  /// Whether contacts that stay touch the body.
  [[nodiscard]] bool touches_something() const { return touches_something_; }

  // The audio thread's part in the next piece. The numbers do not depend on how the samples are divided into pieces, if
  // commands arrive before their time.

  /// @param begin  audio sample
  /// @param clock  ns of the steady clock at the start of the piece; to measure delays
  void begin_piece(std::int64_t begin, std::int64_t clock);

  /// Whether commands have come since the last piece began.
  [[nodiscard]] bool is_called() const { return !incoming_.is_empty(); }

  /// Whether nothing is done or heard in the piece, unless what touches the body wakes it.
  [[nodiscard]] bool is_idle() const { return waiting_.empty() && !is_driven() && sound_.is_silent(); }

  void begin_and_end_due(std::int64_t sample);

  /// The next sample at which something may begin or end, at most `end`.
  [[nodiscard]] std::int64_t next_boundary(std::int64_t sample, std::int64_t end) const;

  /// Up to the next boundary, as MappedSound, without and with contacts.
  void render(std::int64_t sample, std::span<double> sound);
  [[nodiscard]] resonators::BodyInContact begin_contact(std::int64_t sample, std::size_t samples);
  void end_contact(std::int64_t sample, std::span<double> sound);

  // The audio thread's part in the choice of what is heard.

  [[nodiscard]] const MappedSound& sound() const { return sound_; }

  /// Whether forces act, or act on by their rise, or may act because it vibrates and touches something.
  [[nodiscard]] bool is_driven() const {
    return !acting_.empty() || !touches_.empty() || (touches_something_ && sound_.sounds());
  }

  /// Of this body. See proxies::Priority.
  [[nodiscard]] double priority(proxies::Priority kind) const;

  /// For Priority::fixed.
  void set_priority(double priority) { own_priority_ = priority; }

  /// See MappedSound.
  void measure(std::span<double> power) { sound_.measure(power); }
  void choose(std::span<const char> heard, std::size_t fade) { sound_.choose(heard, fade); }

  /// Whether the body was silent, or anything of it was heard or faded, after the last choice. Any thread.
  [[nodiscard]] bool is_heard() const { return is_heard_.load(std::memory_order_relaxed); }
  void set_heard(bool is_heard) { is_heard_.store(is_heard, std::memory_order_relaxed); }

  /// Whether the last choice counted a cost for it, as heard or fading. Of the audio thread.
  [[nodiscard]] bool is_paid() const { return is_paid_; }
  void set_paid(bool is_paid) { is_paid_ = is_paid; }

  /// Whether a change for good is over, so that nothing is heard any more. Any thread.
  [[nodiscard]] bool has_left() const { return has_left_.load(std::memory_order_relaxed); }

  /// Any thread: times between ForceCommand::sent and the audio sample at which the force began.
  [[nodiscard]] Waits waits() const;

 private:
  void begin_due(std::int64_t sample);
  /// Whether it could be done; if so, the command is handed on.
  bool perform(Command& command, std::int64_t sample);
  void begin(std::unique_ptr<ForceCommand> excitation, std::int64_t sample);
  void begin(std::unique_ptr<TouchCommand> touch, std::int64_t sample);
  void lead(const LeadCommand& command, std::int64_t sample);
  void retune(Retuning& retuning);
  void take_strength(double strength);
  void end_over(std::int64_t sample);
  void prepare(std::int64_t sample, std::size_t samples);
  void hand_back(Command command);
  void note_leaving();

  MappedSound sound_;
  std::size_t receivers_;
  int rate_;
  outputs::Ring<Command> incoming_, done_;
  std::size_t most_commands_;
  std::size_t outstanding_ = 0;  // control thread: sent and not collected
  std::atomic<std::int64_t> measured_waits_{0}, total_wait_{0}, longest_wait_{0};  // ns
  std::atomic<bool> is_heard_{true}, has_left_{false};
  // of the audio thread
  bool is_paid_ = false;
  double own_priority_ = 0.0;
  double strength_ = 0.0;                               // of the strongest force since the body was silent, N s/kg
  std::vector<Command> waiting_;                        // in the order of their arrival
  std::vector<std::unique_ptr<ForceCommand>> acting_;   // in the order of their start
  std::vector<std::unique_ptr<TouchCommand>> touches_;  // likewise
  resonators::PointContacts* contacts_ = nullptr;       // the touches, and those of the bodies that it touches
  std::size_t number_ = 0;                              // of this body there
  bool touches_something_ = false;                      // as long as it is played
  std::vector<resonators::Drive> drives_;
  std::int64_t block_start_ = 0, clock_ = 0;  // audio sample, ns
};

}  // namespace idiophone::voices
