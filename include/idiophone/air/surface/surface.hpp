#pragma once
// The surface of moving solids: from displacements of its vertices at the motion's steps to pressures of its triangles
// and positions at the audio rate (O'Brien 2001, section 3.2).

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "idiophone/air/surface/low_pass.hpp"
#include "idiophone/air/surface/sampling.hpp"
#include "idiophone/air/surface/surface_motion.hpp"
#include "idiophone/foundation/lanes.hpp"
#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::surface {

/// One rank's exterior triangles. In each audio sample: reads_per_sample() times { write displacements(), read() },
/// then take(). A triangle's results depend on its own three vertices only, to the bit.
class Surface {
 public:
  /// @param triangles  three vertices each, in the order that makes the normal of eq. 4 point outwards
  /// @param reference  [vertices] positions, m
  /// @throws std::invalid_argument when the sampling is not valid, a vertex is missing or not finite, or a triangle has
  ///         no area (the message names it).
  Surface(const std::vector<std::array<Index, 3>>& triangles, const std::vector<Vector3>& reference,
          const Sampling& sampling);

  [[nodiscard]] std::size_t triangles() const { return triangles_; }
  [[nodiscard]] std::size_t vertices() const { return vertices_; }
  [[nodiscard]] const Sampling& sampling() const { return sampling_; }

  /// Where the caller writes the present displacements before start() and before each read(): [3 x vertices], x y z of
  /// vertex 0, then of vertex 1, ..., m. All of it each time; the span is another one after each call.
  [[nodiscard]] std::span<double> displacements() { return {slots_[reads_ + 1].data(), 3 * vertices_}; }

  /// From the next read() on, a triangle radiates, as all do at first, or is shut inside a body and has no pressure.
  /// Reads that are held to be filtered with it count as later ones, all of the same audio sample.
  void set_open(std::size_t triangle, bool open) { shares_[triangle] = open ? 1.0 : 0.0; }

  /// Begins at time 0 with displacements(). The surface is taken to have moved with these velocities, and pressed as it
  /// then does, for ever: what sets out with a velocity must not click.
  /// @param velocities  [3 x vertices], m/s; none: at rest
  /// @return that steady motion, which belongs to the audio sample before the first one taken
  SurfaceMotion start(std::span<const double> velocities = {});

  /// Takes displacements() at the end of one more read of k steps. The pressure over the read is z vbar.n (eqs. 2-5)
  /// with the exact mean velocity, (u_end - u_begin)/(k dt) averaged over the triangle's vertices, and the normal at
  /// the mean of both positions.
  /// @throws std::logic_error when the audio sample is complete and has to be taken first.
  void read();

  /// Ends an audio sample; the motion belongs to the audio sample sampling().latency() samples earlier.
  /// @throws std::logic_error when reads of this audio sample are missing.
  void take(SurfaceMotion& motion);

  /// All that decides the future; restoring takes the place of start(). A row depends on its triangle or vertex alone.
  /// Collective.
  /// @param triangles, vertices  the rows that those of this rank are
  /// @throws std::logic_error within an audio sample
  void archive(parallel::Archive& archive, const parallel::Rows& triangles, const parallel::Rows& vertices);

 private:
  friend class AcceleratedSurface;

  static constexpr std::size_t reads_at_once = 8;  // held before they are filtered together

  void filter_reads();
  void filter_displacements();
  void filter_pressures();
  /// Of four triangles from `first` on.
  void find_pressures(std::size_t first, std::array<AlignedBlock, reads_at_once>& pressures) const;

  Sampling sampling_;
  std::size_t triangles_;
  std::size_t vertices_;
  std::vector<Index> corners_;  // see corner_places()
  std::vector<Lanes4> edges_;   // [6] for each four triangles: reference edges 1-2 and 1-3, x y z each, m
  std::vector<double> shares_;  // [padded triangles] 1, or 0 where it is shut
  std::vector<double> reference_;
  std::array<std::vector<double>, reads_at_once + 1> slots_;  // [padded 3 x vertices] displacements, oldest first
  std::size_t reads_ = 0;                                     // in the slots and not filtered, slot 0 apart
  int reads_filtered_ = 0;                                    // of this audio sample
  LowPass pressure_;
  LowPass displacement_;
};

}  // namespace idiophone::surface
