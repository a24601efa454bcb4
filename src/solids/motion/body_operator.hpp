#pragma once
// The operator whose largest eigenvalue limits a body's step, L^T K L with L L^T = M^-1 (solid::Mass).

#include <mpi.h>
#include <petscsf.h>

#include <span>
#include <vector>

#include "body_rows.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/mass.hpp"
#include "idiophone/solids/solid/node_state.hpp"
#include "idiophone/solids/solid/solid.hpp"

namespace idiophone::motion {

/// A rank's share: y = L^T K L x with held components left out; at rest Kelvin-Voigt's damping force gives K x exactly.
/// Vectors are [3 x owned nodes of the body].
struct BodyOperator {
  const mesh::Part& part;
  const mesh::BodyPart& body;
  const solid::Solid& solid;
  const solid::Mass& mass;
  std::span<const char> held;         ///< 1 where a component is held, [3 x owned nodes of the body]
  std::span<const double> stiffness;  ///< of supports, [local nodes]
  PetscSF ghosts;                     ///< see ghost_exchange; none where all of the body is on this rank
  std::vector<solid::NodeState> state;
  std::vector<solid::NodeForce> force;

  [[nodiscard]] std::size_t size() const { return held.size(); }

  /// Turns x into displacements L x, zero where it is held.
  void apply_factor(std::span<double> x) const;

  /// Puts the nodes at `moved` times a factor, at rest. Collective.
  void displace(std::span<const double> moved, double factor);

  /// Collective.
  /// @param result  not x itself
  void apply(std::span<const double> x, std::span<double> result);

 private:
  [[nodiscard]] solid::NodeState& node(std::size_t component) { return state[body.owned_begin + component / 3]; }
  void receive_ghosts();
  void leave_out_held(std::span<double> values) const;
};

/// The operator on whole vectors, which rank 0 has. Each rank computes its share of them.
class SharedOperator {
 public:
  /// @param own   this rank's share; must outlive this object, as must `rows`
  /// @param rows  of 3 components
  SharedOperator(BodyOperator& own, const BodyRows& rows, MPI_Comm communicator);

  /// Components of a whole vector: on rank 0 only.
  [[nodiscard]] std::size_t size() const { return rows_.size(); }

  /// y = L^T K L x. On rank 0, while the others help.
  void apply(std::span<const double> x, std::span<double> y);

  /// Computes the shares of the ranks other than 0 until rank 0 ends. Returns at once on rank 0.
  void help();

  /// Tells the others on destruction that rank 0 is done.
  class End {
   public:
    explicit End(const SharedOperator& shared) : communicator_(shared.communicator_) {}
    End(const End&) = delete;
    End& operator=(const End&) = delete;
    End(End&&) = delete;
    End& operator=(End&&) = delete;
    ~End();

   private:
    MPI_Comm communicator_;
  };

 private:
  void apply_share(std::span<const double> x, std::span<double> y);

  BodyOperator& own_;
  const BodyRows& rows_;
  MPI_Comm communicator_;
  std::vector<double> x_, y_;  ///< this rank's shares; empty where it has all of the body
};

}  // namespace idiophone::motion
