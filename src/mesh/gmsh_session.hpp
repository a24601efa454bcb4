#pragma once
// gmsh between initialise and finalise.

#include <string>

#include "idiophone/deck/location.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::mesh {

/// While it lives, gmsh is up: silent, without the user's own configuration, one thread,
/// HXT for volumes (gmsh's own default makes slivers in thin plates) and metres for CAD files.
/// Only one may live at a time.
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
  GmshSession(GmshSession&&) = delete;
  GmshSession& operator=(GmshSession&&) = delete;
};

/// gmsh's answer to a failed call.
/// @param body   whose mesh it is about
/// @param error  what gmsh threw
/// @returns the error, pointing at the body's mesh key, with gmsh's warnings and errors so far.
[[nodiscard]] deck::DeckError gmsh_failure(const scene::Body& body, const std::string& error);

/// Calls `work()` within a session.
/// @throws deck::DeckError, pointing at the body's mesh key, when gmsh fails in it.
template <class Work>
auto with_gmsh(const scene::Body& body, Work&& work) {
  const GmshSession session;
  try {
    return std::forward<Work>(work)();
  } catch (const std::string& error) {  // what gmsh throws
    throw gmsh_failure(body, error);
  }
}

}  // namespace idiophone::mesh
