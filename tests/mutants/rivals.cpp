#include "tests/mutants/rivals.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "frame/encode.h"
#include "frame/png.h"
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

bool has_nearby(const Frame& reference, int x, int y, PrimitiveId id, float depth) {
    const Resolution size = reference.size();
    for (int v = std::max(0, y - 1); v <= std::min(size.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(size.width - 1, x + 1); ++u) {
            const float theirs = reference.camera_depth.at(u, v);
            if (reference.primitive.at(u, v) != id) continue;
            if (theirs == depth || std::abs(theirs - depth) <= 0.001f * std::abs(theirs)) return true;
        }
    return false;
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
            if (!has_nearby(reference, x, y, candidate.primitive.at(x, y), candidate.camera_depth.at(x, y)))
                return false;
    return true;
}

void write_for_idiff(const std::filesystem::path& stem, const Frame& frame) {
    write_png(stem.string() + "-id.png", picture_of_ids(frame.primitive));
    const std::string file = stem.string() + "-depth.exr";
    OIIO::ImageSpec spec(frame.size().width, frame.size().height, 1, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"Z"};
    const auto bytes = encode({"openexr", spec}, frame.camera_depth.pixels().data(), file);
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    if (!out) throw std::runtime_error(file + ": cannot be written; is the disk full?");
}

}  // namespace zproof
