#include "idiophone/solids/contact/contact_surfaces.hpp"

#include <algorithm>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::contact {

namespace {

/// Largest surface per mass of a skin's nodes, m2/kg.
double largest_compliance(const Skin& skin, std::span<const double> inverse_mass) {
  double largest = 0.0;
  for (std::size_t node = 0; node < skin.nodes.size(); ++node) {
    largest = std::max(largest, skin.areas[node] * inverse_mass[skin.nodes[node]]);
  }
  return largest;
}

/// Of both sides of a contact, m2/kg.
double compliance(const scene::Contact& contact, std::span<const double> inverse_mass,
                  const ContactSurfaces& contact_surfaces) {
  return largest_compliance(contact_surfaces.skins[contact.body], inverse_mass) +
         (contact.other ? largest_compliance(contact_surfaces.skins[*contact.other], inverse_mass) : 0.0);
}

double largest_inverse_mass(const Skin& skin, std::span<const double> inverse_mass) {
  double largest = 0.0;
  for (const Index node : skin.nodes) {
    largest = std::max(largest, inverse_mass[node]);
  }
  return largest;
}

void add(const BristleBounds& more, BristleBounds& bounds) {
  bounds.square += more.square;
  bounds.damping += more.damping;
}

double largest_share(const scene::Solids& solids, const scene::Contact& contact) {
  const auto has_hexahedra = [&](std::size_t body) {
    return element::has_choice_of_orders(solids.bodies[body].element);
  };
  const bool all = has_hexahedra(contact.body) && (!contact.other || has_hexahedra(*contact.other));
  return all ? stiffness_share_of_hexahedra : stiffness_share;
}

}  // namespace

ContactSurfaces find_contact_surfaces(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes) {
  ContactSurfaces contact_surfaces;
  const std::vector<Index> first_nodes = mesh::offsets(meshes).nodes;
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    const bool touches = std::ranges::any_of(
        solids.contacts, [&](const scene::Contact& contact) { return contact.body == b || contact.other == b; });
    contact_surfaces.skins.push_back(touches ? make_skin(meshes[b], first_nodes[b]) : Skin{});
  }
  std::ranges::transform(solids.obstacles, std::back_inserter(contact_surfaces.shapes), make_shape);
  return contact_surfaces;
}

ContactSurfaces broadcast(ContactSurfaces contact_surfaces, MPI_Comm communicator) {
  contact_surfaces.skins.resize(parallel::from_root(contact_surfaces.skins.size(), communicator));
  contact_surfaces.shapes.resize(parallel::from_root(contact_surfaces.shapes.size(), communicator));
  for (Skin& skin : contact_surfaces.skins) {
    skin = broadcast(std::move(skin), communicator);
  }
  for (RigidShape& shape : contact_surfaces.shapes) {
    shape = broadcast(std::move(shape), communicator);
  }
  parallel::broadcast(contact_surfaces.stiffness, communicator);
  return contact_surfaces;
}

void choose_stiffness(const scene::Solids& solids, std::span<const double> inverse_mass, double largest_frequency,
                      double share, ContactSurfaces& contact_surfaces) {
  contact_surfaces.stiffness.clear();
  for (const scene::Contact& contact : solids.contacts) {
    const double both = compliance(contact, inverse_mass, contact_surfaces);
    const double allowed = std::min(share, largest_share(solids, contact));
    const double chosen = both > 0 ? allowed * largest_frequency * largest_frequency / both : 0.0;
    contact_surfaces.stiffness.push_back(contact.stiffness.value_or(chosen));
  }
}

std::vector<double> squared_frequencies(const scene::Solids& solids, std::span<const double> inverse_mass,
                                        const ContactSurfaces& contact_surfaces) {
  std::vector<double> squares(solids.bodies.size());
  for (std::size_t c = 0; c < solids.contacts.size(); ++c) {
    const scene::Contact& contact = solids.contacts[c];
    const double square = contact_surfaces.stiffness[c] * compliance(contact, inverse_mass, contact_surfaces);
    squares[contact.body] = std::max(squares[contact.body], square);
    if (contact.other) {
      squares[*contact.other] = std::max(squares[*contact.other], square);
    }
  }
  return squares;
}

std::vector<BristleBounds> bristle_bounds(const scene::Solids& solids, std::span<const double> inverse_mass,
                                          const ContactSurfaces& contact_surfaces) {
  std::vector<BristleBounds> bounds(solids.bodies.size());
  for (const scene::Contact& contact : solids.contacts) {
    if (!contact.friction.memory) {
      continue;
    }
    const friction::Law& law = *contact.friction.memory;
    double mobility = largest_inverse_mass(contact_surfaces.skins[contact.body], inverse_mass);
    if (contact.other) {
      mobility += largest_inverse_mass(contact_surfaces.skins[*contact.other], inverse_mass);
    }
    const BristleBounds more{law.stiffness * mobility, (law.damping + law.viscosity) * mobility};
    add(more, bounds[contact.body]);
    if (contact.other && *contact.other != contact.body) {
      add(more, bounds[*contact.other]);
    }
  }
  return bounds;
}

}  // namespace idiophone::contact
