#pragma once
// A body of finite elements that an accelerator steps.

#include <memory>
#include <optional>

#include "finite_element_body.hpp"
#include "idiophone/solids/accelerated/accelerated_solid.hpp"

namespace idiophone::motion {

/// The motion of all nodes is in the memory of the accelerator. The processor has that of the nodes on which loads,
/// contacts and other ranks act, in each step, and all of it when it is asked for.
class AcceleratedBody : public FiniteElementBody {
 public:
  /// The others are those of FiniteElementBody.
  /// @param accelerator  must outlive this object
  /// @throws std::runtime_error if the accelerator has no kernels for the body
  AcceleratedBody(accelerator::Accelerator& accelerator, const scene::Solids& solids, const mesh::Part& part,
                  const Constraints& constraints, std::size_t number, MassScaling scaling, std::span<double> lumped);

  void begin(double step) override;
  void start(const scene::Body& body, const Vector3& centre, std::span<NodeState> state) override;
  void clear_force(std::span<NodeForce> force) const override;
  /// By the processor.
  void add_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) const override;
  void begin_internal_force(std::span<const NodeState> /*state*/, std::span<NodeForce> /*force*/) override {}
  void finish_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) override;
  void hide_exchange() override {}
  void advance_velocities(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                          ReproducibleSum& work) override;
  void advance_displacements(const Step& step, std::span<NodeState> state) override;
  void choose_nodes(std::span<const Index> nodes, int most_at_once) override;
  void update_nodes(std::span<NodeState> state) override;
  void update_all(std::span<NodeState> state) override;
  [[nodiscard]] const accelerated::AcceleratedSolid* on_accelerator() const override { return &*there_; }
  void update_ghosts_on_accelerator(std::span<const NodeState> state) override;
  void archive(parallel::Archive& archive) override;

 private:
  using NodeList = accelerated::NodeList;

  [[nodiscard]] bool is_alone() const { return followed_->nodes.empty(); }
  /// Those nodes that are owned ones of the body.
  [[nodiscard]] std::vector<Index> owned(std::span<const Index> nodes) const;

  accelerator::Accelerator& accelerator_;
  std::vector<Index> steered_;  ///< nodes of groups that are driven, and of those that are held beside them
  bool is_loaded_ = false;      ///< the accelerator has the present motion
  std::optional<accelerated::AcceleratedSolid> there_;  ///< from begin() on, as are the lists
  std::optional<NodeList> ghosts_;                      ///< of other ranks
  std::vector<Index> exchanged_;                        ///< whose motion the processor needs in each step, or changes
  bool needs_velocities_ = false;                       ///< of the nodes it follows, before they move: ghosts elsewhere
  std::optional<NodeList> chosen_;                      ///< on which forces act
  std::optional<NodeList> followed_;                    ///< chosen or exchanged: up to date after each step
};

}  // namespace idiophone::motion
