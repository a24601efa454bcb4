#pragma once
// The fingerprint by which a checkpoint knows its mesh.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// The hash of Fowler, Noll and Vo, draft-eastlake-fnv: offset basis and prime for 64 bits.
class Fnv1a {
 public:
  /// Takes in a list: its length, then its bytes, so that no two different sequences of lists look the same.
  template <class Item>
  void add(std::span<const Item> items) {
    add_length(items.size());
    add_bytes(std::as_bytes(items));
  }
  /// The length of a list whose bytes come next.
  void add_length(std::uint64_t length) { add_bytes(std::as_bytes(std::span(&length, 1))); }
  void add_bytes(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) {
      value_ = (value_ ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3ULL;
    }
  }
  /// 16 hexadecimal digits
  [[nodiscard]] std::string text() const;

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

/// What Mesh::hash holds: FNV-1a of 64 bits over the element type, the bits of the nodes, elements, surface and groups.
[[nodiscard]] std::string hash_of(const Mesh& mesh);

/// What of a mesh the hash takes in before its elements, and after them.
void add_nodes(const Mesh& mesh, Fnv1a& hash);
void add_surface_and_groups(const Mesh& mesh, Fnv1a& hash);

}  // namespace idiophone::mesh
