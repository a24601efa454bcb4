#include "idiophone/solid/solid.hpp"

namespace idiophone::solid {

namespace {

using Elements = std::variant<PackedElements<Tet4>, PackedElements<Tet10>>;

Elements packed(const mesh::BodyPart& part, std::span<const Vector3> reference) {
  if (part.element == scene::ElementType::tet4) {
    return PackedElements<Tet4>(part, reference);
  }
  return PackedElements<Tet10>(part, reference);
}

}  // namespace

Solid::Solid(const mesh::BodyPart& part, std::span<const Vector3> reference, const scene::Material& material)
    : elements_(packed(part, reference)), law_(material), density_(material.density) {}

void Solid::add_internal_force(const NodeState* state, NodeForce* force) const {
  std::visit([&](const auto& elements) { elements.add_internal_force(law_, state, force); }, elements_);
}

void Solid::add_mass(std::span<double> mass) const {
  std::visit([&](const auto& elements) { elements.add_mass(density_, mass); }, elements_);
}

void Solid::elastic_energy(const NodeState* state, std::span<double> energy) const {
  std::visit([&](const auto& elements) { elements.elastic_energy(law_, state, energy); }, elements_);
}

void Solid::add_linear_stiffness_force(const NodeState* state, NodeForce* force) const {
  ElasticLaw unit_damping = law_;
  unit_damping.beta = 1.0;
  std::visit([&](const auto& elements) { elements.add_internal_force(unit_damping, state, force); }, elements_);
}

Index Solid::element_count() const {
  return std::visit([](const auto& elements) { return elements.element_count(); }, elements_);
}

}  // namespace idiophone::solid
