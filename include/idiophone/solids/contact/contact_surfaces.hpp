#pragma once
// What must be known of whole bodies and obstacles before they can touch. Rank 0 finds it and broadcasts it.

#include <mpi.h>

#include <span>
#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/contact/rigid_shape.hpp"
#include "idiophone/solids/contact/skin.hpp"

namespace idiophone::contact {

struct ContactSurfaces {
  std::vector<Skin> skins;         ///< [bodies]; empty ones for bodies that touch nothing
  std::vector<RigidShape> shapes;  ///< [obstacles]
  std::vector<double> stiffness;   ///< [contacts] pressure per depth of overlap, Pa/m
};

/// Skins and shapes; the stiffness is chosen later. Call where the meshes are.
/// @throws deck::DeckError where an obstacle's mesh can't be read
[[nodiscard]] ContactSurfaces find_contact_surfaces(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes);

/// Rank 0's contact surfaces, on every rank. Collective.
[[nodiscard]] ContactSurfaces broadcast(ContactSurfaces contact_surfaces, MPI_Comm communicator);

/// Part of the largest squared eigenfrequency of the bodies by which contact may raise it: the step falls to
/// 1/sqrt(1 + share), by 11 %.
constexpr double stiffness_share = 0.25;

/// The same for contacts of which all bodies are hexahedra: by 29 % at the most. They are so accurate that the overlap
/// would be what errs.
constexpr double stiffness_share_of_hexahedra = 1.0;

/// Sets the stiffness of every contact: the deck's, or as much as `share` and the kind of its elements allow.
/// @param inverse_mass       [global nodes] 1/kg, zero for nodes that are held
/// @param largest_frequency  of any body, rad/s
/// @param share              as stiffness_share_of_hexahedra
void choose_stiffness(const scene::Solids& solids, std::span<const double> inverse_mass, double largest_frequency,
                      double share, ContactSurfaces& contact_surfaces);

/// How much a contact can add to the square of a body's largest eigenfrequency: for each of its contacts,
/// k (max A/m of one side + max A/m of the other), A and m the surface and mass of a node; the largest of these,
/// since contacts share a node's surface. 1/s2, [bodies]
[[nodiscard]] std::vector<double> squared_frequencies(const scene::Solids& solids, std::span<const double> inverse_mass,
                                                      const ContactSurfaces& contact_surfaces);

/// What the bristles of friction with memory add to a body at most.
struct BristleBounds {
  double square = 0.0;   ///< to the square of its largest eigenfrequency, 1/s2
  double damping = 0.0;  ///< to its rate of damping c, as StableStep::damping, 1/s
};

/// The sum over a body's contacts with such friction: stiffness, and damping with viscosity, times the largest inverse
/// masses of both sides' skins. The shares of the nodes in them add up to 1. [bodies]
[[nodiscard]] std::vector<BristleBounds> bristle_bounds(const scene::Solids& solids,
                                                        std::span<const double> inverse_mass,
                                                        const ContactSurfaces& contact_surfaces);

}  // namespace idiophone::contact
