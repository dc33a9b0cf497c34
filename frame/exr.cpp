#include "frame/exr.h"

#include "frame/exr_decode.h"
#include "frame/exr_encode.h"
#include "frame/frame_size.h"

namespace zproof {

void write_exr(const std::filesystem::path& file, const Frame& frame) {
    static_assert(sizeof(PrimitiveId) == 4 && sizeof(float) == 4);
    const ExrChannel channels[] = {{"Z", ExrType::float32, frame.camera_depth.pixels().data()},
                                   {"id", ExrType::uint32, frame.primitive.pixels().data()}};
    write_exr(file, frame.size(), channels);
}

void write_exr(const std::filesystem::path& file, const Picture& picture) {
    refuse_bad_size(picture.size(), file.string());
    const LinearRgb* first = picture.pixels().data();
    const ExrChannel channels[] = {{"B", ExrType::float32, &first->b, sizeof *first},
                                   {"G", ExrType::float32, &first->g, sizeof *first},
                                   {"R", ExrType::float32, &first->r, sizeof *first}};
    write_exr(file, picture.size(), channels);
}

Frame read_exr(const std::filesystem::path& file) {
    const ExrReader reader(file);
    Frame frame(reader.size());
    const WantedChannel channels[] = {{"id", ExrType::uint32, frame.primitive.pixels().data()},
                                      {"Z", ExrType::float32, frame.camera_depth.pixels().data()}};
    reader.read(channels);
    return frame;
}

Picture read_picture_exr(const std::filesystem::path& file) {
    const ExrReader reader(file);
    Picture picture(reader.size());
    LinearRgb* first = picture.pixels().data();
    const WantedChannel channels[] = {{"R", ExrType::float32, &first->r, sizeof *first},
                                      {"G", ExrType::float32, &first->g, sizeof *first},
                                      {"B", ExrType::float32, &first->b, sizeof *first}};
    reader.read(channels);
    return picture;
}

}  // namespace zproof
