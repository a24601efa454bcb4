#pragma once
// How much of their preload a motion takes off bolts. Theory: docs/method/joints.md, "What a motion leaves of a
// preload".

#include <mpi.h>

#include <span>
#include <vector>

#include "idiophone/foundation/parallel/reproducible_sum.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/joints/joints.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/node_state.hpp"

namespace idiophone::joints {

/// What takes the preload of a bolt.
struct BoltForce {
  std::size_t bolt = 0;   ///< index into Solids::joints
  std::size_t joint = 0;  ///< that acts: the bolt itself, or a layer between the parts that it clamps

  [[nodiscard]] bool is_of_shank() const { return bolt == joint; }
  bool operator==(const BoltForce&) const = default;
};

/// A point of a joint that adds to such a force.
struct BoltForcePoint {
  BoltForce force;
  std::size_t joint = 0;  ///< index into Joints::all()
  std::size_t point = 0;  ///< of this joint; its first node is owned here
  double factor = 0.0;    ///< of its pull, 1/N
};

/// Of all bolts with a preload: the force of each shank, and of each layer that it presses together.
class BoltForces {
 public:
  /// Collective.
  /// @param joints, part  must outlive this object
  BoltForces(const scene::Solids& solids, const Joints& joints, const mesh::Part& part, MPI_Comm communicator);

  /// The same on all ranks, in the order of the bolts.
  [[nodiscard]] const std::vector<BoltForce>& all() const { return forces_; }

  /// This rank's share of what each force takes off the preload, as a part of it: of a shank, the fall of its pull; of
  /// a layer, the fall of the pressure there. Above 1, nothing is left. Needs the state of the ghosts, too.
  /// @param state  [local nodes]
  /// @return       [all()]
  [[nodiscard]] std::vector<ReproducibleSum> taken(std::span<const solid::NodeState> state) const;

 private:
  const Joints& joints_;
  const mesh::Part& part_;
  std::vector<BoltForcePoint> points_;
  std::vector<BoltForce> forces_;
  std::vector<std::size_t> force_of_point_;  ///< [points_] index into forces_
};

}  // namespace idiophone::joints
