#include "gmsh_session.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <string>
#include <vector>

namespace idiophone::mesh {

GmshSession::GmshSession() {
  gmsh::initialize(0, nullptr, false);
  gmsh::onelab::clear();  // finalise leaves the last session's constants there
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
  gmsh::option::setNumber("Mesh.Algorithm3D", 10);
  gmsh::option::setString("Geometry.OCCTargetUnit", "M");
  gmsh::logger::start();
}

GmshSession::~GmshSession() {
  gmsh::logger::stop();
  gmsh::finalize();
}

deck::DeckError gmsh_failure(const scene::Body& body, const std::string& error) {
  std::string message = fmt::format("gmsh can't make the mesh of body '{}' from {}: {}", body.name, body.mesh.string(),
                                    error.empty() ? "no reason given" : error);
  std::vector<std::string> log;
  gmsh::logger::get(log);
  for (const auto& line : log) {
    if (line.starts_with("Warning") || (line.starts_with("Error") && !line.ends_with(error))) {
      message += "\n  gmsh: " + line;
    }
  }
  return {body.mesh_where, message};
}

}  // namespace idiophone::mesh
