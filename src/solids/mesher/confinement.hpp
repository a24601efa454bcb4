#pragma once
// What a geometry file, which is a program to gmsh, can't do. A program that was built without libseccomp has Landlock
// alone: files can't be written nor programs started, but threads and the network can be used.

#include <cstdint>
#include <filesystem>

namespace idiophone::mesher {

// Each of these ends the process with mesh::exit_no_sandbox where it can't be done.

/// Ends this process with the one that started it, and limits its memory, in bytes. It writes no file and no core.
void limit_resources(std::uint64_t memory);

/// From here on, this process can't open files for writing, nor make or remove any: it gets an error (seccomp). It
/// reads files in `folder` and beneath only, where the kernel has Landlock (from 5.13 on, if enabled). Needs one of
/// both.
void confine_files(const std::filesystem::path& folder);

/// From here on, an attempt to start a program or thread, to use the network, or to write, make or remove files ends
/// this process with mesh::exit_forbidden and a last message that says what it was (seccomp). Does nothing without.
void confine_calls();

}  // namespace idiophone::mesher
