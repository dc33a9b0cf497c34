#include "reports/page_scripts.h"

#include <gtest/gtest.h>

#include "tests/reports/sample.h"

namespace zproof {

TEST(PageScripts, StandInTheirElementsWithoutEndingThem) {
    for (const PageScript& script : {table_script(), viewer_script()}) {
        EXPECT_GT(script.text.size(), 1000u);
        EXPECT_EQ(script.sha256.size(), 44u) << "32 bytes as base64";
        const std::string element = script_element(script);
        EXPECT_EQ(occurrences(element, "</script"), 1u);
        EXPECT_EQ(occurrences(element, "://"), 0u);
        EXPECT_EQ(
            occurrences(content_policy(script), "script-src 'sha256-" + std::string(script.sha256) + "';"),
            1u);
    }
    PageScript loading = viewer_script();
    loading.loads_others = true;
    EXPECT_EQ(occurrences(content_policy(loading), "' 'self' file:; style-src"), 1u);
    EXPECT_NE(table_script().sha256, viewer_script().sha256);
}

}  // namespace zproof
