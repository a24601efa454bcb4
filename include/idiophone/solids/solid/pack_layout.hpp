#pragma once
// Which elements of a body share a pack.

#include <cstddef>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/pack.hpp"

namespace idiophone::solid {

/// Packs that follow each other.
struct PackRange {
  std::size_t begin = 0;
  std::size_t end = 0;  ///< past the last
};

/// The packs that are in both ranges; an empty range where there are none.
[[nodiscard]] PackRange common(const PackRange& a, const PackRange& b);

/// Packs hold elements that follow each other, and that lie in one material region. So the last pack of a region may
/// have lanes without an element.
class PackLayout {
 public:
  explicit PackLayout(const mesh::BodyPart& part);

  [[nodiscard]] Index element_count() const { return first_.back(); }
  [[nodiscard]] std::size_t pack_count() const { return first_.size() - 1; }

  /// The first element of a pack, as a place in BodyPart::element_ids.
  [[nodiscard]] std::size_t first_element(std::size_t pack) const { return static_cast<std::size_t>(first_[pack]); }

  /// How many elements a pack has.
  [[nodiscard]] int filled_lanes(std::size_t pack) const { return first_[pack + 1] - first_[pack]; }

  /// The pack of an element.
  [[nodiscard]] std::size_t pack_of(std::size_t element) const;

  /// The packs of a region; none where it has no element here.
  [[nodiscard]] PackRange region(std::size_t number) const {
    return number < regions_.size() ? regions_[number] : PackRange{};
  }

  [[nodiscard]] std::size_t bytes() const { return first_.size() * sizeof(Index); }

 private:
  std::vector<Index> first_;        ///< [packs + 1] first element of each pack, and the number of elements
  std::vector<PackRange> regions_;  ///< [regions up to the last with elements here]
};

}  // namespace idiophone::solid
