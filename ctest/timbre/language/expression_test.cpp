#include "idiophone/timbre/language/expression.hpp"

#include <gtest/gtest.h>

#include "ranks.hpp"
#include "sounding.hpp"

namespace idiophone::timbre {

namespace {

std::string place_of(const Expression& expression) {
  return std::to_string(expression.where.line) + ":" + std::to_string(expression.where.column);
}

}  // namespace

ON_RANKS(1);

TEST(Expressions, AreNumbersWordsTextsOrLists) {
  const auto forms = read_expressions("-1.5e2 +7 1a - \"1\" ()", "t.tt");
  ASSERT_EQ(forms.size(), 6U);
  EXPECT_EQ(forms[0].kind, Expression::Kind::number);
  EXPECT_EQ(forms[0].number, -150.0);
  EXPECT_EQ(forms[1].number, 7.0);
  EXPECT_EQ(forms[2].kind, Expression::Kind::word);
  EXPECT_EQ(forms[3].kind, Expression::Kind::word);
  EXPECT_EQ(forms[4].kind, Expression::Kind::text);
  EXPECT_EQ(forms[5].kind, Expression::Kind::list);
  EXPECT_TRUE(forms[5].items.empty());
}

TEST(Expressions, EndAtBlanksParenthesesQuotesAndComments) {
  const auto forms = read_expressions("a(b)c\"d\"e;f (\r\n\tg", "t.tt");
  ASSERT_EQ(forms.size(), 6U);
  EXPECT_EQ(forms[0].text, "a");
  EXPECT_EQ(to_text(forms[1]), "(b)");
  EXPECT_EQ(forms[2].text, "c");
  EXPECT_EQ(forms[3].text, "d");
  EXPECT_EQ(forms[4].text, "e");
  EXPECT_EQ(forms[5].text, "g");
  EXPECT_EQ(place_of(forms[4]), "1:9");
  EXPECT_EQ(place_of(forms[5]), "2:2");
}

TEST(Expressions, KeepParenthesesAndSemicolonsInQuotes) {
  const auto forms = read_expressions("(sample \"a (b); c\")", "t.tt");
  ASSERT_EQ(forms.size(), 1U);
  EXPECT_EQ(forms[0].items[1].text, "a (b); c");
}

TEST(Expressions, AreDescribedAsWhatWasFound) {
  const auto forms = read_expressions("3 sine \"a\" (sine 3)", "t.tt");
  EXPECT_EQ(describe(forms[0]), "'3'");
  EXPECT_EQ(describe(forms[1]), "'sine'");
  EXPECT_EQ(describe(forms[2]), "\"a\"");
  EXPECT_EQ(describe(forms[3]), "a list");
}

TEST(Expressions, HaveNumbersThatAreWrittenAsTheyAreRead) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, -123456789.123456789}) {
    const auto forms = read_expressions(to_text({.kind = Expression::Kind::number, .number = value}), "t.tt");
    EXPECT_EQ(forms.at(0).number, value);
  }
}

TEST(Expressions, NameTheInnermostListThatIsNotClosed) {
  EXPECT_EQ(mistakes_of("(+ 1\n  (* 2 3)\n  (- 4"), "t.tt:3:3: this ( is not closed");
}

}  // namespace idiophone::timbre
