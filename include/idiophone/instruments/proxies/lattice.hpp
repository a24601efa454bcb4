#pragma once
// A body as a lattice: point masses at the nodes of a tetrahedral mesh, springs along its edges (O'Morain 2005,
// sections 6.2 to 6.4). Proxies of several equal bodies share one lattice.

#include <array>
#include <span>
#include <vector>

#include "idiophone/instruments/proxies/tetrahedral_mesh.hpp"

namespace idiophone::proxies {

/// Damping of the motion: a mode of the angular frequency w decays at the rate (mass + stiffness w^2)/2, 1/s.
struct Damping {
  double mass = 0.0;       ///< 1/s
  double stiffness = 0.0;  ///< dampers parallel to the springs: damper constant over spring constant, s
};

/// The damping that gives two frequencies their decay times.
/// @param frequency  two different ones, Hz
/// @param t60        time in which their amplitudes fall by 60 dB, s
/// @throws std::invalid_argument when one of the two constants would be negative
[[nodiscard]] Damping damping_for(const std::array<double, 2>& frequency, const std::array<double, 2>& t60);

/// What springs and masses are derived from. A lattice of springs has Poisson's ratio 1/4 (Cauchy's relations).
struct Material {
  double young = 0.0;    ///< Young's modulus, Pa
  double density = 0.0;  ///< kg/m3
  Damping damping;
};

/// Of a tetrahedron: a factor for each of its edges. These join the corners 01, 02, 03, 12, 13 and 23.
using EdgeFactors = std::array<double, 6>;

/// A single spring that differs from the others: factors of what it has otherwise.
struct OwnSpring {
  Index a = 0, b = 0;      ///< its masses, in any order
  double stiffness = 1.0;  ///< above 0
  double damping = 1.0;    ///< not negative
  double length = 1.0;     ///< natural length, above 0
};

/// Parts of a body that differ from its material: each spring has what the tetrahedra around it have, times values of
/// its own, and each mass can have a value of its own (O'Morain 2005, section 6.3).
struct OwnValues {
  std::vector<double> stiffness;   ///< [tetrahedra] times Young's modulus of the material, above 0; empty: 1
  std::vector<double> damping;     ///< [tetrahedra] times its stiffness damping, not negative; empty: 1
  std::vector<double> length;      ///< [tetrahedra] natural length over the length in the mesh, above 0; empty: 1
  std::vector<EdgeFactors> edges;  ///< [tetrahedra] times the stiffness along its edges, above 0; empty: 1
  std::vector<double> masses;      ///< [nodes] kg, above 0; empty: those of the material's density
  std::vector<OwnSpring> springs;
};

/// A spring between two masses. It is at its natural length, or the springs hold each other under tension at rest.
struct Spring {
  Index a = 0, b = 0;
  double stiffness = 0.0;  ///< N/m
  double damping = 0.0;    ///< of its damper: damper constant over spring constant, s
  double section = 0.0;    ///< cross-section of the body that it stands for, sum(V)/l, m2
  double natural = 0.0;    ///< length without tension, m
  double tension = 0.0;    ///< at rest: stiffness (length - natural), N
};

/// Total mass and its moments.
struct Inertia {
  double mass = 0.0;                                 ///< kg
  Vector3 centre = Vector3::Zero();                  ///< of mass, m
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< sum or integral of (x - centre)(x - centre)^T, kg m2
};

/// Where a force acts: shares of it at the three masses of a surface triangle. Shares add up to 1.
struct Contact {
  std::array<Index, 3> masses{};
  std::array<double, 3> shares{};
};

class Lattice {
 public:
  /// Springs have the stiffness E sum(V)/l^2 with the volumes V of the tetrahedra around an edge of length l (A. Van
  /// Gelder, Approximate simulation of elastic membranes by triangulated spring meshes, J. Graphics Tools 3(2), 1998,
  /// section 4). In a uniform strain, with springs in all directions, this gives Young's modulus E: then the Lame
  /// constants are sum(k l^2)/(15 V), and E = sum(k l^2)/(6 V) (M. Born and K. Huang, Dynamical Theory of Crystal
  /// Lattices, 1954, section 11). The strain of a real lattice is not quite uniform, which makes it a little softer.
  ///
  /// Each tetrahedron gives a quarter of its mass to each corner. The masses are then changed by as little as possible
  /// so that the second moments are those of the continuous body, too. If this would leave a mass with less than a
  /// quarter of its value, the correction is reduced by a factor for all masses.
  ///
  /// Springs whose natural length is not that in the mesh move the masses to where all forces are in equilibrium. That
  /// is the body at rest, and mesh() has these places. Springs under tension at rest also pull back what moves across
  /// them.
  /// @param pinned  masses that do not move; none, or at least three that are not on a line
  /// @throws std::invalid_argument for a flat tetrahedron, numbers out of range, masses without a spring between them,
  ///         one or two pinned masses, or natural lengths without a stable equilibrium in which every tetrahedron keeps
  ///         its orientation
  Lattice(TetrahedralMesh mesh, const Material& material, std::span<const Index> pinned = {}, OwnValues own = {});

