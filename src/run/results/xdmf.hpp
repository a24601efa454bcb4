#pragma once
// NAME.xdmf: describes the meshes and frames of NAME.h5 for ParaView and other readers of XDMF.

#include <filesystem>

namespace idiophone::results {

/// Describes the meshes and frames of a closed result in a file of its name with the ending .xdmf. An existing file is
/// replaced atomically. Paths in it are relative. Without frames it shows the reference meshes at time 0. The time of a
/// mode is its number, from 1 on. Call on one rank.
/// @return where it was written; empty if the result has no mesh (nothing is written then)
/// @throws std::runtime_error if the result can't be read or the description not written.
std::filesystem::path write_xdmf(const std::filesystem::path& result);

}  // namespace idiophone::results
