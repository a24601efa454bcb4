#pragma once
// Strains of joined bodies as vectors, at the quadrature points of their elements and in their joints: their product is
// twice an elastic energy.

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::eigenmodes {

/// A spring between nodes, one point of a joint.
struct NodeSpring {
  std::vector<Index> nodes;
  Eigen::MatrixXd root;  ///< R [stretches x 3 nodes] of its stiffness R^T R, (N/m)^1/2
};

/// A strain e of elements is the vector of sqrt(v) L^T e at all quadrature points: v is the volume of a point (m3), C =
/// L L^T the stiffness, and shears count twice in e. So the product of two strains is the integral of e : C : e', J.
/// After them are the stretches R u of springs. A field is [3 x nodes], m; several are columns.
class StrainSpace {
 public:
  /// @param part       all bodies, on one rank; must outlive this object
  /// @param stiffness  [bodies][regions]
  /// @param springs    between the bodies
  StrainSpace(const mesh::Part& part, std::span<const std::vector<solid::StiffnessMatrix>> stiffness,
              std::vector<NodeSpring> springs = {});

  /// How many numbers a strain has.
  [[nodiscard]] Eigen::Index size() const { return size_; }

  /// Linear strains of fields u: the symmetric part of grad u, and R u of springs. [size() x fields]
  [[nodiscard]] Eigen::MatrixXd linear(const Eigen::Ref<const Eigen::MatrixXd>& fields) const;

  /// The rest of Green's strains of fields u: 1/2 (grad u)^T grad u, and nothing of springs. [size() x fields]
  [[nodiscard]] Eigen::MatrixXd quadratic(const Eigen::Ref<const Eigen::MatrixXd>& fields) const;

  /// The transpose of `linear`: forces whose work on a field is the product of a strain with the field's, N. [3 x
  /// nodes, strains]
  [[nodiscard]] Eigen::MatrixXd forces(const Eigen::Ref<const Eigen::MatrixXd>& strains) const;

  /// H with q . H q = product of a strain with quadratic(sum q phi), symmetric. [strains][modes x modes]
  /// @param strains  [size() x strains]
  /// @param shapes   phi, [3 x nodes, modes]
  [[nodiscard]] std::vector<Eigen::MatrixXd> products(const Eigen::MatrixXd& strains,
                                                      const Eigen::MatrixXd& shapes) const;

  /// T with q . T q = mean square in the body of the rotation angle 1/2 |curl(sum q phi)|. [modes x modes]
  [[nodiscard]] Eigen::MatrixXd rotations(const Eigen::MatrixXd& shapes) const;

 private:
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  /// One element: what its quadrature points need.
  struct Element {
    std::span<const Index> nodes;
    const Matrix6* root = nullptr;  ///< L of its region
    Eigen::Index first = 0;         ///< number of its first point
    Eigen::MatrixXd slopes;         ///< [nodes, 3 x points] dN_a/dX at each point, 1/m
    Eigen::VectorXd volumes;        ///< [points] m3

    [[nodiscard]] Eigen::Index points() const { return volumes.size(); }
  };
  void for_each_element(const std::function<void(const Element& element)>& visit) const;
  /// @param number  of the body
  /// @param first   number of its first point
  void for_each_element(std::size_t number, Eigen::Index first,
                        const std::function<void(const Element& element)>& visit) const;

  /// Strains of fields, which `strain_of` finds from a field's gradient.
  template <class StrainOf>
  [[nodiscard]] Eigen::MatrixXd strains(const Eigen::Ref<const Eigen::MatrixXd>& fields,
                                        const StrainOf& strain_of) const;

  /// v sigma of the parts of strains that an element has, J. [6 x points, strains]
  [[nodiscard]] static Eigen::MatrixXd stresses_of(const Eigen::Ref<const Eigen::MatrixXd>& strains,
                                                   const Element& element);

  const mesh::Part& part_;
  std::vector<std::vector<Matrix6>> roots_;  ///< [bodies][regions] L
  std::vector<NodeSpring> springs_;
  Eigen::Index points_ = 0;
  Eigen::Index size_ = 0;
};

}  // namespace idiophone::eigenmodes
