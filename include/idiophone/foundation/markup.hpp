#pragma once
// Text inside XML and HTML.

#include <string>

namespace idiophone {

/// The text with references for the five characters that mean something in XML and HTML, also within quotes.
[[nodiscard]] inline std::string in_markup(const std::string& text) {
  std::string safe;
  for (const char character : text) {
    switch (character) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += character;
    }
  }
  return safe;
}

}  // namespace idiophone
