#include "idiophone/timbre/language/timbre_tree.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ranks.hpp"
#include "sounding.hpp"

namespace idiophone::timbre {

ON_RANKS(1);

TEST(Expressions, HavePlaces) {
  const auto forms = read_expressions("; a comment\n(sine 440\n  \"a b\") 2.5", "t.tt");
  ASSERT_EQ(forms.size(), 2U);
  const Expression& text = forms[0].items[2];
  EXPECT_EQ(text.kind, Expression::Kind::text);
  EXPECT_EQ(text.text, "a b");
  EXPECT_EQ(deck::to_string(text.where), "t.tt:3:3");
  EXPECT_EQ(forms[1].number, 2.5);
  EXPECT_EQ(to_text(forms[0]), "(sine 440 \"a b\")");
}

TEST(Expressions, HaveFiniteNumbers) {
  for (const std::string number : {"nan", "-inf", "1e999", "+1e-999", "infinity"}) {
    EXPECT_EQ(mistakes_of("(sine " + number + ")"),
              "t.tt:1:7: '" + number + "' is not a finite number of double precision");
  }
}

TEST(Expressions, NeedBothParenthesesAndQuotes) {
  EXPECT_EQ(mistakes_of("(sine\n (+ 1 2)"), "t.tt:1:1: this ( is not closed");
  EXPECT_EQ(mistakes_of("1)"), "t.tt:1:2: this ) closes nothing");
  EXPECT_EQ(mistakes_of("\n(sample \"a)"), "t.tt:2:9: this \" has no partner in its line");
  EXPECT_EQ(mistakes_of("; nothing"), "t.tt:1:1: there is no sound, only parameters and definitions");
  EXPECT_EQ(mistakes_of(""), "t.tt:1:1: there is no sound, only parameters and definitions");
}

TEST(Expressions, TreesOfTenThousandNodesDepthAreAnError) {
  std::string nested, chain = "(define a0 time)";
  for (int i = 1; i <= 10000; ++i) {
    nested += "(- ";
    chain += fmt::format("(define a{} (- a{}))", i, i - 1);
  }
  nested += '1';
  nested.append(10000, ')');
  EXPECT_EQ(mistakes_of(nested), "t.tt:1:3001: lists are more than 1000 deep; name parts by (define NAME ...)");
  EXPECT_THAT(mistakes_of(chain + "a10000"), testing::EndsWith("the tree is more than 1000 nodes deep"));
  std::string wide = "(+";
  for (int i = 0; i < 10000; ++i) {
    wide += " (* time " + std::to_string(i) + ")";
  }
  EXPECT_EQ(mistakes_of(wide + ")"), "");
}

TEST(Trees, NamesAreGivenOnce) {
  EXPECT_EQ(mistakes_of("(parameter a 1)(define a 2) a"), "t.tt:1:24: the name 'a' is there already");
  EXPECT_EQ(mistakes_of("(define white 2) 1"), "t.tt:1:9: 'white' has a meaning already; choose another name");
  EXPECT_EQ(mistakes_of("1 2"),
            "t.tt:1:3: there is a sound already; a tree has one, after its parameters and definitions");
  EXPECT_EQ(mistakes_of("(parameter a b) 1"), "t.tt:1:1: write (parameter NAME) or (parameter NAME NUMBER)");
}

TEST(Trees, AreWrittenAsTheyAreRead) {
  const std::string text = "(parameter amp 1)\n(parameter f)\n(define a (sine f 0.25))\n(* amp a)\n";
  EXPECT_EQ(to_text(parse_tree(text, "t.tt")), text);
}

}  // namespace idiophone::timbre
