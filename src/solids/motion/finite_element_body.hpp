#pragma once
// A body of finite elements: central differences with the mass matrix, in which constraints hold components.

#include <algorithm>
#include <span>
#include <string>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/body_model.hpp"
#include "idiophone/solids/motion/constraints.hpp"
#include "idiophone/solids/motion/dynamics.hpp"
#include "idiophone/solids/solid/mass.hpp"
#include "idiophone/solids/solid/solid.hpp"

namespace idiophone::motion {

class FiniteElementBody : public BodyModel {
 public:
  /// @param part         must outlive this object, as must `constraints`
  /// @param constraints  of all bodies
  /// @param number       of the body
  /// @param lumped       [local nodes] the body's lumped mass is added, kg
  /// @throws std::runtime_error where an element is inverted (see solid::Solid)
  FiniteElementBody(const scene::Solids& solids, const mesh::Part& part, const Constraints& constraints,
                    std::size_t number, MassScaling scaling, std::span<double> lumped);

  void begin(double step) override { solid_.begin_memory(step); }
  void start(const scene::Body& body, const Vector3& centre, std::span<NodeState> state) override;
  void clear_force(std::span<NodeForce> force) const override {
    std::ranges::fill(force.subspan(body_.owned_begin, body_.owned_end - body_.owned_begin), NodeForce{});
  }
  void add_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) const override {
    solid_.add_internal_force(state, force);
  }
  void begin_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) override {
    solid_.begin_internal_force(state, force);
  }
  void finish_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) override {
    solid_.finish_internal_force(state, force);
  }
  void hide_exchange() override { solid_.divide(body_); }
  /// v_{n+1/2} = v_{n-1/2} + dt a_n. Mass-proportional damping is centred in time.
  void advance_velocities(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                          ReproducibleSum& work) override;
  /// u_{n+1} = u_n + dt v_{n+1/2}.
  void advance_displacements(const Step& step, std::span<NodeState> state) override;
  void choose_nodes(std::span<const Index> /*nodes*/, int /*most_at_once*/) override {}  // all are up to date
  void update_nodes(std::span<NodeState> /*state*/) override {}
  [[nodiscard]] std::span<const double> masses() const override { return mass_.lumped(); }
  [[nodiscard]] std::vector<double> inverse_masses() const override;
  /// By the largest eigenfrequency, which SLEPc finds on rank 0 from the forces that all ranks compute. A body all of
  /// whose nodes are held has none.
  [[nodiscard]] StableStep stable_step(const Supports& supports, const BodyRanks& ranks) const override;
  [[nodiscard]] std::size_t bytes() const override { return solid_.bytes(); }
  void add_sums(const Step& step, std::span<NodeForce> force, std::span<const NodeState> state, const Vector3& centre,
                const BodyUnits& unit, std::span<BodySums> sums) const override;
  void archive(parallel::Archive& archive) override;

  [[nodiscard]] const solid::Solid& solid() const { return solid_; }
  [[nodiscard]] const solid::Mass& mass() const { return mass_; }
  /// By how much mass scaling lowers the pitch of what can be heard, at most, by an estimate; cents
  [[nodiscard]] double predicted_shift() const { return predicted_shift_; }

 private:
  /// Velocities of the owned nodes at t_n, m/s. [owned nodes of all bodies, up to the body's last]
  [[nodiscard]] std::vector<Vector3> find_velocities(const Step& step, std::span<NodeForce> force,
                                                     std::span<const NodeState> state) const;
  /// Adds the solid's lumped mass, kg; [local nodes]
  [[nodiscard]] solid::Mass make_mass(const scene::Solids& solids, MassScaling scaling, std::span<double> lumped);
  /// What mass scaling makes; sets predicted_shift_.
  /// @param lumped  [local nodes] kg
  [[nodiscard]] solid::AddedMass added_mass(const scene::Solids& solids, std::span<const double> lumped);

  std::string name_;
  double highest_loss_;  ///< as in StableStep
  double predicted_shift_ = 0.0;

 protected:
  const mesh::Part& part_;
  const mesh::BodyPart& body_;
  const Constraints& constraints_;
  std::size_t number_;
  Vector3 gravity_;
  double mass_damping_;  ///< alpha, 1/s
  solid::Solid solid_;
  solid::Mass mass_;
};

}  // namespace idiophone::motion
