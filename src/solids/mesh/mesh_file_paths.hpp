#pragma once
// Where things are in a mesh file. docs/use/meshes.md describes them.

namespace idiophone::mesh::mesh_file {

inline constexpr const char* nodes = "/nodes";
inline constexpr const char* elements = "/elements";
inline constexpr const char* surface = "/surface";
// Lists with names.
inline constexpr const char* groups = "/groups";
inline constexpr const char* element_groups = "/element_groups";
inline constexpr const char* group_triangles = "/group_triangles";
// The parts of such lists.
inline constexpr const char* names = "/names";
inline constexpr const char* begins = "/begins";
inline constexpr const char* members = "/members";
// Attributes of the file.
inline constexpr const char* body = "body";
inline constexpr const char* element = "element";
inline constexpr const char* plane_order = "plane_order";
inline constexpr const char* thickness_order = "thickness_order";
inline constexpr const char* hash = "mesh_hash";

}  // namespace idiophone::mesh::mesh_file
