#pragma once
// A bow that rubs a patch of a body by friction with memory.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/foundation/friction/elasto_plastic_friction.hpp"
#include "idiophone/foundation/parallel/archive_row.hpp"
#include "idiophone/foundation/parallel/reproducible_sum.hpp"
#include "idiophone/scene/load_sections.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/body_model.hpp"

namespace idiophone::motion {

/// The bow moves and presses as the deck says. It feels the mean velocity of its patch along its direction, and its
/// force is shared by the patch. The velocity of a step, v_{n-1/2}, is exactly the mean of that from t_{n-1} to t_n.
/// So it takes the bristles of the friction from t_{n-1} to t_n, whose deflection then makes the force at t_n: bristles
/// that stick are a spring of central differences (docs/method/theory.md). A rank that owns a node of the patch has
/// all of them, and computes the same numbers as all others that do.
class BowLoad {
 public:
  /// @param patch  global nodes
  /// @param part   has all of the patch's nodes if it owns one (coupled_nodes)
  BowLoad(const scene::Bow& bow, const mesh::Patch& patch, const mesh::Part& part);

  /// From now on, steps have this length, s. The bristles are at rest.
  void begin(double step);

  /// Adds the force at `time` (s) on the owned nodes, N.
  /// @param state  [local nodes] u_n and v_{n-1/2}
  void add(double time, std::span<const NodeState> state, std::span<NodeForce> force) const;

  /// The sum of these forces, each component, N.
  [[nodiscard]] std::array<ReproducibleSum, 3> total(double time, std::span<const NodeState> state) const;

  /// Once a step: the bristles go on to `time`, and the force is noted for its work.
  void remember(double time, std::span<const NodeState> state);

  /// Adds the work that the noted force does in the step, with the velocities of that step, J.
  void add_work(const Step& step, std::span<const NodeState> state, ReproducibleSum& work) const;

  /// Adds a spring and a dashpot to the ground at each local node, the same in all directions, that are at least as
  /// stiff and as lossy as the bristles under any motion, N/m and N s/m. [local nodes]
  void add_bounds(std::span<double> stiffness, std::span<double> damping) const;

  /// Whether it may act from `begin` to `end`, s.
  [[nodiscard]] bool acts(double begin, double end) const;

  /// Owned nodes of the patch.
  [[nodiscard]] std::vector<Index> nodes() const;

  /// Whether this rank owns a node of the patch.
  [[nodiscard]] bool is_here() const { return !nodes_.empty(); }

  /// The state of the bristles.
  void archive(parallel::ArchiveRow& row) { friction_->archive(row); }

 private:
  struct Node {
    Index number;  // local
    double share;
    bool is_owned;
  };
  template <class Visit>
  void visit_forces(double time, std::span<const NodeState> state, const Visit& visit) const;
  /// Of the bow relative to the patch along the direction, m/s.
  [[nodiscard]] double relative_velocity(double time, std::span<const NodeState> state) const;
  [[nodiscard]] double load(double time) const { return bow_.load_at(time - bow_.start); }

  scene::Bow bow_;
  std::vector<Node> nodes_;  // in the order of the patch; none without an owned one
  std::optional<friction::ElastoPlasticFriction> friction_;
  double noted_ = 0.0;  // force, N
};

}  // namespace idiophone::motion
