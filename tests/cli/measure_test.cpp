// measure --emit writes a precision file that --precision takes, or none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frame/precision_text.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(MeasureEmit, WritesAPrecisionThatIsThenKept) {
    const Folder folder;
    const Ran first = run(folder, {"measure", "zproof", "--precision", "raster,subpixel_bits=4,snap=truncate",
                                   "--emit", "mine.json"});
    EXPECT_EQ(first.exit_code, 0) << first.err;
    const auto emitted =
        std::get<RasterPrecision>(precision_from_json(folder.read("mine.json"), "mine.json"));
    EXPECT_EQ(emitted.subpixel_bits, 8);
    EXPECT_EQ(emitted.snap, Snap::nearest);
    const Ran second = run(folder, {"measure", "zproof", "--precision", "mine.json", "--emit", "again.json"});
    EXPECT_EQ(second.exit_code, 0) << second.out << second.err;
    EXPECT_EQ(folder.read("again.json"), folder.read("mine.json"));
}

TEST(MeasureEmit, LeavesNothingWhereNothingWasMeasured) {
    const Folder folder;
    folder.write("kept.json", "old");
    const Ran ran = run(folder, {"measure", "false {out}", "--emit", "kept.json"});
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_EQ(folder.read("kept.json"), "old");
    EXPECT_THAT(folder.names(), ElementsAre("kept.json"));
}

TEST(MeasureEmit, NamesTheFileThatItCannotWrite) {
    const Folder folder;
    const Ran ran = run(folder, {"measure", "zproof", "--emit", "absent/mine.json"});
    EXPECT_EQ(ran.exit_code, 3) << ran.out;
    EXPECT_THAT(ran.err, HasSubstr("absent/mine.json: cannot be written"));
    EXPECT_THAT(folder.names(), ElementsAre());
}

}  // namespace
}  // namespace zproof::test
