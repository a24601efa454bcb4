#pragma once
// The whole program: its command line, and a job that every rank ends alike.

namespace idiophone::app {

/// Runs the command that the command line names, between starting and ending MPI and PETSc. Every rank calls it.
/// @return the exit status (docs/use/running.md)
[[nodiscard]] int run_program(int argument_count, char** arguments);

}  // namespace idiophone::app
