#pragma once
// Decks with a mistake, and exactly how each is answered.

#include "deck_fixture.hpp"

namespace idiophone::scene {

/// The small deck with one text replaced by another, and the answer.
struct Wrong {
  std::string old;
  std::string by;
  std::string answer;
};

class Mistaken : public DeckTest {
 protected:
  void expect(const std::vector<Wrong>& decks) const {
    for (const Wrong& wrong : decks) {
      SCOPED_TRACE(wrong.old + " -> " + wrong.by);
      ASSERT_NE(plate.find(wrong.old), std::string::npos);
      EXPECT_EQ(mistakes(replaced(plate, wrong.old, wrong.by)), wrong.answer);
    }
  }

  /// The same for text added at the end.
  void expect_after(const std::vector<std::pair<std::string, std::string>>& ends) const {
    for (const auto& [end, answer] : ends) {
      SCOPED_TRACE(end);
      EXPECT_EQ(mistakes(plate + end), answer);
    }
  }
};

}  // namespace idiophone::scene
