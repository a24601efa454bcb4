#pragma once

namespace idiophone {

extern const char* const program_version;  ///< e.g. "0.2.0"; CMakeLists.txt says it

}  // namespace idiophone
