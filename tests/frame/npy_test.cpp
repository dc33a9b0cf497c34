#include "frame/npy.h"

#include <gmock/gmock.h>

#include <bit>
#include <fstream>
#include <string>

#include "frame/frame_error.h"
#include "scratch_folder.h"

namespace zproof {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using namespace std::string_literals;

class Npy : public ScratchFolder {
  protected:
    std::string bytes(const std::string& name) const {
        std::ifstream in(file(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    /// A file as numpy.save writes it, with this dictionary and these values.
    void save(const std::string& name, std::string dictionary, const std::string& values) const {
        dictionary.resize(117, ' ');
        dictionary += '\n';
        std::ofstream(file(name), std::ios::binary) << "\x93NUMPY\x01\x00\x76\x00"s << dictionary << values;
    }
    std::string refusal(const std::string& name) const {
        return complaint<FrameError>([&] { read_npy_float32(file(name)); });
    }
};

TEST_F(Npy, WritesWhatNumpyWrites) {
    Plane<std::uint32_t> plane({3, 2});
    for (std::uint32_t i = 0; i < 6; ++i) plane.pixels()[i] = i + 1;
    write_npy(file("a.npy"), plane);
    save("numpy.npy", "{'descr': '<u4', 'fortran_order': False, 'shape': (2, 3), }",
         "\1\0\0\0\2\0\0\0\3\0\0\0\4\0\0\0\5\0\0\0\6\0\0\0"s);
    EXPECT_EQ(bytes("a.npy"), bytes("numpy.npy"));
}

TEST_F(Npy, KeepsEveryBitOfDepths) {
    Plane<float> plane({3, 2});
    const std::uint32_t hard[] = {0x80000000, 0x00000001, 0x7F800001, 0xFFFFFFFF, 0x7FC12345, 0x7F800000};
    for (std::size_t i = 0; i < 6; ++i) plane.pixels()[i] = std::bit_cast<float>(hard[i]);
    write_npy(file("a.npy"), plane);
    const Plane<float> back = read_npy_float32(file("a.npy"));
    ASSERT_EQ(back.size(), plane.size());
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(std::bit_cast<std::uint32_t>(back.pixels()[i]), hard[i]);
}

TEST_F(Npy, WritesIdsAsTheirNumbers) {
    Plane<PrimitiveId> plane({2, 1}, PrimitiveId::none);
    plane.at(0, 0) = PrimitiveId{0x1000001};
    write_npy(file("a.npy"), plane);
    const Plane<std::uint32_t> back = read_npy_uint32(file("a.npy"));
    EXPECT_EQ(back.at(0, 0), 0x1000001u);
    EXPECT_EQ(back.at(1, 0), 0xFFFFFFFFu);
}

TEST_F(Npy, ReadsKeysInAnyOrder) {
    save("a.npy", "{'shape':(1,1),'descr':'<f4','fortran_order':False}", "\0\0\x80\x3F"s);
    EXPECT_EQ(read_npy_float32(file("a.npy")).at(0, 0), 1.0f);
}

TEST_F(Npy, MissingFileIsNamed) { EXPECT_THAT(refusal("gone.npy"), HasSubstr("gone.npy: no such file")); }

TEST_F(Npy, OtherFilesAndVersionsAreRefused) {
    std::ofstream(file("text.npy")) << "hello";
    EXPECT_THAT(refusal("text.npy"), HasSubstr("text.npy: not a NumPy array"));
    std::ofstream(file("two.npy")) << "\x93NUMPY\x02\x00\x04\x00\x00\x00    "s;
    EXPECT_THAT(refusal("two.npy"), HasSubstr("version 1.0"));
}

TEST_F(Npy, OtherTypesOrdersAndShapesAreRefused) {
    save("u4.npy", "{'descr': '<u4', 'fortran_order': False, 'shape': (1, 1), }", "1234");
    EXPECT_THAT(refusal("u4.npy"), AllOf(HasSubstr("'descr' is '<u4'"), HasSubstr("expected '<f4'")));
    save("f.npy", "{'descr': '<f4', 'fortran_order': True, 'shape': (1, 1), }", "1234");
    EXPECT_THAT(refusal("f.npy"), HasSubstr("'fortran_order' is True"));
    save("3d.npy", "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 1, 1), }", "1234");
    EXPECT_THAT(refusal("3d.npy"), HasSubstr("'shape' is (1,1,1)"));
    save("1d.npy", "{'descr': '<f4', 'fortran_order': False, 'shape': (1,), }", "1234");
    EXPECT_THAT(refusal("1d.npy"), HasSubstr("'shape' is (1,)"));
    save("open.npy", "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 1", "1234");
    EXPECT_THAT(refusal("open.npy"), HasSubstr("'shape' is "));
    save("big.npy", "{'descr': '<f4', 'fortran_order': False, 'shape': (99999999999, 1), }", "1234");
    EXPECT_THAT(refusal("big.npy"), HasSubstr("'shape' is (99999999999,1)"));
    save("0.npy", "{'descr': '<f4', 'fortran_order': False, 'shape': (0, 4), }", "");
    EXPECT_THAT(refusal("0.npy"), HasSubstr("size 4 x 0"));
    save("none.npy", "{'fortran_order': False, 'shape': (1, 1), }", "1234");
    EXPECT_THAT(refusal("none.npy"), HasSubstr("'descr' is missing"));
}

TEST_F(Npy, TooFewOrTooManyValuesAreRefused) {
    save("few.npy", "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 1), }", "1234567");
    EXPECT_THAT(refusal("few.npy"), AllOf(HasSubstr("7 bytes"), HasSubstr("expected 8")));
    save("many.npy", "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 1), }", "123456789");
    EXPECT_THAT(refusal("many.npy"), AllOf(HasSubstr("9 bytes"), HasSubstr("expected 8")));
    std::ofstream(file("cut.npy")) << "\x93NUMPY\x01\x00\x76\x00{'descr'"s;
    EXPECT_THAT(refusal("cut.npy"), HasSubstr("header is cut short"));
}

TEST_F(Npy, PlaneWithoutPixelsIsRefused) {
    EXPECT_THAT(complaint<FrameError>([&] { write_npy(file("a.npy"), Plane<float>{}); }), HasSubstr("0 x 0"));
}

}  // namespace
}  // namespace zproof
