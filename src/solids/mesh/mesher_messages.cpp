#include "mesher_messages.hpp"

#include <algorithm>

namespace idiophone::mesh {

namespace {

constexpr std::size_t most_complaints = 10;
constexpr std::size_t longest_line = 1000;
constexpr std::string_view error_heading = "Error   : ";

}  // namespace

void MesherMessages::add(std::string_view part) {
  for (const char letter : part) {
    if (letter == '\n' || letter == '\r') {
      end_line();
    } else if (line_.size() < longest_line) {
      const auto code = static_cast<unsigned char>(letter);
      line_ += code < ' ' || code == 0x7F ? ' ' : letter;
    }
  }
}

void MesherMessages::end_line() {
  const auto first = line_.find_first_not_of(' ');
  if (first != std::string::npos) {
    last_ = line_.substr(first);
    const bool complaint = last_.starts_with("Warning") || last_.starts_with("Error");
    if (complaint && complaints_.size() < most_complaints &&
        std::ranges::find(complaints_, last_) == complaints_.end()) {
      complaints_.push_back(last_);
    }
  }
  line_.clear();
}

std::string MesherMessages::last() const {
  return line_.find_first_not_of(' ') == std::string::npos ? last_ : line_;
}

std::string MesherMessages::last_error() const {
  const auto found = std::find_if(complaints_.rbegin(), complaints_.rend(),
                                  [](const std::string& line) { return line.starts_with("Error"); });
  return found == complaints_.rend() ? "" : found->substr(std::min(found->size(), error_heading.size()));
}

std::string MesherMessages::complaints() const {
  std::string text;
  for (const auto& line : complaints_) {
    if (!line.ends_with(last())) {
      text += "\n  gmsh: " + line;
    }
  }
  return text;
}

}  // namespace idiophone::mesh
