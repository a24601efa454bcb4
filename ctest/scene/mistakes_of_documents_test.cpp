// Decks that are not YAML, or can't be read.

#include "mistaken.hpp"

namespace idiophone::scene {

using MistakenDocuments = Mistaken;

TEST_F(MistakenDocuments, Documents) {
  EXPECT_EQ(mistakes(""), "deck.yaml:1:1: the deck is empty; docs/use/deck.md has an example");
  EXPECT_EQ(mistakes("# nothing\n"), "deck.yaml:1:1: the deck is empty; docs/use/deck.md has an example");
  EXPECT_EQ(mistakes("~"), "deck.yaml:1:1: the deck is empty; docs/use/deck.md has an example");
  EXPECT_EQ(mistakes("just text"), "deck.yaml:1:1: expected a map of keys, found 'just text'");
  EXPECT_EQ(mistakes(std::string(59, 'x') + "\u00e4 and the rest of a file"),
            "deck.yaml:1:1: expected a map of keys, found '" + std::string(59, 'x') + "...'");
  EXPECT_EQ(mistakes("- a\n- b\n"), "deck.yaml:1:1: expected a map of keys, found a list of 2");
  const std::string outside = "not YAML, or a second document; a deck is a single one and ends before";
  EXPECT_EQ(mistakes(plate + "---\nb: 2\n"), "deck.yaml:11:1: " + outside);
  EXPECT_EQ(mistakes(",a: b\n"), "deck.yaml:1:1: " + outside);
  EXPECT_EQ(mistakes("a: 1\n b: 2\n"), "deck.yaml:2:3: not YAML: illegal map value");
  EXPECT_EQ(mistakes("a: [1, 2\n"), "deck.yaml:2:1: not YAML: end of sequence flow not found");
  EXPECT_TRUE(mistakes("a: *b\n").starts_with("deck.yaml:1:4: not YAML: the referenced anchor is not defined"));
  EXPECT_EQ(mistakes("a: \"b\n"), "deck.yaml:2:1: not YAML: the text ends inside quotes; close them");
  EXPECT_EQ(mistakes(std::string("a: b\nc: \x04 d\n")),
            "deck.yaml:2:4: a control character (code 4); a deck is plain UTF-8 text");
}

TEST_F(MistakenDocuments, NestingEnds) {
  EXPECT_EQ(mistakes("a: &a {b: *a}\n"), "deck.yaml:1:4: an alias contains itself");
  std::string deep = "a: ";
  for (int level = 0; level < 21; ++level) {
    deep += "[";
  }
  EXPECT_THAT(mistakes(deep + std::string(21, ']')),
              testing::HasSubstr("lists and maps are nested more than 20 levels deep"));
  EXPECT_EQ(mistakes(std::string(100000, '[')), "deck.yaml:1:100001: not YAML: nested too deeply");
  std::string laughs = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 9; ++i) {
    laughs += fmt::format("a{0}: &a{0} [*a{1}, *a{1}, *a{1}, *a{1}, *a{1}]\n", i, i - 1);
  }
  EXPECT_THAT(mistakes(laughs), testing::HasSubstr("more than 200000 values, with those that aliases repeat"));
}

TEST_F(MistakenDocuments, CharactersThatTerminalsObey) {
  const std::string why = "; a deck is plain UTF-8 text";
  EXPECT_EQ(mistakes("a: \xc2\x9b"
                     "31m\n"),
            "deck.yaml:1:4: a control character (code 155)" + why);  // C1: a colour
  EXPECT_EQ(mistakes("a: b\n# \xe2\x80\xae\n"),
            "deck.yaml:2:3: a control character (code 8238)" + why);  // right to left
  EXPECT_EQ(mistakes("# caf\xe9\n"), "deck.yaml:1:6: a byte that is not UTF-8 (0xe9)" + why);
  EXPECT_THAT(mistakes("# caf\xc3\xa9\r\na: 1\n"), testing::Not(testing::HasSubstr("plain UTF-8")));
}

TEST_F(MistakenDocuments, AThousandBodiesAreAllowed) {
  std::string bodies;
  for (int i = 0; i < 1000; ++i) {
    bodies += fmt::format(
        "  b{}: {{mesh: plate.geo, parameters: {{size: 0.01, height: 2}}, element: tet10, material: steel, position: "
        "[0, 0, {}],"
        " velocity: [0, 1, 2]}}\n",
        i, i);
  }
  const std::string deck =
      replaced(replaced(plate, "bodies:\n", "bodies:\n" + bodies), "tap: {", "tap: {body: plate, ");
  EXPECT_EQ(read(deck).bodies.size(), 1001U);
}

TEST_F(MistakenDocuments, UnreadableDecks) {
  const auto answer = [](const std::filesystem::path& deck) {
    try {
      static_cast<void>(read_deck(deck));
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("no mistakes");
  };
  EXPECT_EQ(answer(folder / "no.yaml"), "can't read " + (folder / "no.yaml").string() + ": No such file or directory");
  EXPECT_EQ(answer(folder), "can't read " + folder.string() + ": it is a folder; name the .yaml file in it");
}

}  // namespace idiophone::scene
