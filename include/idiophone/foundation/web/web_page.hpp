#pragma once
// Web pages with everything in them: a template whose marks {{NAME}} are replaced by files and data.

#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "idiophone/foundation/web/base64.hpp"

namespace idiophone::web {

/// A file that the build puts into the program.
struct PageFile {
  std::string_view name;
  std::string_view text;
};

/// Plain values as text; the page decodes them.
template <class T>
[[nodiscard]] std::string encoded(const std::vector<T>& values) {
  return base64(std::as_bytes(std::span(values)));
}

/// JSON that may stand in an HTML element: a name can't end the element.
[[nodiscard]] inline std::string in_html(const nlohmann::json& data) {
  std::string text = data.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) {
    text.replace(at, 1, "\\u003c");
  }
  return text;
}

/// The page.
/// @param text   of the template, with one mark for each file and {{data}}
/// @throws std::logic_error if a mark is missing
[[nodiscard]] inline std::string filled_page(std::string text, std::span<const PageFile> files,
                                             const nlohmann::json& data) {
  const auto replace = [&](const std::string& name, std::string_view by) {
    const std::string mark = "{{" + name + "}}";
    const std::size_t place = text.find(mark);
    if (place == std::string::npos) {
      throw std::logic_error("the page has no " + mark);
    }
    text.replace(place, mark.size(), by);
  };
  for (const PageFile& file : files) {
    replace(std::string(file.name), file.text);
  }
  replace("data", in_html(data));
  return text;
}

}  // namespace idiophone::web
