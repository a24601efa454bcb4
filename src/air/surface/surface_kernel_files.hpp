#pragma once
// Files in OpenCL C, which the build puts into the program.

#include <string_view>

namespace idiophone::surface {

extern const std::string_view surface_file;

}  // namespace idiophone::surface
