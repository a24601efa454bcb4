#pragma once
// A body of a deck as a proxy file.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/instruments/proxy_bodies/proxy_bodies.hpp"

namespace idiophone::app {

struct ProxyExport {
  std::filesystem::path file;          ///< to write, if any
  std::string body;                    ///< of the deck; empty for the first
  int levels = 1;                      ///< meshes, each with elements twice as large as the one before
  std::vector<std::string> overrides;  ///< of the deck
  proxy_bodies::Springs springs = proxy_bodies::Springs::van_gelder;
};

/// --proxy, and the options that need it.
void declare(CLI::App& app, ProxyExport& options);

/// The bytes of the file. @throws deck::DeckError for a wrong deck, or a body that proxies can't be made of
[[nodiscard]] std::string proxy_of_deck(const std::filesystem::path& deck, const ProxyExport& options);

}  // namespace idiophone::app
