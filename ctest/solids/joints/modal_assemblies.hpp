#pragma once
// Modal bodies that joints tie together.

#include <optional>

#include "assembly.hpp"
#include "block_mesh.hpp"
#include "idiophone/solids/eigenmodes/compute_modal_basis.hpp"

namespace idiophone::eigenmodes {

/// A bar of 200 x 20 x 10 mm, cut at 80 mm and joined; meshes that do not match.
inline Assembly cut_bar(std::optional<scene::JointStiffness> stiffness, double damping = 0.0) {
  Assembly bar;
  bar.add(support::block_mesh(element::hex(4, 2), {0.08, 0.02, 0.01}, {2, 1, 1}), Vector3::Zero());
  bar.add(support::block_mesh(element::hex(4, 2), {0.12, 0.02, 0.01}, {3, 2, 1}), {0.08, 0, 0});
  bar.join("x1", "x0", stiffness, damping);
  return bar;
}

/// Two strips of steel end to end, held at their outer ends; the second one is 100 K colder and pulls at the first one.
inline Assembly taut_strips(std::optional<scene::JointStiffness> stiffness) {
  Assembly strips;
  strips.scene.materials[0].expansion = 1.2e-5;
  strips.add(support::block_mesh(element::hex(4, 2), {0.12, 0.01, 0.001}, {4, 1, 1}), Vector3::Zero());
  strips.add(support::block_mesh(element::hex(4, 2), {0.16, 0.01, 0.001}, {5, 2, 1}), {0.12, 0, 0});
  strips.join("x1", "x0", stiffness);
  strips.scene.bodies[0].fixed.push_back({.group = "x0", .axes = {true, true, true}, .hinge = false, .where = {}});
  strips.scene.bodies[1].fixed.push_back({.group = "x1", .axes = {true, true, true}, .hinge = false, .where = {}});
  strips.scene.bodies[1].prestress.emplace().temperature = -100;
  return strips;
}

inline scene::ModalModel lowest(int count) {
  return {.up_to = {}, .count = count, .where = {"deck.yaml", 3, 5}};
}

inline void make_modal(Assembly& assembly, std::size_t body, int count) {
  assembly.scene.bodies[body].modal = lowest(count);
}

/// @param joined  whether the bodies get the further modes of joined bodies
inline modal_bodies::ModalBases bases_of(const Assembly& assembly, bool joined = true) {
  const auto motions = joined_motions(assembly.scene, assembly.meshes);
  modal_bodies::ModalBases bases;
  for (const auto& [body, motion] : motions) {
    bases[body] = modal_basis(assembly.scene, body, assembly.meshes[body], {}, joined ? &motion : nullptr);
  }
  return bases;
}

}  // namespace idiophone::eigenmodes
