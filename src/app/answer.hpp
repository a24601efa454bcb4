#pragma once
// How commands answer scripts.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace idiophone::app {

/// Prints facts to standard output. Names of files may have bytes that are not UTF-8; they become U+FFFD.
/// @param facts  nlohmann::json, or nlohmann::ordered_json where the order of keys helps people
template <class Json>
void print_answer(const Json& facts) {
  fmt::print("{}\n", facts.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace idiophone::app
