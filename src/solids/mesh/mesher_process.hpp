#pragma once
// gmsh in a process of its own.

#include <stdexcept>

#include "idiophone/solids/mesh/meshing.hpp"

namespace idiophone::mesh {

/// Why there is no answer; what() has a line for each of gmsh's warnings and errors, too.
class MesherFailure : public std::runtime_error {
 public:
  enum class Kind { gmsh, limit };
  MesherFailure(const std::string& message, Kind kind)
      : std::runtime_error(message), may_succeed_otherwise(kind == Kind::gmsh) {}

  bool may_succeed_otherwise;  ///< gmsh itself failed, and neither limits nor the confinement stopped it
};

/// Starts idiophone_gmsh, which is in the program's folder or the one above it, in the folder ../libexec/idiophone,
/// or where the environment variable IDIOPHONE_GMSH says, and waits for its answer. Seen from the extension of Python,
/// it is two folders above, or in the folder libexec/idiophone beside the lib/python3/dist-packages/idiophone that it
/// is in.
/// @param time_limit  s; the process is ended after that
/// @throws MesherFailure when it takes longer, dies, is confined where it must not go, or answers nonsense;
///         std::runtime_error when it can't be started
[[nodiscard]] MeshingAnswer run_mesher(const MeshingRequest& request, double time_limit);

}  // namespace idiophone::mesh
