#include "tests/mutants/rivals.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "image_io/image_io.h"
#include "reports/pictures.h"

namespace zproof {
namespace {

/// The share of pixels at which two planes agree.
template <class T, class Agree>
double share(const Plane<T>& a, const Plane<T>& b, Agree agree) {
    std::size_t agreeing = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) agreeing += agree(a.pixels()[i], b.pixels()[i]);
    return double(agreeing) / double(a.pixels().size());
}

template <class T>
bool passes(const IdiffOptions& options, const OIIO::ImageSpec& spec, const Plane<T>& a, const Plane<T>& b) {
    // ImageBuf takes memory to write to, and only reads it.
    Plane<T> mine = a, theirs = b;
    const OIIO::ImageBuf one(spec, mine.pixels().data()), other(spec, theirs.pixels().data());
    const auto result = OIIO::ImageBufAlgo::compare(one, other, options.fail, options.fail);
    return double(result.nfail) <= options.fail_percent / 100 * double(a.size().pixel_count());
}

/// Is the id among the 3 x 3 pixels around, and the depth between the least and the greatest there, give or
/// take 0.1 %?
bool is_found_nearby(const Frame& reference, int x, int y, PrimitiveId id, float depth) {
    const Resolution size = reference.size();
    bool has_id = false;
    float least = background_depth, greatest = 0;
    for (int v = std::max(0, y - 1); v <= std::min(size.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(size.width - 1, x + 1); ++u) {
            has_id = has_id || reference.primitive.at(u, v) == id;
            least = std::min(least, reference.camera_depth.at(u, v));
            greatest = std::max(greatest, reference.camera_depth.at(u, v));
        }
    return has_id && depth >= 0.999f * least && depth <= 1.001f * greatest;
}

}  // namespace

bool passes_pytorch3d(const Frame& candidate, const Frame& reference) {
    if (candidate.size() != reference.size()) return false;
    const auto same = [](PrimitiveId a, PrimitiveId b) { return a == b; };
    const auto close = [](float a, float b) { return a == b || std::abs(a - b) < 0.001f; };
    return share(candidate.primitive, reference.primitive, same) >= 0.9999 &&
           share(candidate.camera_depth, reference.camera_depth, close) >= 0.999;
}

bool passes_fuzzy_window(const Frame& candidate, const Frame& reference) {
    const Resolution size = candidate.size();
    if (size != reference.size()) return false;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (!is_found_nearby(reference, x, y, candidate.primitive.at(x, y),
                                 candidate.camera_depth.at(x, y)))
                return false;
    return true;
}

bool passes_idiff(const IdiffOptions& options, const Frame& candidate, const Frame& reference) {
    const auto [width, height] = candidate.size();
    if (candidate.size() != reference.size()) return false;
    return passes(options, {width, height, 3, OIIO::TypeDesc::UINT8}, picture_of_ids(candidate.primitive),
                  picture_of_ids(reference.primitive)) &&
           passes(options, {width, height, 1, OIIO::TypeDesc::FLOAT}, candidate.camera_depth,
                  reference.camera_depth);
}

void write_for_idiff(const std::filesystem::path& stem, const Frame& frame) {
    write_png(stem.string() + "-id.png", picture_of_ids(frame.primitive));
    const std::string file = stem.string() + "-depth.exr";
    OIIO::ImageSpec spec(frame.size().width, frame.size().height, 1, OIIO::TypeFloat);
    spec.channelnames = {"Z"};
    const auto output = OIIO::ImageOutput::create(file);
    if (!output->open(file, spec) ||
        !output->write_image(OIIO::TypeFloat, frame.camera_depth.pixels().data()))
        throw std::runtime_error(file + ": " + output->geterror());
}

}  // namespace zproof
