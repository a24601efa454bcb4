#pragma once
// The motion of one body's finite elements on this rank, in the memory of an accelerator.

#include <memory>
#include <span>
#include <vector>

#include "idiophone/solids/accelerated/node_list.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/leapfrog.hpp"
#include "idiophone/solids/solid/mass.hpp"
#include "idiophone/solids/solid/node_state.hpp"
#include "idiophone/solids/solid/solid.hpp"

namespace idiophone::accelerated {

/// Steps a body as solid::Solid and solid::Mass do, to rounding. Nodes are local numbers of the part; states and forces
/// are [local nodes]. What it is told is done in this order; only `read` and `save` wait for it.
class AcceleratedSolid {
 public:
  /// @param accelerator  must outlive this object
  /// @param reference    [local nodes] positions X, m
  /// @param solid        its materials; those with a loss factor have begun to remember
  /// @param mass         lumped, without added mass
  /// @param held         owned components that are held, as 3 node + axis
  /// @param step         dt, s
  /// @throws std::runtime_error if the body does not fit into the memory of the accelerator
  AcceleratedSolid(accelerator::Accelerator& accelerator, const mesh::BodyPart& body,
                   std::span<const Vector3> reference, const solid::Solid& solid, const solid::Mass& mass,
                   std::span<const Index> held, double step);
  ~AcceleratedSolid();
  AcceleratedSolid(const AcceleratedSolid&) = delete;
  AcceleratedSolid& operator=(const AcceleratedSolid&) = delete;
  AcceleratedSolid(AcceleratedSolid&&) = delete;
  AcceleratedSolid& operator=(AcceleratedSolid&&) = delete;

  /// Goes on from these states, and from what the elements of the solid remember.
  void load(std::span<const solid::NodeState> state, solid::Solid& solid);
  /// Writes the states of the owned nodes.
  void save(std::span<solid::NodeState> state) const;
  /// Writes what the elements remember.
  void save_memory(solid::Solid& solid) const;

  /// @param nodes  of the body
  [[nodiscard]] NodeList list(std::vector<Index> nodes) const;
  /// Nodes of the body's elements that other ranks own.
  [[nodiscard]] const std::vector<Index>& ghosts() const { return ghosts_; }
  /// Owned nodes of elements with a ghost: they are ghosts of others.
  [[nodiscard]] const std::vector<Index>& shared() const { return shared_; }

  /// The place of a node of the body among the displacements there.
  [[nodiscard]] Index number(Index node) const;
  /// [owned nodes of the body, then ghosts][4], m; the last number of each means nothing. Velocities follow them.
  [[nodiscard]] const accelerator::Array<double>& displacements() const;

  /// The states of some nodes, from the accelerator and to it.
  void read(NodeList& list, std::span<solid::NodeState> state) const;
  void write(NodeList& list, std::span<const solid::NodeState> state);

  /// The stress of all elements. Their memory goes on to the present.
  void find_stress();

  enum class Displacements { stay, follow };
  /// Velocities of the owned nodes by the stress; displacements follow them if asked for. Held components stop.
  void advance(const solid::Kick& kick, Displacements displacements);
  /// Velocities of owned nodes by forces, N, on top of that.
  void push(NodeList& list, const solid::Kick& kick, std::span<const solid::NodeForce> force);
  /// Displacements of the owned nodes by their velocities.
  void displace();

 private:
  struct Device;  ///< kernels and arrays

  template <class Visitor>
  void for_each_overstrain(const solid::Solid& solid, std::size_t element, Visitor visit) const;
  void load_memory(solid::Solid& solid);
  void find_borders(const mesh::BodyPart& body);
  [[nodiscard]] bool owns(Index node) const { return node >= begin_ && node < begin_ + owned_; }

  Index begin_, owned_;  ///< the first owned node of the body, and how many there are
  double step_;
  std::vector<Index> regions_;          ///< [elements]
  std::vector<Index> ghosts_, shared_;  ///< ascending
  std::unique_ptr<Device> device_;
};

}  // namespace idiophone::accelerated
