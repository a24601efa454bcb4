#pragma once
// Writing web pages.

#include <string>

namespace idiophone::web {

/// Writes a page and says how large it is. @throws std::runtime_error if it can't be written
void write_page(const std::string& path, const std::string& text);

}  // namespace idiophone::web
