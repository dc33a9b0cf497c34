#include "frame/printable.h"

#include <gtest/gtest.h>

#include <string>

namespace zproof {
namespace {

using namespace std::string_literals;

TEST(Printable, BytesThatAreNoTextAreEscaped) {
    EXPECT_EQ(printable("\xFFz"), R"(\xffz)");                        // never in UTF-8
    EXPECT_EQ(printable("\xC3"), R"(\xc3)");                          // cut short
    EXPECT_EQ(printable("\xED\xA0\x80"), R"(\xed\xa0\x80)");          // a surrogate
    EXPECT_EQ(printable("\xC0\xAF"), R"(\xc0\xaf)");                  // overlong slash
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), R"(\xf4\x90\x80\x80)");  // beyond U+10FFFF
}

TEST(Printable, WhatIsNotSeenIsEscaped) {
    EXPECT_EQ(printable("a\x1b[31mb"), R"(a\x1b[31mb)");
    EXPECT_EQ(printable("a\0b\x7F"s), R"(a\x00b\x7f)");
    EXPECT_EQ(printable("\xC2\x9B"), R"(\u009b)");  // C1: another escape
    EXPECT_EQ(printable("a\u202Eb\u2066\u2069"), R"(a\u202eb\u2066\u2069)");
    EXPECT_EQ(printable("\u200E\u200F\u061C"), R"(\u200e\u200f\u061c)");
    EXPECT_EQ(printable("\u200B\u200D\u2060\uFEFF\u00AD"), R"(\u200b\u200d\u2060\ufeff\u00ad)");
    EXPECT_EQ(printable("\u2028\u2029"), R"(\u2028\u2029)");
    EXPECT_EQ(printable("\U000E0041"), R"(\U000e0041)");
    EXPECT_EQ(printable("\uFFFE"), R"(\ufffe)");  // XML has none
}

TEST(Printable, TextStaysAsItIs) {
    const std::string text = "Grün 日本 שלום 🙂\n\tC:\\x1b";
    EXPECT_EQ(printable(text), text);
    EXPECT_EQ(printable(printable("\x1b\u202E")), printable("\x1b\u202E"));
    EXPECT_EQ(one_line("a\nb\tc\r"), R"(a b c\x0d)");
}

TEST(Shortened, LeavesOutTheMiddleOfLongWords) {
    EXPECT_EQ(shortened("a short line", 100), "a short line");
    const std::string line = shortened("/" + std::string(4000, 'a') + "/end.glb: no such file", 200);
    EXPECT_LE(line.size(), 200u);
    EXPECT_TRUE(line.starts_with("/aaaa")) << line;
    EXPECT_NE(line.find("...aaaa"), std::string::npos) << line;
    EXPECT_TRUE(line.ends_with("/end.glb: no such file")) << line;
}

TEST(Shortened, LeavesOutTheMiddleOfALineOfManyWords) {
    std::string words = "begin";
    for (int i = 0; i < 1000; ++i) words += " word";
    const std::string line = shortened(words + " end", 300);
    EXPECT_LE(line.size(), 300u);
    EXPECT_TRUE(line.starts_with("begin word")) << line;
    EXPECT_TRUE(line.ends_with("word end")) << line;
}

TEST(Shortened, CutsBetweenCharacters) {
    for (std::size_t most = 100; most < 110; ++most) {
        std::string word;
        for (int i = 0; i < 100; ++i) word += "日";
        const std::string line = shortened(word, most);
        EXPECT_LE(line.size(), most);
        EXPECT_EQ(printable(line), line) << "no character was cut";
    }
    EXPECT_LE(shortened(std::string(5000, '\x1b'), 100).size(), 100u);
}

}  // namespace
}  // namespace zproof
