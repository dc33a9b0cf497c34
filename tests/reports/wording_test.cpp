#include "reports/wording.h"

#include <gtest/gtest.h>

#include <limits>

namespace zproof {

TEST(Wording, NumbersAreShortestAndReadBack) {
    EXPECT_EQ(shortest(0.1), "0.1");
    EXPECT_EQ(shortest(0.1f), "0.1");
    EXPECT_EQ(shortest(16777216.0f), "16777216");
    EXPECT_EQ(shortest(0.30000000000000004), "0.30000000000000004");
    EXPECT_EQ(shortest(-std::numeric_limits<float>::infinity()), "-inf");
    EXPECT_EQ(shortest(-std::numeric_limits<double>::quiet_NaN()), "nan");
    EXPECT_EQ(hex_bits(1.0f), "0x3f800000");
    EXPECT_EQ(hex_bits(0.0f), "0x00000000");
}

TEST(Wording, CountsAreGrouped) {
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1000), "1,000");
    EXPECT_EQ(grouped(1234567), "1,234,567");
    EXPECT_EQ(counted(1, "view"), "1 view");
    EXPECT_EQ(counted(0, "view"), "0 views");
}

TEST(Wording, MarkupIsEscaped) {
    EXPECT_EQ(escaped("</script><img onerror=\"x\" y='z'>&"),
              "&lt;/script&gt;&lt;img onerror=&quot;x&quot; y=&#39;z&#39;&gt;&amp;");
}

TEST(Wording, UrlsStayRelative) {
    EXPECT_EQ(as_url("scenes/room-1.a/class.png"), "scenes/room-1.a/class.png");
    EXPECT_EQ(as_url("javascript:x\"#?"), "javascript%3Ax%22%23%3F");
}

}  // namespace zproof
