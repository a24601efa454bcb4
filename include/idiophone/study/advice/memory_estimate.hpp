#pragma once
// How much memory a run needs on a rank, estimated from the rank's part.

#include <vector>

#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/solids/motion/dynamics.hpp"

namespace idiophone::advice {

class MemoryEstimate {
 public:
  /// @param ready     of all bodies
  /// @param dynamics  of elements like those of the parts to come
  /// @param program   what the program holds before it reads a mesh, bytes
  MemoryEstimate(const bodies::Preparation& ready, const motion::Dynamics& dynamics, double program);

  /// Of elements and nodes alone, which a rank holds while it finds the stable step, too, bytes.
  [[nodiscard]] double of_bodies(const mesh::Part& part) const;

  /// The most that a rank with this part holds while it runs, bytes. Rank 0 needs more before it has sent the parts.
  [[nodiscard]] double of(const mesh::Part& part) const;

 private:
  std::vector<double> element_bytes_;  ///< [bodies] of the tables of an element
  double fixed_;                       ///< what does not depend on the part, bytes
};

}  // namespace idiophone::advice
