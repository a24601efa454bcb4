#pragma once
// Files in OpenCL C, which the build puts into the program.

#include <string_view>

namespace idiophone::accelerated {

extern const std::string_view hexahedra_file;   ///< derivatives and forces of hexahedra
extern const std::string_view tetrahedra_file;  ///< of tetrahedra
extern const std::string_view entries_file;     ///< what elements and nodes are
extern const std::string_view elements_file;    ///< needs all of these
extern const std::string_view nodes_file;       ///< likewise

}  // namespace idiophone::accelerated
