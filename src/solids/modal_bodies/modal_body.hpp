#pragma once
// A body that moves rigidly and vibrates by its modes about that motion; one that is held only vibrates. It lies on one
// rank. A node X is at c + R (X - C + sum_k q_k phi_k(X) + s), s the residual displacement where a force acts. Among
// bodies that pull at it at rest, it is displaced by that, too, and its stress at rest acts on the modes.

#include <memory>
#include <string>

#include "floating_frame.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/modal_bodies/modal_basis.hpp"
#include "idiophone/solids/motion/body_model.hpp"
#include "modal_coordinates.hpp"
#include "modal_inertia.hpp"
#include "modal_shapes.hpp"
#include "residual_flexibility.hpp"

namespace idiophone::modal_bodies {

using motion::NodeForce;
using motion::NodeState;
using motion::Step;

class ModalBody;

/// The modes of a body, or those that several bodies have in common. All of them lie on one rank.
struct CommonModes {
  explicit CommonModes(const ModalBasis& basis) : coordinates(basis) {}

  ModalCoordinates coordinates;
  std::vector<ModalBody*> bodies;  ///< in their order; the first one takes the coordinates from step to step
};

class ModalBody : public motion::BodyModel {
 public:
  /// @param name     of the body
  /// @param gravity  m/s2
  /// @param part     must outlive this object; has all nodes of the body, or none
  /// @param number   of the body in the part
  /// @param modes    of this body and of others, to which it is added; each of them has to live as long as any is used
  ModalBody(std::string name, const Vector3& gravity, const mesh::Part& part, std::size_t number,
            const ModalBasis& basis, std::shared_ptr<CommonModes> modes);

  void begin(double step) override;
  void start(const scene::Body& body, const Vector3& centre, std::span<NodeState> state) override;
  void clear_force(std::span<NodeForce> force) const override;
  void add_internal_force(std::span<const NodeState> /*state*/, std::span<NodeForce> /*force*/) const override {}
  void begin_internal_force(std::span<const NodeState> /*state*/, std::span<NodeForce> /*force*/) override {}
  void finish_internal_force(std::span<const NodeState> /*state*/, std::span<NodeForce> /*force*/) override {}
  void hide_exchange() override {}
  void advance_velocities(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                          ReproducibleSum& work) override;
  void advance_displacements(const Step& step, std::span<NodeState> state) override;
  void choose_nodes(std::span<const Index> nodes, int most_at_once) override;
  [[nodiscard]] int steps_at_once() const override { return steps_at_once_; }
  void update_nodes(std::span<NodeState> state) override;
  [[nodiscard]] std::optional<motion::ModalState> modal_state() const override;
  [[nodiscard]] std::span<const double> masses() const override { return inertia_.masses(); }
  [[nodiscard]] std::vector<double> inverse_masses() const override;
  /// Modes do not limit it, but the residual flexibility is to be resolved, and supports and the stress at rest stiffen
  /// it.
  [[nodiscard]] motion::StableStep stable_step(const motion::Supports& supports,
                                               const motion::BodyRanks& ranks) const override;
  /// Of the shapes, those of all nodes and in packs, of stretching and of the rest.
  [[nodiscard]] std::size_t bytes() const override {
    return (2 * modes_ * masses().size() + rest_.size()) * sizeof(Vector3) + (is_first() ? coordinates().bytes() : 0) +
           static_cast<std::size_t>(rest_stiffness_.size()) * sizeof(double);
  }
  void add_sums(const Step& step, std::span<NodeForce> force, std::span<const NodeState> state, const Vector3& centre,
                const motion::BodyUnits& unit, std::span<motion::BodySums> of_body) const override;
  void archive(parallel::Archive& archive) override;

 private:
  /// Forces on the body now.
  struct Load {
    Eigen::ArrayXd modal;              ///< [modes] N/kg^1/2
    Vector3 force = Vector3::Zero();   ///< N
    Vector3 torque = Vector3::Zero();  ///< about the centre, N m
    std::vector<PackVector> at_nodes;  ///< [packs of chosen nodes] in the body's frame, N
  };

