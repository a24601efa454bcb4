#pragma once
// gmsh in the test program, to make files with.

#include <gmsh.h>

namespace idiophone::mesh {

/// While it lives, gmsh is up and silent. Only one may live at a time.
class GmshSession {
 public:
  GmshSession() {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
  }
  ~GmshSession() { gmsh::finalize(); }
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
  GmshSession(GmshSession&&) = delete;
  GmshSession& operator=(GmshSession&&) = delete;
};

}  // namespace idiophone::mesh
