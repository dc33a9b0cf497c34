#include "reports/page_text.h"

#include <gtest/gtest.h>

#include "reports/base64.h"
#include "tests/reports/sample.h"

namespace zproof {
namespace {

/// Longer than the pieces that a page is written in, and never a multiple of three.
std::string long_bytes() {
    std::string bytes;
    for (std::uint32_t i = 0; i < 400'000; ++i) bytes += char(i * 2654435761u >> 24);
    return bytes;
}

TEST(Base64, IsRfc4648) {
    const char* const expected[] = {"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
    for (std::size_t size = 0; size <= 6; ++size)
        EXPECT_EQ(base64(std::string_view("foobar").substr(0, size)), expected[size]);
    EXPECT_EQ(base64("\xFB\xFF\xBF"), "+/+/");
}

TEST(PageText, IsItsPiecesAndWhatFilesHold) {
    const TestFolder folder;
    const std::string bytes = long_bytes(), front = "front";
    write_whole_file(folder.path() / "planes", bytes);
    const Page page{"<p>",
                    FileAsBase64{front, folder.path() / "planes", {{300'000, 100'000}, {7, 0}, {0, 200'000}}},
                    "</p>"};
    const std::string expected =
        "<p>" + base64(front + bytes.substr(300'000) + bytes.substr(0, 200'000)) + "</p>";
    EXPECT_TRUE(text_of(page) == expected) << "some 400 000 characters";
    write_page(folder.path() / "page", page);
    EXPECT_TRUE(content_of(folder.path() / "page") == expected);
}

TEST(PageText, RefusesFilesThatLackWhatItHolds) {
    const TestFolder folder;
    write_whole_file(folder.path() / "short", "1234");
    EXPECT_THROW(text_of({FileAsBase64{"", folder.path() / "short", {{2, 3}}}}), ReportError);
    EXPECT_THROW(text_of({FileAsBase64{"", folder.path() / "absent", {{0, 1}}}}), ReportError);
    EXPECT_THROW(write_page(folder.path() / "no" / "page", {"text"}), ReportError);
}

}  // namespace
}  // namespace zproof
