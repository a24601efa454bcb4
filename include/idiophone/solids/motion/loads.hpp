#pragma once
// External forces: pulses on patches, winds, bows, and spring-dashpot supports. Gravity acts on accelerations
// (dynamics.hpp).

#include <optional>
#include <span>
#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/motion/attachments.hpp"
#include "idiophone/solids/motion/body_model.hpp"
#include "idiophone/solids/motion/bow_load.hpp"
#include "idiophone/solids/motion/wind.hpp"

namespace idiophone::motion {

struct InitialState;

/// What acts from outside on this rank's nodes.
class Loads {
 public:
  Loads(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments);

  /// From now on, steps have this length, s.
  void begin(double step);

  /// Finds the forces of inertia that balance pulses: each node's mass times the acceleration that the pulse would give
  /// the rigid, undeformed body. They cancel its force and moment and do no work on vibrations, whose modes are
  /// orthogonal to rigid motions.
  /// @param masses  [bodies] of the owned nodes, kg
  void balance(const mesh::Part& part, const InitialState& initial_state,
               std::span<const std::span<const double>> masses);

  /// Once a step, after add(): notes what depends on the motion and is needed by add_work(), and what bows remember
  /// goes on to `time`.
  void remember(double time, std::span<const NodeState> state);

  /// Adds all pulses, winds and bows at `time` (s) and the supports' forces to the owned nodes' forces, N, in the
  /// deck's order.
  void add(double time, std::span<const NodeState> state, std::span<NodeForce> force) const;

  /// Adds the work that the pulses, winds and bows do in the step, with the velocities of that step, J.
  void add_work(const Step& step, std::span<const NodeState> state, ReproducibleSum& work) const;

  /// Owned nodes on which a pulse, a wind or a bow may act from `begin` to `end` (s), in the deck's order; a node may
  /// occur more than once.
  [[nodiscard]] std::vector<Index> pulsed_nodes(double begin, double end) const;

  [[nodiscard]] const std::vector<Wind>& winds() const { return winds_; }   ///< [Solids::winds]
  [[nodiscard]] const std::vector<BowLoad>& bows() const { return bows_; }  ///< [Solids::bows]

  /// Owned nodes that something acts on from outside at or after a time (s), in the deck's order; a node may occur more
  /// than once.
  [[nodiscard]] std::vector<Index> nodes(double begin) const;

  /// Adds the supports' stiffness at each owned node, N/m, the same in all directions. [owned nodes]
  void add_support_stiffness(std::span<double> stiffness) const;

  /// See BowLoad::add_bounds. [local nodes]
  void add_bow_bounds(std::span<double> stiffness, std::span<double> damping) const;

  /// All that decides the future. Collective.
  void archive(parallel::Archive& archive);

  /// Adds the supports' dashpot constant at each owned node, N s/m. [owned nodes]
  void add_support_damping(std::span<double> damping) const;

 private:
  /// The force on one node for a signal of 1.
  struct NodeForceOfPulse {
    Index node;
    Vector3 force;  ///< N
  };
  struct Pulse {
    mesh::Patch patch;
    Vector3 force;
    scene::Signal signal;
    std::size_t body;
    std::optional<Vector3> balanced_at;     ///< mean point of the patch of a balanced pulse, m
    std::vector<NodeForceOfPulse> inertia;  ///< [owned nodes of the body] of a balanced pulse
  };
  /// A patch node's own spring and dashpot, its share of the support's.
  struct Spring {
    Index node;
    double stiffness;  ///< N/m
    double damping;    ///< N s/m
  };
  std::vector<Pulse> pulses_;
  std::vector<Wind> winds_;
  std::vector<BowLoad> bows_;
  std::vector<Spring> springs_;
};

}  // namespace idiophone::motion
