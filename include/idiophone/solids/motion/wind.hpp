#pragma once
// Wind that pushes the surfaces of bodies, by its velocity relative to theirs.

#include <array>
#include <span>
#include <vector>

#include "idiophone/foundation/parallel/reproducible_sum.hpp"
#include "idiophone/scene/load_sections.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/body_model.hpp"

namespace idiophone::motion {

/// The velocity of a wind, the same everywhere: its mean and its gusts, times its signal. Each component of the gusts
/// is a sum of cosines with random phases (Shinozuka and Deodatis 1991, "Simulation of stochastic processes by spectral
/// representation"). The frequencies are the middles of equal shares of the power of Dryden's longitudinal spectrum,
/// whose correlation is exp(-t/T). So the gusts are a function of time, without state.
class WindVelocity {
 public:
  explicit WindVelocity(const scene::Wind& wind);

  /// m/s, at a time in s.
  [[nodiscard]] Vector3 at(double time) const;

 private:
  static constexpr std::size_t waves = 32;  // the highest frequency is 20/(2 pi T)
  struct Wave {
    double rate;                  ///< rad/s
    std::array<double, 3> phase;  ///< of each component, rad
  };
  Vector3 mean_;
  scene::Signal signal_;
  double amplitude_;  // of one wave, m/s
  std::vector<Wave> waves_;
};

/// Its force on this rank's nodes. A triangle with the area A and the outward normal n, whose corners move with the
/// mean velocity v, feels 1/2 density drag |w - v| ((w - v).n) A n where this points inwards, and nothing on the side
/// away from the wind; a third acts on each corner. A node gets the same force on any number of ranks.
class Wind {
 public:
  /// @param air_density  kg/m3
  /// @param triangles    of the surfaces that it pushes, global nodes, in one order on all ranks
  /// @param part         must outlive this object
  Wind(const scene::Wind& wind, double air_density, std::span<const mesh::Triangle> triangles, const mesh::Part& part);

  /// Adds the forces on the owned nodes, N.
  /// @param time   s
  /// @param state  [local nodes], ghosts too
  void add(double time, std::span<const NodeState> state, std::span<NodeForce> force) const;

  /// Notes these forces for add_work(), once a step.
  void remember(double time, std::span<const NodeState> state);

  /// Adds the work that the remembered forces do in the step, with the velocities of that step, J.
  void add_work(const Step& step, std::span<const NodeState> state, ReproducibleSum& work) const;

  /// The sum of the forces on the owned nodes, each component, N.
  [[nodiscard]] std::array<ReproducibleSum, 3> total(double time, std::span<const NodeState> state) const;

  /// Owned nodes that it acts on, ascending.
  [[nodiscard]] const std::vector<Index>& nodes() const { return nodes_; }

 private:
  template <class Visit>
  void visit_forces(double time, std::span<const NodeState> state, const Visit& visit) const;

  WindVelocity velocity_;
  double factor_;  // 1/2 density drag, kg/m3
  std::span<const Vector3> reference_;
  Index owned_nodes_;
  std::vector<std::array<Index, 3>> triangles_;  // local nodes: those with an owned corner
  std::vector<Index> nodes_;
  std::vector<Vector3> remembered_;  // [owned nodes] N
};

}  // namespace idiophone::motion
