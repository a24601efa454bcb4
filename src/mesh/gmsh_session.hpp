#pragma once
// gmsh between initialise and finalise.

#include <future>
#include <string>

#include "idiophone/scene/scene.hpp"

namespace idiophone::mesh {

/// While it lives, gmsh is up: silent, without the user's own configuration, one thread (so the same file always gives
/// the same mesh), HXT for volumes (gmsh's own default makes slivers in thin plates) and metres for CAD files.
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
[[nodiscard]] scene::DeckError gmsh_failure(const scene::Body& body, const std::string& error);

/// Calls `work()` within a session, in a thread of its own: HXT's choices follow the order of nodes in memory, and a
/// thread gets a heap of its own, whose order doesn't depend on what the program did before (MPI, other ranks).
/// @throws scene::DeckError, pointing at the body's mesh key, when gmsh fails in it.
template <class Work>
auto with_gmsh(const scene::Body& body, const Work& work) {
  const auto session = [&] {
    const GmshSession gmsh;
    try {
      return work();
    } catch (const std::string& error) {  // what gmsh throws
      throw gmsh_failure(body, error);
    }
  };
  return std::async(std::launch::async, session).get();
}

}  // namespace idiophone::mesh
