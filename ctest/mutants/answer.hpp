#pragma once
// What a reader may say of a wrong file.

#include <stdexcept>
#include <string>
#include <string_view>
#include <typeinfo>

#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::mutants {

/// Whether a text has a library's words.
inline bool has_library_words(std::string_view text) {
  return text.find("std::") != text.npos || text.find("vector::") != text.npos ||
         text.find("basic_string") != text.npos;
}

/// Whether the program would print an error as an answer: it is of a type of the project, without a library's words,
/// and says `named`.
inline bool is_answer(const std::exception& error, const std::string& named) {
  const bool own = typeid(error) == typeid(std::runtime_error) || typeid(error) == typeid(deck::DeckError);
  const std::string said = error.what();
  return own && said.find(named) != std::string::npos && !has_library_words(said);
}

}  // namespace idiophone::mutants