  [[nodiscard]] bool is_here() const { return !inertia_.masses().empty(); }
  [[nodiscard]] bool moves_in(const Step& step) const { return is_here() && step.number % steps_at_once_ == 0; }
  /// As many steps at once as leave all oscillators below 2.5 rad a step: the recurrences are exact, and resonances
  /// with forces that depend on the motion begin at pi.
  [[nodiscard]] int resolved(int most_at_once) const;
  /// The part of the nodes' own inverse masses that rigid motion and modes lack, mean of all directions, 1/kg. [nodes]
  [[nodiscard]] std::vector<double> omitted_mobility() const;
  /// At least the largest eigenvalue of springs from nodes to the ground among all coordinates, (rad/s)^2.
  /// @param springs  [local nodes] N/m; of dashpots (N s/m), the eigenvalue is in 1/s
  [[nodiscard]] double largest_eigenvalue(std::span<const double> springs) const;
  [[nodiscard]] ModalCoordinates& coordinates() { return common_->coordinates; }
  [[nodiscard]] const ModalCoordinates& coordinates() const { return common_->coordinates; }
  /// Of the vibration, J.
  /// @param rates  [modes] kg^1/2 m/s
  [[nodiscard]] double kinetic_energy(const Eigen::ArrayXd& rates) const;
  [[nodiscard]] bool is_first() const { return common_->bodies.front() == this; }
  [[nodiscard]] bool is_alone() const { return common_->bodies.size() == 1; }
  /// Adds the forces on the other bodies of common modes to those on this one.
  /// @param modal  [modes] N/kg^1/2
  void add_loads_of_others(std::span<const NodeForce> force, std::span<const NodeState> state,
                           Eigen::ArrayXd& modal) const;
  void find_load(std::span<const NodeForce> force, std::span<const NodeState> state, Load& load) const;
  /// m
  [[nodiscard]] Vector3 rest_at(std::size_t node) const { return rest_.empty() ? Vector3::Zero() : rest_[node]; }
  /// What the vibration has stored against the stress at rest, J.
  [[nodiscard]] double energy_of_rest() const;
  /// Of the displacements at rest, less their mean, r, kg m2.
  struct RestMoments {
    Eigen::Matrix3d with_arms = Eigen::Matrix3d::Zero();  ///< sum m r a^T, a the arms at rest
    Eigen::Matrix3d square = Eigen::Matrix3d::Zero();     ///< sum m r r^T
  };
  [[nodiscard]] RestMoments find_rest_moments() const;
  void update_chosen(std::span<NodeState> state) const;
  /// Puts the states of a pack of nodes together from rigid motion and vibration.
  void move(const NodeGroup& group, std::size_t pack, const NodeGroup::Vibration& vibration,
            std::span<NodeState> state) const;

  const mesh::Part& part_;
  const mesh::BodyPart& body_;
  std::string name_;
  Vector3 gravity_;
  bool is_free_;
  bool has_residual_;  ///< on any rank
  std::size_t nodes_;  ///< on all ranks
  std::size_t modes_;  ///< likewise
  ModalShapes shapes_;
  ModalInertia inertia_;
  NodeGroup all_;     ///< all nodes
  NodeGroup chosen_;  ///< nodes that are read in every step
  std::shared_ptr<CommonModes> common_;
  ResidualFlexibility residual_;         ///< of the chosen nodes
  std::vector<Vector3> rest_;            ///< [nodes] displacements at rest, m; empty: none. Arms are from there
  Vector3 mean_rest_ = Vector3::Zero();  ///< of the centre of mass, m
  Eigen::ArrayXd rest_force_;            ///< [modes] likewise, of its stress there, N/kg^1/2
  Eigen::MatrixXd rest_stiffness_;       ///< [modes x modes] that this stress adds, 1/s2
  RestMoments rest_moments_;
  Eigen::MatrixXd share_of_mass_;  ///< [modes x modes] of common modes, M of this body's nodes; empty: the identity
  FloatingFrame frame_;
  Load load_;                 ///< of the step, kept for its memory
  double highest_frequency_;  ///< of all oscillators, rad/s
  double step_ = 0.0;         ///< dt, s
  int steps_at_once_ = 1;
  double before_ = 0.0;  ///< length of the last step taken, s; zero at time 0
};

}  // namespace idiophone::modal_bodies
