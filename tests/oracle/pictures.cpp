#include "pictures.h"

#include <cstring>

namespace zproof::oracle {

std::string picture(const Frame& frame) {
    std::string rows = "\n";
    for (int y = 0; y < frame.size().height; ++y) {
        for (const PrimitiveId id : frame.primitive.row(y)) {
            rows += id == PrimitiveId::none ? '.' : static_cast<char>('0' + static_cast<int>(id));
        }
        rows += '\n';
    }
    return rows;
}

View unit_pixels(int width, int height) {
    View view{.name = "unit_pixels", .camera = {}, .width = width, .height = height};
    view.camera.window = {-width / 2.0, width / 2.0, -height / 2.0, height / 2.0};
    return view;
}

Corners wall(float depth) {
    return {{-40 * depth, -20 * depth, -depth}, {40 * depth, -20 * depth, -depth}, {0, 40 * depth, -depth}};
}

Corners together(std::initializer_list<Corners> parts) {
    Corners all;
    for (const Corners& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

bool same_bits(const Frame& a, const Frame& b) {
    const auto same = [](auto x, auto y) {
        return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size_bytes()) == 0;
    };
    return same(a.primitive.pixels(), b.primitive.pixels()) &&
           same(a.camera_depth.pixels(), b.camera_depth.pixels());
}

}  // namespace zproof::oracle
