#include "scenes/gltf/decoders.h"

#include <meshoptimizer.h>

#include <map>
#include <string_view>

namespace zproof {
namespace {

std::string fault_of_filter(const MeshoptView& view) {
    if (view.filter == "NONE") return {};
    if (view.mode != "ATTRIBUTES") return "expected the filter NONE for the mode " + view.mode;
    if (view.filter == "OCTAHEDRAL" && view.stride != 4 && view.stride != 8)
        return "expected a byteStride of 4 or 8 for the filter OCTAHEDRAL";
    if (view.filter == "QUATERNION" && view.stride != 8)
        return "expected a byteStride of 8 for the filter QUATERNION";
    return {};
}

void undo_filter(const MeshoptView& view, unsigned char* values) {
    if (view.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(values, view.count, view.stride);
    if (view.filter == "QUATERNION") meshopt_decodeFilterQuat(values, view.count, view.stride);
    if (view.filter == "EXPONENTIAL") meshopt_decodeFilterExp(values, view.count, view.stride);
}

}  // namespace

bool has_meshopt() { return true; }

std::string fault_of(const MeshoptView& view) {
    if (view.mode == "ATTRIBUTES" && (view.stride % 4 != 0 || view.stride > 256))
        return "expected a byteStride that is a multiple of 4 up to 256 for the mode ATTRIBUTES";
    if (view.mode != "ATTRIBUTES" && view.stride != 2 && view.stride != 4)
        return "expected a byteStride of 2 or 4 for the mode " + view.mode;
    if (view.mode == "TRIANGLES" && view.count % 3 != 0)
        return "expected a count that is a multiple of 3 for the mode TRIANGLES";
    return fault_of_filter(view);
}

bool decode_meshopt(const MeshoptView& view, std::span<const unsigned char> stream,
                    std::span<unsigned char> to) {
    using Decoder = int (*)(void*, std::size_t, std::size_t, const unsigned char*, std::size_t);
    const std::map<std::string_view, Decoder> decoders{{"ATTRIBUTES", meshopt_decodeVertexBuffer},
                                                       {"TRIANGLES", meshopt_decodeIndexBuffer},
                                                       {"INDICES", meshopt_decodeIndexSequence}};
    if (decoders.at(view.mode)(to.data(), view.count, view.stride, stream.data(), stream.size()) != 0)
        return false;
    undo_filter(view, to.data());
    return true;
}

}  // namespace zproof
