#pragma once
// Collects the mistakes of a deck, so that all are answered at once.

#include <string>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/deck/node.hpp"

namespace idiophone::deck {

class Mistakes {
 public:
  void add(const Location& where, const std::string& message) { all_.push_back({where, message}); }

  /// A mistake in a value: "place: path: message". Returns false, the answer of a reader that failed.
  bool add(const Node& node, const std::string& message);

  [[nodiscard]] std::size_t count() const { return all_.size(); }

  /// @throws DeckError if there are any: those of --set and of the deck, each in the order of its lines.
  void raise() const;

 private:
  std::vector<Mistake> all_;
};

}  // namespace idiophone::deck
