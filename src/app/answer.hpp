#pragma once
// How commands answer scripts.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace idiophone::app {

/// Prints facts to standard output. Names of files may have bytes that are not UTF-8; they become U+FFFD.
inline void print_answer(const nlohmann::json& facts) {
  fmt::print("{}\n", facts.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace idiophone::app