  [[nodiscard]] const TetrahedralMesh& mesh() const { return mesh_; }  ///< at rest
  /// [nodes] m: as the lattice got them. Springs of other natural lengths have moved them to where they rest.
  [[nodiscard]] const std::vector<Vector3>& given_nodes() const {
    return given_nodes_.empty() ? mesh_.nodes : given_nodes_;
  }
  [[nodiscard]] const std::vector<double>& masses() const { return masses_; }  ///< [nodes] kg
  [[nodiscard]] const std::vector<Spring>& springs() const { return springs_; }
  [[nodiscard]] const Inertia& inertia() const { return inertia_; }  ///< of the point masses
  [[nodiscard]] const Inertia& body_inertia() const {
    return body_inertia_;
  }  ///< of the continuous body, as it was given
  /// Its stiffness is the largest of all springs.
  [[nodiscard]] const Damping& damping() const { return damping_; }
  [[nodiscard]] bool is_damped_evenly() const;  ///< all springs alike
  [[nodiscard]] bool is_under_tension() const;  ///< springs have natural lengths of their own
  [[nodiscard]] bool has_own_springs() const { return !own_.springs.empty(); }
  [[nodiscard]] const Material& material() const { return material_; }
  [[nodiscard]] const OwnValues& own() const { return own_; }
  /// Of a tetrahedron, as OwnValues.
  [[nodiscard]] double own_stiffness(std::size_t t) const { return own_.stiffness.empty() ? 1.0 : own_.stiffness[t]; }
  [[nodiscard]] EdgeFactors own_edges(std::size_t t) const {
    return own_.edges.empty() ? EdgeFactors{1.0, 1.0, 1.0, 1.0, 1.0, 1.0} : own_.edges[t];
  }
  [[nodiscard]] double own_damping(std::size_t t) const { return own_.damping.empty() ? 1.0 : own_.damping[t]; }
  [[nodiscard]] const std::vector<bool>& pinned() const { return pinned_; }  ///< [nodes]
  [[nodiscard]] bool is_free() const { return is_free_; }                    ///< nothing is pinned

  /// An upper bound of the angular frequencies without damping, rad/s, a few percent above the largest one
  /// (docs/method/proxies.md, Steps). It counts that a spring under tension also pulls back what moves across it.
  [[nodiscard]] double largest_angular_frequency() const { return largest_angular_frequency_; }

  /// The contact at a point of the physics body: where the ray from the centre of mass through the point leaves the
  /// surface, nearest to the point, shared inversely to the distances (O'Morain 2005, section 6.5, figure 6.2). If a
  /// mass of the surface is nearer to the point, at this mass: in the middle plane of a thin body, the ray ends at the
  /// rim.
  [[nodiscard]] Contact contact_at(const Vector3& point) const;

 private:
  void check() const;
  void find_springs(std::span<const double> volumes);
  void change_own_springs();
  void find_rest(std::span<const double> volumes);

  TetrahedralMesh mesh_;
  std::vector<Vector3> given_nodes_;  // if they are others
  Material material_;
  OwnValues own_;
  std::vector<double> masses_;
  std::vector<Spring> springs_;
  Inertia inertia_, body_inertia_;
  Damping damping_;
  std::vector<bool> pinned_;
  bool is_free_ = true;
  double largest_angular_frequency_ = 0.0;
};

}  // namespace idiophone::proxies
