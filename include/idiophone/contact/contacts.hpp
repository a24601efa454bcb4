#pragma once
// All contacts of a scene, on this rank: who is near whom, and the forces between those who touch.

#include <mpi.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "idiophone/contact/contact_motion.hpp"
#include "idiophone/contact/partners.hpp"
#include "idiophone/mesh/part.hpp"
#include "idiophone/solid/node.hpp"

namespace idiophone::contact {

class Contacts {
 public:
  /// Collective.
  /// @param step            dt, s
  /// @param steps_per_look  steps between two looks at who is near whom
  Contacts(const scene::Scene& scene, const mesh::Part& part, const Partners& partners, double step, int steps_per_look,
           MPI_Comm communicator);
  ~Contacts();
  Contacts(const Contacts&) = delete;
  Contacts& operator=(const Contacts&) = delete;
  Contacts(Contacts&&) = delete;
  Contacts& operator=(Contacts&&) = delete;

  /// Finds the forces at a step, from the state of this rank's nodes and ghosts. Talks to the ranks that have a part in
  /// the same contacts; no collective call.
  /// @param moved  false where the same state is met again, after a restart: the bonds of friction then stay as they
  /// are
  void meet(std::int64_t step_number, const solid::NodeState* state, bool moved);

  /// Adds the forces on this rank's nodes, N.
  void add_force(solid::NodeForce* force) const;

  /// Stored in a contact's overlaps and bonds now, J: on the one rank that speaks for it, 0 on the others.
  [[nodiscard]] double energy(std::size_t contact) const;

  /// Means over the steps between the two last looks: force and overlap in time, the others weighted by the force. On
  /// the one rank that speaks for the contact, all zero on the others.
  [[nodiscard]] const ContactMotion& motion(std::size_t contact) const;

  /// The contact as it is now: on the one rank that speaks for it, all zero on the others.
  [[nodiscard]] ContactMotion now(std::size_t contact) const;

  /// Deepest penetration that this rank has seen so far, m.
  [[nodiscard]] double deepest(std::size_t contact) const;

  /// Wall-clock time of meetings since the last call, s.
  [[nodiscard]] double take_seconds() { return std::exchange(seconds_, 0.0); }

  [[nodiscard]] std::size_t count() const { return pairs_.size(); }

  /// Bonds of the own nodes of both sides, [own nodes x bond_width]; zero for nodes of other bodies.
  static constexpr std::size_t bond_width = 4;
  [[nodiscard]] std::vector<double> save(std::size_t contact, Index owned_nodes) const;
  /// What `save` gave, before the state that belongs to it is met again.
  void restore(std::size_t contact, std::span<const double> rows, double deepest);

 private:
  struct Pair;
  std::vector<std::unique_ptr<Pair>> pairs_;  ///< [contacts]
  int steps_per_look_;
  double seconds_ = 0.0;
};

}  // namespace idiophone::contact
