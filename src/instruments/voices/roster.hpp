#pragma once
// Bodies with numbers that join and leave while the audio thread plays.

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "contact_group.hpp"
#include "idiophone/instruments/outputs/ring.hpp"
#include "lineup.hpp"

namespace idiophone::voices {

/// The control thread owns the bodies. It frees those that have left when the audio thread has handed back the last
/// lineup with them.
class Roster {
 public:
  /// @param bodies  numbered from 0 on
  /// @param groups  contact_groups() of the bodies
  Roster(std::vector<std::unique_ptr<MapBody>> bodies, std::vector<std::unique_ptr<ContactGroup>> groups,
         const MapDetail& detail, std::size_t channels, int rate);

  // The control thread's part.

  /// By number; null: free.
  [[nodiscard]] std::span<const std::unique_ptr<MapBody>> bodies() const { return bodies_; }

  /// The bodies that there are, in the order of their numbers.
  [[nodiscard]] std::vector<MapBody*> present() const;

  // Bodies can join and leave where no head hears them and no contacts of a score touch them.

  /// A body gets a free number.
  void join(std::size_t number, std::unique_ptr<MapBody> body);

  /// A body fades, and its number is free then.
  void leave(std::size_t number);

  /// Called often: frees what has left, and hands over what has changed.
  void attend();

  // The audio thread's part.

  /// The newest that was handed over.
  [[nodiscard]] Lineup& lineup();

 private:
  struct Gone {
    std::unique_ptr<MapBody> body;
    std::unique_ptr<ContactGroup> group;
    std::int64_t lineup;  ///< number of the first one without it
  };
  static constexpr std::int64_t most_on_their_way = 16;

  [[nodiscard]] std::unique_ptr<Lineup> made() const;
  void dismiss();

  MapDetail detail_;
  std::size_t channels_;
  int rate_;
  std::vector<std::unique_ptr<MapBody>> bodies_;
  std::vector<std::unique_ptr<ContactGroup>> groups_;  // by number, where contacts of a score touch no body
  std::vector<char> leaves_;                           // by number
  std::deque<Gone> gone_;
  bool has_changed_ = false;              // since the last lineup
  std::int64_t newest_ = 0, in_use_ = 0;  // numbers of lineups, as far as is known
  outputs::Ring<std::unique_ptr<Lineup>> coming_{most_on_their_way}, returned_{most_on_their_way};
  std::unique_ptr<Lineup> present_;  // of the audio thread
};

}  // namespace idiophone::voices
