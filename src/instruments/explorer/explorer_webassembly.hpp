#pragma once
// The module page_sound in WebAssembly, which the build puts into the program.

#include <string_view>

namespace idiophone::explorer {

extern const std::string_view webassembly;  ///< bytes; none if the program was built without

}  // namespace idiophone::explorer
