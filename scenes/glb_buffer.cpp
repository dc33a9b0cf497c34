#include "scenes/glb_buffer.h"

#include <bit>

namespace zproof {

static_assert(std::endian::native == std::endian::little,
              "GLB is little-endian, and so must this machine be");

int GlbBuffer::add_view(std::string_view bytes, const nlohmann::json& extra) {
    nlohmann::json view = extra;
    view["buffer"] = 0;
    view["byteOffset"] = bytes_.size();
    view["byteLength"] = bytes.size();
    views_.push_back(std::move(view));
    bytes_.append(bytes);
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    return static_cast<int>(views_.size()) - 1;
}

int GlbBuffer::add_accessor(int view, const ElementType& element, ElementRange range) {
    accessors_.push_back({{"bufferView", view},
                          {"byteOffset", range.first * element.bytes},
                          {"componentType", element.component_type},
                          {"count", range.count},
                          {"type", element.type}});
    return static_cast<int>(accessors_.size()) - 1;
}

int GlbBuffer::add_bounded_accessor(int view, ElementRange range, std::span<const float> low,
                                    std::span<const float> high) {
    const int accessor = add_accessor(view, {.type = "VEC3", .bytes = 12}, range);
    accessors_.back()["min"] = std::vector<float>(low.begin(), low.end());
    accessors_.back()["max"] = std::vector<float>(high.begin(), high.end());
    return accessor;
}

}  // namespace zproof
