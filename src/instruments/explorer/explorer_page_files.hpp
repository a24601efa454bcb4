#pragma once
// The files of src/explorer/page, which the build puts into the program.

#include <array>
#include <string_view>

#include "idiophone/foundation/web/web_page.hpp"

namespace idiophone::explorer {

extern const std::string_view page_template;            ///< index.html, with {{NAME}} where a file belongs
extern const std::array<web::PageFile, 42> page_files;  ///< the others

}  // namespace idiophone::explorer
