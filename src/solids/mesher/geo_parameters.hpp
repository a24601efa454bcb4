#pragma once
// A request's parameters as the numbers that a .geo file defines with DefineConstant.

#include "idiophone/solids/mesh/meshing.hpp"
#include "script.hpp"

namespace idiophone::mesher {

/// Two scripts that include the .geo file. They are made before the process is confined, and run after.
class GeoScripts {
 public:
  explicit GeoScripts(const mesh::MeshingRequest& request);

  /// Runs the file without the parameters, and forgets what it made.
  /// @returns objections to parameters that it doesn't define
  /// @throws what gmsh throws
  [[nodiscard]] std::vector<mesh::Objection> undefined_parameters(const mesh::MeshingRequest& request) const;

  /// Runs the file with the parameters.
  /// @returns objections to those that it overwrites
  /// @throws what gmsh throws
  [[nodiscard]] std::vector<mesh::Objection> open_with_parameters(const mesh::MeshingRequest& request) const;

 private:
  Script probing_;
  Script setting_;
};

}  // namespace idiophone::mesher
