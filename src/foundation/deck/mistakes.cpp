#include "idiophone/foundation/deck/mistakes.hpp"

#include <algorithm>
#include <tuple>

namespace idiophone::deck {

bool Mistakes::add(const Node& node, const std::string& message) {
  add(node.where, node.path.empty() ? message : node.path + ": " + message);
  return false;
}

void Mistakes::raise() const {
  if (all_.empty()) {
    return;
  }
  std::vector<Mistake> sorted = all_;
  std::ranges::stable_sort(sorted, [](const Mistake& a, const Mistake& b) {
    return std::tie(a.where.file, a.where.line, a.where.column) < std::tie(b.where.file, b.where.line, b.where.column);
  });
  throw DeckError(sorted);
}

}  // namespace idiophone::deck
