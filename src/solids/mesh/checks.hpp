#pragma once
// What makes a mesh unfit to be computed, said in the file's own numbers.

#include "gmsh_mesh.hpp"

namespace idiophone::mesh {

/// Takes out the nodes that no element uses.
/// @throws deck::DeckError, pointing at the body's mesh key, when such a node is in a group.
void drop_unused_nodes(const scene::Body& body, GmshMesh& loaded);

/// "element 5 at (0, 0.1, 0)"
/// @param centre  m
[[nodiscard]] std::string element_text(std::size_t tag, const Vector3& centre);
/// The same of an element of a mesh.
[[nodiscard]] std::string element_text(const GmshMesh& loaded, Index element);

/// @param why  what comes after "the mesh of body ..., ..., ", up to the list
/// @throws deck::DeckError, pointing at the body's mesh key, with the first of the culprits, each on its line.
[[noreturn]] void refuse_culprits(const scene::Body& body, const std::string& why,
                                  const std::vector<std::string>& culprits);

/// @throws deck::DeckError, pointing at the body's mesh key: "the mesh of body ... has ...:" and the elements.
[[noreturn]] void refuse_elements(const scene::Body& body, const GmshMesh& loaded, const std::vector<Index>& elements,
                                  const std::string& why);

/// "the mesh of body 'bell', bell.msh, has ..."
/// @param problem  what comes after the name of the file
[[nodiscard]] std::string text_of_problem(const scene::Body& body, const std::string& problem);

/// The part of check() that needs no elements.
/// @throws deck::DeckError, pointing at the body's mesh key, when a node is too far from the origin or the mesh is too
///         small to be in metres, or two nodes are in one place
void check_nodes(const scene::Body& body, const GmshMesh& loaded);

/// That a mesh falls into parts, for text_of_problem().
[[nodiscard]] std::string falling_apart(std::size_t parts);

/// What makes elements unfit, of a mesh or of a part of one: they are inverted or flat, or more than two share a face.
/// @return for text_of_problem(); empty for nothing
[[nodiscard]] std::string problem_of_elements(const GmshMesh& loaded);

/// @throws deck::DeckError, pointing at the body's mesh key, when a node is too far from the origin or the mesh is too
///         small to be in metres, two nodes are in one place, elements are inverted or flat, more than two elements
///         share a face, or the mesh falls into parts that share no node.
void check(const scene::Body& body, const GmshMesh& loaded);

}  // namespace idiophone::mesh
