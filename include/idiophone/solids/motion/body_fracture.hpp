#pragma once
// Fracture of a body along surfaces named in its mesh. Nodes at one place of such a surface are joined: they move as
// one node with the sum of their masses. A face breaks, for ever, when the stress across it passes its strength; nodes
// between which no face is left move on their own. Displacements and velocities do not jump, and the force between
// joined nodes does no work, so this alone costs no energy. With a fracture energy G, the stress that the face had goes
// on and falls linearly to zero while it opens, as in the cohesive law of Camacho and Ortiz (Computational modelling of
// impact damage in brittle materials, Int. J. Solids Struct. 33, 1996).
//
// One rank has all of a body's fracture surfaces (mesh/owners.cpp).

#include <mpi.h>

#include <array>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/body_model.hpp"

namespace idiophone::motion {

class BodyFracture {
 public:
  /// @param body    its number
  /// @param faces   all of the body's, global nodes
  /// @param part    must outlive this object
  /// @param masses  lumped, [owned nodes of the body] kg
  /// @param held    components that constraints hold, as Constraints has them
  BodyFracture(const scene::Solids& solids, std::size_t body, std::span<const mesh::FractureFace> faces,
               const mesh::Part& part, std::span<const double> masses, std::span<const Index> held);

  [[nodiscard]] std::size_t body() const { return body_; }

  /// The end of the first half of a step, in which each node got its velocity by the forces on it alone. Faces break
  /// whose stress is too large; then joined nodes get their common velocity, that of their momentum.
  /// @param state  [local nodes]
  void join(const Step& step, std::span<NodeState> state);

  /// Gives joined nodes forces that accelerate them alike: their sum, in shares of their masses.
  /// @param force  [local nodes] N
  void share(std::span<NodeForce> force) const;

  /// Energy that the broken faces have taken so far, with what cohesion still stores, J; 0 where this rank does not own
  /// the surfaces.
  [[nodiscard]] double taken_energy() const;

  /// Whether a face is broken; false where this rank does not own the surfaces.
  [[nodiscard]] bool is_broken(std::size_t face) const { return !broken_.empty() && broken_[face] != 0; }

  /// What still hangs together: for each piece that the body can fall apart into, the number of the first one that
  /// faces join it with, directly or over others. Numbers from 1; all 0 where this rank does not own the surfaces.
  [[nodiscard]] std::vector<Index> joined_pieces() const;

  /// Area of the broken faces, undeformed, m2; 0 where this rank does not own the surfaces.
  [[nodiscard]] double broken_area() const;

  /// Collective.
  void archive(parallel::Archive& archive);

 private:
  /// Nodes in one place.
  struct Joint {
    std::vector<Index> nodes;         ///< local numbers, ascending
    std::vector<double> masses;       ///< [nodes] kg
    std::vector<Index> leaders;       ///< [nodes] place among them of the first one that it is joined with
    bool is_measured = false;         ///< two nodes, free in all directions: the force between them is known
    double area = 0.0;                ///< of the faces around it that are not broken, m2
    Vector3 force = Vector3::Zero();  ///< of the second node on the first, N
  };
  struct Face {
    scene::FractureSurface law;                ///< of its surface
    double area = 0.0;                         ///< undeformed, m2
    std::vector<Index> corners;                ///< of side 0, local nodes
    std::vector<double> shares;                ///< [nodes of a side] see mesh::FractureFace
    std::vector<std::size_t> joints;           ///< [nodes of a side] places in joints_
    std::array<std::vector<Index>, 2> places;  ///< [sides][nodes of a side] of the nodes in their joints
    double weight = 0.0;                       ///< sum of the shares of the measured nodes
  };
  /// What still holds the sides of a broken face together.
  struct Cohesion {
    Vector3 stress = Vector3::Zero();  ///< on side 0 when it broke, Pa
    double widest = 0.0;               ///< opening along that stress so far, m
    double opening = 0.0;              ///< now, m
  };

  void add_joints(const std::vector<Index>& nodes, std::span<const double> masses, std::span<const Index> held);
  void add_face(const mesh::FractureFace& face, const scene::FractureSurface& law);
  /// Of a face that moved, from side 0 to side 1.
  [[nodiscard]] Vector3 normal_of(const Face& face, std::span<const NodeState> state) const;
  /// Stress on side 0 of a face by the forces in its joints, Pa.
  [[nodiscard]] Vector3 stress(const Face& face) const;
  [[nodiscard]] bool is_too_weak(const Face& face, std::span<const NodeState> state) const;
  /// The faces that break now.
  std::vector<std::size_t> break_faces(std::span<const NodeState> state);
  /// The nodes of both sides at one of the places of a face.
  [[nodiscard]] std::array<Index, 2> pair_of(const Face& face, std::size_t place) const;
  /// Calls visit(place, part) for the measured nodes of a face that a constant stress acts on, with the part of its
  /// force that each bears for all of them.
  template <class Visitor>
  void for_each_bearing(const Face& face, Visitor visit) const;
  /// Pulls both sides of a broken face together. @param gain  of a velocity over an acceleration, s
  void hold_together(std::size_t face, double gain, std::span<NodeState> state);
  /// Sides of broken faces that meet again do not pass through each other.
  void press(std::span<NodeState> state) const;
  /// Stress of cohesion over the one at the break, and the largest opening that it lasts to, m.
  [[nodiscard]] double cohesion_left(std::size_t face) const;
  [[nodiscard]] double last_opening(std::size_t face) const;
  /// Joins the nodes of all joints anew, by the faces that are not broken.
  void join_nodes();
  template <class Visitor>
  void for_each_group(Visitor visit) const;

  const mesh::Part& part_;
  std::size_t body_;
  std::string name_;
  double mass_damping_;       ///< alpha, 1/s
  std::size_t global_faces_;  ///< of the body
  std::vector<Joint> joints_;
  std::vector<Face> faces_;          ///< empty where this rank does not own the surfaces
  std::vector<char> broken_;         ///< [faces_]
  std::vector<Cohesion> cohesions_;  ///< [faces_]
};

}  // namespace idiophone::motion
