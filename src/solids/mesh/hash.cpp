#include "hash.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

namespace idiophone::mesh {

namespace {

/// The hash of Fowler, Noll and Vo, draft-eastlake-fnv: offset basis and prime for 64 bits.
class Fnv1a {
 public:
  /// Takes in a list: its length, then its bytes, so that no two different sequences of lists look the same.
  template <class Item>
  void add(std::span<const Item> items) {
    const auto length = static_cast<std::uint64_t>(items.size());
    add_bytes(std::as_bytes(std::span(&length, 1)));
    add_bytes(std::as_bytes(items));
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  void add_bytes(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) {
      value_ = (value_ ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3ULL;
    }
  }
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace

std::string hash_of(const Mesh& mesh) {
  Fnv1a hash;
  const int width = element::node_count(mesh.element);
  hash.add(std::span(&width, 1));
  hash.add(std::span(mesh.nodes));
  hash.add(std::span(mesh.elements));
  hash.add(std::span(mesh.surface));
  for (const auto& [name, nodes] : mesh.groups) {
    hash.add(std::span(name));
    hash.add(std::span(nodes));
  }
  if (!mesh.regions.empty()) {
    hash.add(std::span(mesh.regions));
  }
  return fmt::format("{:016x}", hash.value());
}

}  // namespace idiophone::mesh
