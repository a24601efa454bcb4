#pragma once
// What travels between ranks in each step: the velocities of nodes that are ghosts elsewhere. A ghost moves with them
// as its owner does, so displacements need not travel, unless nodes of modal bodies are ghosts.

#include <petscsf.h>

#include <array>
#include <memory>
#include <span>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/node_state.hpp"

namespace idiophone::motion {

using Velocity = std::array<double, 3>;  ///< m/s

class VelocityExchange {
 public:
  VelocityExchange() = default;
  virtual ~VelocityExchange() = default;
  VelocityExchange(const VelocityExchange&) = delete;
  VelocityExchange& operator=(const VelocityExchange&) = delete;
  VelocityExchange(VelocityExchange&&) = delete;
  VelocityExchange& operator=(VelocityExchange&&) = delete;

  /// Sends the velocities of owned nodes that are ghosts elsewhere. They travel while this rank does other work.
  /// @param state  [local nodes]
  virtual void send(std::span<const solid::NodeState> state) = 0;

  /// Whether displacements travel, too.
  [[nodiscard]] virtual bool has_displacements() const { return false; }

  /// Whether it takes so long that forces should be computed meanwhile.
  [[nodiscard]] virtual bool is_slow() const = 0;

  /// Receives the velocities of this rank's ghosts. Waits for its neighbours only. Every send is followed by one.
  /// @param state  [local nodes]
  virtual void receive(std::span<solid::NodeState> state) = 0;
};

/// Through shared memory if all ranks run on one machine, unless PETSc's option -ghosts_by_messages says no, or a joint
/// holds a modal body; by messages otherwise. Collective.
/// @param exchange  see ghost_exchange; it must live as long as the result
[[nodiscard]] std::unique_ptr<VelocityExchange> velocity_exchange(const scene::Solids& solids, const mesh::Part& part,
                                                                  PetscSF exchange, MPI_Comm communicator);

}  // namespace idiophone::motion
