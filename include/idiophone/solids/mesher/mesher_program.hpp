#pragma once
// The program idiophone_gmsh: gmsh on one geometry file, without the means to do harm. Only idiophone starts it.

namespace idiophone::mesher {

/// Reads a mesh::MeshingRequest from standard input, confines the process, and writes a mesh::MeshingAnswer to
/// mesh::answer_descriptor.
/// @return the exit status; most ends of the process are elsewhere, with those of idiophone/mesh/meshing.hpp
[[nodiscard]] int run_program(int argument_count, char** arguments);

}  // namespace idiophone::mesher
