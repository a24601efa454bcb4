#include "idiophone/contact/partners.hpp"

#include <algorithm>

#include "idiophone/mesh/part.hpp"
#include "idiophone/parallel/broadcast.hpp"

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
double compliance(const scene::Contact& contact, std::span<const double> inverse_mass, const Partners& partners) {
  return largest_compliance(partners.skins[contact.body], inverse_mass) +
         (contact.other ? largest_compliance(partners.skins[*contact.other], inverse_mass) : 0.0);
}

}  // namespace

Partners find_partners(const scene::Scene& scene, const std::vector<mesh::Mesh>& meshes) {
  Partners partners;
  const std::vector<Index> first_nodes = mesh::offsets(meshes).nodes;
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    const bool touches = std::ranges::any_of(
        scene.contacts, [&](const scene::Contact& contact) { return contact.body == b || contact.other == b; });
    partners.skins.push_back(touches ? make_skin(meshes[b], first_nodes[b]) : Skin{});
  }
  std::ranges::transform(scene.obstacles, std::back_inserter(partners.shapes), make_shape);
  return partners;
}

Partners broadcast(Partners partners, MPI_Comm communicator) {
  partners.skins.resize(parallel::from_root(partners.skins.size(), communicator));
  partners.shapes.resize(parallel::from_root(partners.shapes.size(), communicator));
  for (Skin& skin : partners.skins) {
    skin = broadcast(std::move(skin), communicator);
  }
  for (RigidShape& shape : partners.shapes) {
    shape = broadcast(std::move(shape), communicator);
  }
  parallel::broadcast(partners.stiffness, communicator);
  return partners;
}

void choose_stiffness(const scene::Scene& scene, std::span<const double> inverse_mass, double largest_frequency,
                      double share, Partners& partners) {
  partners.stiffness.clear();
  for (const scene::Contact& contact : scene.contacts) {
    const double both = compliance(contact, inverse_mass, partners);
    const double chosen = both > 0 ? share * largest_frequency * largest_frequency / both : 0.0;
    partners.stiffness.push_back(contact.stiffness.value_or(chosen));
  }
}

std::vector<double> squared_frequencies(const scene::Scene& scene, std::span<const double> inverse_mass,
                                        const Partners& partners) {
  std::vector<double> squares(scene.bodies.size());
  for (std::size_t c = 0; c < scene.contacts.size(); ++c) {
    const scene::Contact& contact = scene.contacts[c];
    const double square = partners.stiffness[c] * compliance(contact, inverse_mass, partners);
    squares[contact.body] = std::max(squares[contact.body], square);
    if (contact.other) {
      squares[*contact.other] = std::max(squares[*contact.other], square);
    }
  }
  return squares;
}

}  // namespace idiophone::contact
