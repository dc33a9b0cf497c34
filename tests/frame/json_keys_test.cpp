#include "frame/json_keys.h"

#include <gtest/gtest.h>

namespace zproof {
namespace {

/// The byte at which a key stands again; -1: none does.
long byte_of(std::string_view json) {
    const auto repeated = repeated_key(json);
    return repeated ? long(repeated->byte) : -1;
}

TEST(JsonKeys, StandTwiceInOneObjectOnly) {
    EXPECT_EQ(byte_of(R"({"a": 1, "b": {"a": 2}, "c": [{"a": 3}, {"a": 4}]})"), -1);
    EXPECT_EQ(byte_of(R"({"a": "b", "b": "a", "c": "\"a\": 1, }{"})"), -1);
    EXPECT_EQ(byte_of(R"({"a": 1, "b": 2, "a" : 1})"), 17);
    EXPECT_EQ(byte_of(R"({"a": {"b": 1, "c": [{}], "b": 1}})"), 26);
    EXPECT_EQ(byte_of(R"({"a": {"a": 1}, "a": 1})"), 16);
    EXPECT_EQ(byte_of(R"([{"": 1}, {"": 1, "": 1}])"), 18);
}

TEST(JsonKeys, AreTheSameHoweverTheyAreSpelt) {
    EXPECT_EQ(byte_of(R"({"mesh": 1, "\u006desh": 2})"), 12);
    EXPECT_EQ(byte_of(R"({"a\"": 1, "a": 2, "a\\": 3})"), -1);
}

TEST(JsonKeys, OfTextThatIsNoJsonAreReadToItsEnd) {
    for (const char* text : {"", "\"", "}", "\"a\": 1}", "{\"a\": 1", "{\"a\\", R"({"\u00zz": 1, "\)"})
        EXPECT_EQ(byte_of(text), -1) << text;
}

}  // namespace
}  // namespace zproof
