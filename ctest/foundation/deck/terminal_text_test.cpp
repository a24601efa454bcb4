#include "idiophone/foundation/terminal_text.hpp"

#include <gtest/gtest.h>

namespace idiophone {

TEST(TerminalText, LeavesPlainTextAsItIs) {
  for (const std::string text : {"", "a b\tc\n", "M\xc3\xbcnchen", "\xe2\x99\xaf", "\xf0\x9f\x8e\xb5"}) {
    EXPECT_EQ(for_terminal(text), text);
  }
}

TEST(TerminalText, ShowsWhatATerminalWouldObey) {
  EXPECT_EQ(for_terminal("\x1b[31m"), "\\x1b[31m");
  EXPECT_EQ(for_terminal("a\rb\x7f"), "a\\x0db\\x7f");
  EXPECT_EQ(for_terminal("\xc2\x9b"), "\\x9b");  // C1
  EXPECT_EQ(for_terminal("\xe2\x80\xae"
                         "abc"),
            "\\u202eabc");  // from right to left
  EXPECT_EQ(for_terminal("\xe2\x81\xa9"), "\\u2069");
}

TEST(TerminalText, ShowsBytesThatAreNotUtf8) {
  EXPECT_EQ(for_terminal("caf\xe9"), "caf\\xe9");
  EXPECT_EQ(for_terminal("\xc0\x80"), "\\xc0\\x80");           // too long
  EXPECT_EQ(for_terminal("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half of a pair
  EXPECT_EQ(for_terminal("\xe2\x80"), "\\xe2\\x80");           // cut off
  EXPECT_EQ(for_terminal("\xff"), "\\xff");
}

}  // namespace idiophone
