#pragma once
// A receiver of sound: a microphone or a head with two ears, with or without absorption by the air and by walls.

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/air/receivers/absorbing_air.hpp"
#include "idiophone/air/receivers/absorbing_walls.hpp"
#include "idiophone/air/receivers/edge_filters.hpp"
#include "idiophone/air/receivers/filter_bank.hpp"
#include "idiophone/air/receivers/head_directions.hpp"
#include "idiophone/air/receivers/head_responses.hpp"

namespace idiophone::receivers {

/// Properties of an ear.
struct EarOptions {
  std::shared_ptr<const HeadResponses> head;  ///< null for a microphone
  std::optional<AbsorbingAir> air;            ///< none: no absorption
  std::optional<AbsorbingWalls> walls = {};   ///< none: no reflection changes the spectrum
  std::optional<EdgeFilters> edges = {};      ///< none: sound does not bend around edges
  int direction_interval = 441;               ///< audio samples between two updates of the directions
  std::size_t triangles = 0;                  ///< of the surface
  std::size_t paths = 1;                      ///< the direct one and reflections
};

/// One channel, or two of a head: left and right.
class Ear {
 public:
  /// @param first  audio sample of the first emission, with the spreading's first
  /// @param longest_delay, spreading  as for an AccumulationBuffer
  Ear(std::int64_t first, double longest_delay, const Spreading& spreading, EarOptions options);

  [[nodiscard]] std::size_t channels() const { return head_ ? 2 : 1; }
  [[nodiscard]] const std::shared_ptr<const HeadResponses>& head() const { return head_; }

  /// Direction from the head to a triangle in the head's frame: x to the front, y to the left, z up; of any length.
  using DirectionOf = std::function<Vector3(std::size_t triangle)>;

  /// Adds the arrivals of one audio sample's emission along one of the paths. No communication.
  /// @param path       0 is the direct path
  /// @param distance   [arrivals] travelled by the sound, m
  /// @param direction  called only by an ear with a head, and only when its directions are updated
  /// @throws as AccumulationBuffer::add
  void hear(std::int64_t sample, std::size_t path, const radiation::Arrivals& arrivals,
            const std::vector<double>& distance, const DirectionOf& direction);

  /// Adds arrivals by way of edges, after hear() of the same path. A head hears them from where it hears that.
  /// @param waves  [arrivals] from the edges
  /// @throws as AccumulationBuffer::add
  void hear_around(std::int64_t sample, std::size_t path, const radiation::Arrivals& arrivals,
                   const std::vector<double>& distance, std::span<const WavesInTurn> waves);

  /// See FilterBank.
  [[nodiscard]] FilterBank& bank() { return bank_; }
  [[nodiscard]] const FilterBank& bank() const { return bank_; }

  /// A head's state for one triangle; a microphone has none. The filter bank archives the rest.
  void archive(std::size_t triangle, parallel::ArchiveRow& row);

 private:
  /// What a sound goes through before it is heard.
  struct Losses {
    std::size_t path = 0;
    std::int64_t direction = 0;
    std::int64_t metres = 0;
    std::int64_t edge = 0;
  };
  [[nodiscard]] std::int64_t number_of(const Losses& losses) const;
  [[nodiscard]] Filters filters() const;
  [[nodiscard]] Crossfade directions(std::int64_t sample, std::size_t path, std::size_t triangle) const;
  /// One sound, whose losses by directions and by the air are still open, to the inputs of filters.
  void distribute(Losses losses, double weight, std::size_t triangle, const radiation::Arrivals& arrivals,
                  double distance, const Crossfade& directions);
  /// Adds all inputs to the bank, and empties them.
  void add_inputs(std::int64_t sample, bool with_changes);
  void add_to_filter(FilterWeight filter, std::size_t triangle, const radiation::Arrivals& arrivals);
  /// Adds one input to the bank, and empties it.
  void add_input(std::int64_t filter, radiation::Arrivals& input, std::int64_t sample, bool with_changes);

  std::shared_ptr<const HeadResponses> head_;
  std::optional<AbsorbingAir> air_;
  std::optional<AbsorbingWalls> walls_;
  std::optional<EdgeFilters> edges_;
  std::size_t paths_;                                   // that differ in their filters
  std::vector<HeadDirections> directions_;              // [paths] of a head
  std::map<std::int64_t, radiation::Arrivals> inputs_;  // of one audio sample, by the number of the filter
  FilterBank bank_;
};

}  // namespace idiophone::receivers
