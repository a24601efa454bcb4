#pragma once
// Files in OpenCL C, which the build puts into the program.

#include <array>
#include <string_view>

namespace idiophone::waves {

extern const std::array<std::string_view, 9> kernel_files;  ///< in the order in which they are compiled

}  // namespace idiophone::waves
