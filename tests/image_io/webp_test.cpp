#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include "frame/frame_error.h"
#include "image_io/image_io.h"
#include "tests/frame/scratch_folder.h"

namespace zproof {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class WebP : public ScratchFolder {};

/// Red, green and blue side by side above white.
Plane<Rgb8> four_fields(Resolution size) {
    Plane<Rgb8> picture(size, Rgb8{255, 255, 255});
    const Rgb8 upper[] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}};
    for (int y = 0; y < size.height / 2; ++y)
        for (int x = 0; x < size.width; ++x) picture.row(y)[std::size_t(x)] = upper[3 * x / size.width];
    return picture;
}

TEST_F(WebP, IsReadByOthersInTheSamePlacesAndColours) {
    const Plane<Rgb8> picture = four_fields({301, 160});
    write_webp(file("a.webp"), picture);
    const auto input = OIIO::ImageInput::open(file("a.webp").string());
    ASSERT_TRUE(input) << OIIO::geterror();
    ASSERT_EQ(input->spec().nchannels, 3);
    ASSERT_EQ((Resolution{input->spec().width, input->spec().height}), picture.size());
    Plane<Rgb8> back(picture.size());
    ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeUInt8, back.pixels().data())) << input->geterror();
    for (const int y : {40, 120})
        for (const std::size_t x : {50u, 150u, 250u}) {
            const Rgb8 found = back.row(y)[x], expected = picture.row(y)[x];
            EXPECT_TRUE((found.r > 127) == (expected.r > 127) && (found.g > 127) == (expected.g > 127) &&
                        (found.b > 127) == (expected.b > 127))
                << x << ", " << y;
        }
}

TEST_F(WebP, OfASideBeyondTheFormatsIsRefusedAndLeavesNoFile) {
    for (const Resolution size : {Resolution{0, 0}, Resolution{16384, 1}, Resolution{1, 16384}})
        EXPECT_THAT(complaint<FrameError>([&] { write_webp(file("a.webp"), Plane<Rgb8>(size)); }),
                    AllOf(HasSubstr("a.webp"), HasSubstr("expected sides of 1 to 16383")));
    EXPECT_EQ(file_count(), 0u);
    EXPECT_EQ(complaint<FrameError>([&] { write_webp(file("a.webp"), Plane<Rgb8>({16383, 1})); }), "");
}

}  // namespace
}  // namespace zproof
