#include "image_io/module.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "frame/frame_error.h"
#include "image_io/image_io.h"
#include "tests/frame/scratch_folder.h"

namespace zproof {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Module : public ScratchFolder {};

/// In a process of its own, which has not loaded the module.
void write_with_module(const std::string& module, const std::filesystem::path& image) {
    setenv("ZPROOF_IMAGE_IO", module.c_str(), 1);
    const std::string said = complaint<FrameError>([&] { write_frame(image, Frame({2, 2})); });
    std::fputs(said.c_str(), stderr);
    std::_Exit(said.empty() ? 0 : 3);
}

TEST_F(Module, ThatIsMissingIsNamedTogetherWithWhatToDo) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        write_with_module("/no/such/module.so", file("a.exr")), testing::ExitedWithCode(3),
        AllOf(HasSubstr("/no/such/module.so"), HasSubstr("libopenimageio2.4"), HasSubstr("ZPROOF_IMAGE_IO")));
    EXPECT_EQ(file_count(), 0u);
}

TEST_F(Module, AnotherLibraryIsRefused) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(write_with_module("libz.so.1", file("a.exr")), testing::ExitedWithCode(3),
                HasSubstr("it is no image module of zproof"));
}

TEST_F(Module, IsFoundByTheRunPath) { EXPECT_EQ(image_io::module().interface, image_io::interface_number); }

}  // namespace
}  // namespace zproof
