#include "image_io/npy_array.h"

#include <gmock/gmock.h>

#include "frame/frame_error.h"
#include "image_io/image_io.h"
#include "tests/frame/scratch_folder.h"
#include "tests/image_io/npy.h"

namespace zproof::image_io {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class NpyFile : public ScratchFolder {
  protected:
    std::string refusal() const {
        return complaint<FrameError>([&] { NpyArray{file("a.npy")}; });
    }
    std::string refusal_of(const std::string& header, std::size_t bytes) const {
        write_npy(file("a.npy"), header, std::string(bytes, '\0'));
        return refusal();
    }
};

TEST_F(NpyFile, IdsAndDepthsInTheContractsTypesNeedNoConvention) {
    write_npy<std::uint32_t>(file("id.npy"), "<u4", "1, 2", {0x1000001, 0xFFFFFFFF});
    write_npy<float>(file("z.npy"), "<f4", "1, 2", {0.1f, 2});
    const Frame frame = read_frame(file("id.npy").string() + "+" + file("z.npy").string());
    EXPECT_EQ(frame.primitive.at(0, 0), PrimitiveId{0x1000001});
    EXPECT_EQ(frame.primitive.at(1, 0), PrimitiveId::none);
    EXPECT_EQ(frame.camera_depth.at(0, 0), 0.1f);
}

TEST_F(NpyFile, WhatIsNoPlainImageIsRefusedInWords) {
    const std::string shape = "'shape': (2, 3), }";
    EXPECT_EQ(refusal_of("{'descr': '<f4', 'fortran_order': False, " + shape, 24), "");
    EXPECT_THAT(refusal_of("{'descr': '<f4', 'fortran_order': True, " + shape, 24),
                AllOf(HasSubstr("a.npy: samples in Fortran order"), HasSubstr("ascontiguousarray")));
    EXPECT_THAT(refusal_of("{'descr': '>f4', 'fortran_order': False, " + shape, 24),
                AllOf(HasSubstr("'>f4'"), HasSubstr("astype")));
    EXPECT_THAT(refusal_of("{'descr': '|O', 'fortran_order': False, " + shape, 24), HasSubstr("'|O'"));
    EXPECT_THAT(refusal_of("{'descr': [('a', '<f4')], 'fortran_order': False, " + shape, 24),
                HasSubstr("not understood"));
    EXPECT_THAT(refusal_of("nothing of the kind", 24), HasSubstr("not understood"));
}

TEST_F(NpyFile, ShapesThatAreNoImageAreRefused) {
    const auto of_shape = [&](const std::string& shape) {
        return refusal_of("{'descr': '|u1', 'fortran_order': False, 'shape': (" + shape + "), }", 6);
    };
    EXPECT_EQ(of_shape("2, 3"), "");
    EXPECT_EQ(of_shape("1, 2, 3"), "");  // three channels
    EXPECT_EQ(of_shape("1, 1, 2, 3"), "");
    for (const char* shape : {"", "6,", "2, 1, 1, 3", "1, 1, 1, 2, 3", "2, 3, 0", "1, 2, 1000000000000"})
        EXPECT_THAT(of_shape(shape), HasSubstr("expected (height, width)")) << shape;
    EXPECT_THAT(of_shape("0, 3"), HasSubstr("3 x 0"));
    EXPECT_THAT(of_shape("1, 4294967296"), HasSubstr("32768"));
}

TEST_F(NpyFile, MoreOrFewerSamplesThanTheHeaderSaysAreRefused) {
    const std::string header = "{'descr': '<i8', 'fortran_order': False, 'shape': (2, 3), }";
    for (const std::size_t bytes : {0, 47, 49})
        EXPECT_THAT(refusal_of(header, bytes), AllOf(HasSubstr(std::to_string(bytes) + " bytes of samples"),
                                                     HasSubstr("its header says 48")));
}

TEST_F(NpyFile, AFileThatEndsWithinItsHeaderIsRefused) {
    for (const std::string& bytes : {std::string("\x93NUMPY"), std::string("\x93NUMPY\x01\0\x40", 9),
                                     std::string("\x93NUMPY\x02\0\x40\0\0\0{", 13)}) {
        std::ofstream(file("a.npy"), std::ios::binary) << bytes;
        EXPECT_THAT(refusal(), HasSubstr("the file ends within its .npy header"));
    }
    std::ofstream(file("a.npy"), std::ios::binary) << std::string("\x93NUMPY\x04\0\x40\0", 10);
    EXPECT_THAT(refusal(), HasSubstr("version 4"));
    std::ofstream(file("a.npy"), std::ios::binary) << std::string("\x93NUMPY\x02\0\xFF\xFF\xFF\xFF", 12);
    EXPECT_THAT(refusal(), HasSubstr("header of 4294967295 bytes"));
}

}  // namespace
}  // namespace zproof::image_io
