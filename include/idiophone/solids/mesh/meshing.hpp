#pragma once
// What is asked of the program idiophone_gmsh, which runs gmsh on a geometry file, and what it answers. Both travel
// through pipes as bytes. A geometry file is foreign code: the reader of an answer checks every number in it.

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace idiophone::mesh {

// The program's descriptors and exit statuses. Standard input brings the request; standard output and error are
// gmsh's messages.
inline constexpr int answer_descriptor = 3;
inline constexpr int exit_answered = 0;
inline constexpr int exit_no_sandbox = 3;  ///< it can't be confined on this machine; the last message says why
inline constexpr int exit_forbidden = 4;   ///< the file tried what is forbidden; the last message says what
inline constexpr int exit_out_of_memory = 5;
inline constexpr int exit_exception = 6;  ///< one that nobody caught; the last message is its text

enum class FileFormat : std::int32_t { geo, msh, cad, stl, obj, model };  ///< model: glTF, PLY, FBX

struct MeshingRequest {
  std::string file;                          ///< absolute, without symbolic links
  FileFormat format = FileFormat::geo;       ///< of the file
  std::string object;                        ///< of an .obj or model file: its name; empty: the whole file
  std::map<std::string, double> parameters;  ///< of a .geo file; `size` (m), `scale` for the others
  std::int32_t hexahedra = 0;                ///< a .geo file finds it as the value of its variable of this name: 0 or 1
  std::int32_t dimension = 3;                ///< of the elements: 2 (quadrilaterals of surfaces) or 3
  std::int32_t lowest_order = 1;             ///< elements of a lower order are made elements of this one
  std::int32_t highest_order = 1;            ///< likewise of a higher one
  std::int32_t attempt = 0;                  ///< how often gmsh failed on the file before: it then tries otherwise
  std::int32_t wrap = 0;                     ///< 1: a closed surface takes the place of the file's triangles
  double gap = 0.0;                          ///< of that surface: the width of openings that it closes, m; 0: any
  std::uint64_t memory_limit = 0;            ///< of the program that answers, bytes
};

/// All elements of one of gmsh's types.
struct ElementBlock {
  std::string type_name;                    ///< as gmsh calls it, "Tetrahedron 10"
  std::int32_t type = 0;                    ///< gmsh's number of the type
  std::int32_t width = 0;                   ///< nodes of one element
  std::vector<std::uint64_t> element_tags;  ///< [elements]
  std::vector<std::uint64_t> node_tags;     ///< [width x elements] in gmsh's order
};

/// A physical group.
struct GroupBlock {
  std::string name;                      ///< empty where the file gives none
  std::int32_t tag = 0;                  ///< its number
  std::vector<std::uint64_t> node_tags;  ///< of all its elements
  std::vector<std::uint64_t> triangles;  ///< [3 x triangles] nodes of its linear triangles
  std::vector<std::uint64_t> elements;   ///< tags of those of its elements that the body is made of
};

/// Numbers for nodes or elements.
struct ViewBlock {
  std::string name;                 ///< as the file calls it
  std::int32_t of_elements = 0;     ///< of nodes (0) or elements (1)
  std::int32_t steps = 1;           ///< in time; the values are those of the first one
  std::vector<std::uint64_t> tags;  ///< of the nodes or elements that have values
  std::vector<double> values;       ///< [components x tags]
};

/// Why the file can't be meshed as asked.
struct Objection {
  std::string parameter;  ///< the one that it is about; empty for the file as a whole
  std::string message;
};

/// Objections, or a mesh.
struct MeshingAnswer {
  std::vector<Objection> objections;
  std::vector<std::uint64_t> node_tags;  ///< [nodes]
  std::vector<double> coordinates;       ///< [3 x nodes], m
  std::vector<ElementBlock> elements;
  std::vector<GroupBlock> groups;
  std::vector<ViewBlock> views;    ///< of a .msh file
  std::vector<std::string> notes;  ///< what was done to the file's shape, for the user
};

[[nodiscard]] std::string to_bytes(const MeshingRequest& request);
[[nodiscard]] std::string to_bytes(const MeshingAnswer& answer);

/// @throws std::runtime_error when the bytes are not exactly those of a request
[[nodiscard]] MeshingRequest request_from(const std::string& bytes);

/// @throws std::runtime_error when the bytes are not exactly those of an answer
[[nodiscard]] MeshingAnswer answer_from(const std::string& bytes);

}  // namespace idiophone::mesh
