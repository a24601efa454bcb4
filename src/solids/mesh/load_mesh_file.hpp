#pragma once
// A body whose mesh is a file of `idiophone mesh`.

#include <filesystem>
#include <functional>
#include <string>

#include "gmsh_mesh.hpp"

namespace idiophone::mesh {

/// Whether a file's name is that of a mesh file.
[[nodiscard]] bool is_mesh_file(const std::filesystem::path& file);

/// @throws deck::DeckError, pointing at the body's mesh key, if there is no such file
void require_file(const scene::Body& body);

/// The mesh as the file has it. Tags are the numbers in the file, from 0.
/// @param known  is asked first, and gets the mesh unless it is large
/// @throws deck::DeckError, pointing at the body's mesh key, if it can't be read or has elements of another type than
///         the body; pointing at its thickness or layers, which a mesh has already
[[nodiscard]] GmshMesh load_mesh_file(const scene::Body& body, Answers& known);

/// The same without elements: nodes, surface and groups, and the hash that the file promises.
/// @throws deck::DeckError as load_mesh_file()
[[nodiscard]] Mesh load_mesh_outline(const scene::Body& body);

/// @throws deck::DeckError, pointing at the body's mesh key: "the mesh of body 'bell' can't be read: ..."
[[noreturn]] void refuse_unreadable(const scene::Body& body, const std::string& why);

/// Calls `read()` within the limit for reading the body's file.
/// @throws deck::DeckError as refuse_unreadable(), naming the file, if it throws a std::runtime_error
void read_within_limit(const scene::Body& body, const std::function<void()>& read);

}  // namespace idiophone::mesh
