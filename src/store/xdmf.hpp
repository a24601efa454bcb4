#pragma once
// NAME.xdmf beside NAME.h5: tells ParaView and other readers of XDMF how the moving meshes lie in the result.

#include <filesystem>

namespace idiophone::store {

/// Writes the description of a closed result's meshes and frames beside it, under its name with the ending .xdmf; a
/// file that is there is replaced at once or not at all. Paths in it are relative. Without frames the reference meshes
/// stand at time 0; modes stand at their numbers, from 1 on. Call on one rank.
/// @return where it was written; empty if the result has no mesh (nothing is written then)
/// @throws std::runtime_error if the result can't be read or the description not written.
std::filesystem::path write_xdmf(const std::filesystem::path& result);

}  // namespace idiophone::store
