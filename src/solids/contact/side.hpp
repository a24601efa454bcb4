#pragma once
// One body's side of a contact: where its skin is now, and what the contact does to it.

#include <vector>

#include "idiophone/foundation/parallel/archive_row.hpp"
#include "idiophone/solids/contact/rigid_shape.hpp"
#include "idiophone/solids/contact/skin.hpp"
#include "tetrahedron.hpp"

namespace idiophone::contact {

/// What a node of the skin feels of the partner.
struct Touch {
  bool any = false;
  double volume = 0.0;                 ///< V_i, m3
  double growth = 0.0;                 ///< dV_i/dt, m3/s
  double surface = 0.0;                ///< integral psi_i dA over the partner's surface inside, m2
  Vector3 area = Vector3::Zero();      ///< the same of psi_i n, n the partner's outward normal, m2
  Vector3 moment = Vector3::Zero();    ///< the same of psi_i x, m3
  Vector3 slip = Vector3::Zero();      ///< the same of psi_i (v - v of the partner), m3/s
  double pressure = 0.0;               ///< Pa
  Vector3 friction = Vector3::Zero();  ///< tangential traction, Pa
};

/// What a node remembers from step to step while it touches the partner.
struct Bond {
  Vector3 stretch = Vector3::Zero();  ///< by friction, m
  bool sliding = false;               ///< or it sticks: Coulomb's friction
  double share = 0.0;                 ///< of friction with memory: NodeBristles::share
  int part = 0;                       ///< of a body with itself: 1, the first, or -1; 0: not yet known

  /// Forgets friction.
  void let_go() {
    stretch.setZero();
    sliding = false;
    share = 0.0;
  }
  void archive(parallel::ArchiveRow& row) {
    row.values(stretch);
    row.value(sliding);
    row.value(share);
    row.value(part);
  }
};

struct Side {
  explicit Side(const Skin& of)
      : skin(of),
        reference(of.nodes.size(), Vector3::Zero()),
        position(reference),
        velocity(position),
        force(position),
        touch(of.nodes.size()),
        bond(of.nodes.size()) {}

  const Skin& skin;
  std::vector<Vector3> reference;  ///< [skin nodes], m; true where this rank has the node
  std::vector<Vector3> position;   ///< [skin nodes], m; true where the node may touch
  std::vector<Vector3> velocity;   ///< [skin nodes], m/s; likewise
  std::vector<Vector3> force;      ///< [skin nodes] by the partner, N
  std::vector<Touch> touch;        ///< [skin nodes]
  std::vector<Bond> bond;          ///< [skin nodes]
  std::vector<Index> touched;      ///< nodes with a touch, in the order in which they were found
  std::vector<Index> bonded;       ///< nodes that may have a bond: touched in the last step, or sent by their owner

  [[nodiscard]] Tetrahedron tetrahedron(Index cell) const {
    const auto& nodes = skin.cells[cell];
    const auto at = [&](std::size_t i) { return position[nodes.at(i)]; };
    return Tetrahedron({at(0), at(1), at(2), at(3)});
  }

  [[nodiscard]] Box box(Index cell) const {
    Box box;
    for (const Index node : skin.cells[cell]) {
      box.extend(position[node]);
    }
    return box;
  }
};

}  // namespace idiophone::contact
