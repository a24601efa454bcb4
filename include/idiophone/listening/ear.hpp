#pragma once
// What hears at one place: a microphone, or a head with two ears; through clear air, or air that absorbs.

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "idiophone/listening/absorbing_air.hpp"
#include "idiophone/listening/filter_bank.hpp"
#include "idiophone/listening/head_directions.hpp"
#include "idiophone/listening/head_responses.hpp"

namespace idiophone::listening {

/// What an ear is made of.
struct EarOptions {
  std::shared_ptr<const HeadResponses> head;  ///< null: a microphone
  std::optional<AbsorbingAir> air;            ///< none: the air is clear
  int renewal = 441;                          ///< audio samples after which directions are looked up again
  std::size_t triangles = 0;                  ///< of the surface
  std::size_t ways = 1;                       ///< that a sound comes: straight, by a floor, ...
};

/// One channel, or two with a head: left, right.
class Ear {
 public:
  /// @param first  audio sample of the first emission, with the spreading's first
  /// @param longest_delay, spreading  as for an AccumulationBuffer
  Ear(std::int64_t first, double longest_delay, const Spreading& spreading, EarOptions options);

  [[nodiscard]] std::size_t channels() const { return head_ ? 2 : 1; }

  /// Of its filters.
  [[nodiscard]] std::size_t lookahead() const { return air_ ? air_->half_width() : 0; }

  /// Where a triangle's sound comes from in the head's frame: x to the front, y to the left, z up; of any length.
  using DirectionOf = std::function<Vector3(std::size_t triangle)>;

  /// Hears what was emitted at an audio sample and came by one of the ways. No communication.
  /// @param distance   [as long as the arrivals] that they travelled, m
  /// @param direction  asked only by an ear with a head, and only now and then
  /// @throws as AccumulationBuffer::add
  void hear(std::int64_t sample, std::size_t way, const radiation::Arrivals& arrivals,
            const std::vector<double>& distance, const DirectionOf& direction);

  /// See FilterBank.
  [[nodiscard]] FilterBank& bank() { return bank_; }
  [[nodiscard]] const FilterBank& bank() const { return bank_; }

  /// What a head remembers of a triangle; a microphone remembers nothing. The bank archives the rest of the state.
  void archive(std::size_t triangle, parallel::ArchiveRow& row);

 private:
  [[nodiscard]] Filters filters() const;
  void share(std::size_t triangle, const radiation::Arrivals& arrivals, double distance, Shares shares);
  void put(std::int64_t filter, double share, std::size_t triangle, const radiation::Arrivals& arrivals);

  std::shared_ptr<const HeadResponses> head_;
  std::optional<AbsorbingAir> air_;
  std::vector<HeadDirections> directions_;             // [ways] with a head
  std::map<std::int64_t, radiation::Arrivals> parts_;  // of one audio sample, by the filter that they go to
  FilterBank bank_;
};

}  // namespace idiophone::listening
