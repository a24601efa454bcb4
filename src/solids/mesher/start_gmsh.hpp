#pragma once
// gmsh in its initial state.

namespace idiophone::mesher {

/// Initialises gmsh: without the user's own configuration, on one thread, with metres for CAD files. Its messages go to
/// standard output and error. It is never finalised, which would try to remove files; the process just ends.
void start_gmsh();

/// Forgets models, constants and variables. Options that a file set stay.
void clear_gmsh();

}  // namespace idiophone::mesher
