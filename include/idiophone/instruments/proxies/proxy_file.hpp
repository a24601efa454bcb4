#pragma once
// NAME.proxy: the lattices of a body in a flat file, for programs that read no deck (docs/use/engines.md).

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::proxies {

/// A body, as a file has it.
struct StoredBody {
  std::string name;
  std::vector<std::shared_ptr<const Lattice>> levels;  ///< as BodyOptions::levels
};

/// The bytes of the file: what each lattice was made of, so that reading makes the same again, to the bit.
[[nodiscard]] std::string proxy_file(const StoredBody& body);

/// @param bytes  of the whole file
/// @param name   of the file, for messages
/// @throws std::runtime_error when it is no proxy file, of another version, damaged, or no lattice can be made of it
[[nodiscard]] StoredBody read_proxy(std::span<const char> bytes, const std::string& name);

/// @throws std::runtime_error also when the file can't be opened
[[nodiscard]] StoredBody read_proxy(const std::filesystem::path& path);

}  // namespace idiophone::proxies
