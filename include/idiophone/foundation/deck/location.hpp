#pragma once
// Where in a deck something was said, and the error that points there.

#include <stdexcept>
#include <string>
#include <vector>

namespace idiophone::deck {

/// A place in a deck or in a --set argument. Lines and columns count from 1.
struct Location {
  std::string file;
  int line = 0;
  int column = 0;
};

/// "file:line:column"
[[nodiscard]] std::string to_string(const Location& where);

/// One mistake: where, what is wrong, and what would be right.
struct Mistake {
  Location where;
  std::string message;
};

/// A deck that can't be run. what() has a line "file:line:column: message" for each mistake.
class DeckError : public std::runtime_error {
 public:
  explicit DeckError(const std::vector<Mistake>& mistakes);
  DeckError(const Location& where, const std::string& message) : DeckError(std::vector<Mistake>{{where, message}}) {}
};

}  // namespace idiophone::deck
