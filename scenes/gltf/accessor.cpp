#include "scenes/gltf/accessor.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "scenes/largest.h"
#include "scenes/limits.h"
#include "scenes/polygon_mesh.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

template <typename T>
T load(const unsigned char* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

std::size_t element_bytes(const Elements& elements) {
    return static_cast<std::size_t>(elements.components) * component_bytes(elements.component_type);
}

/// An integer as the number that it stands for (glTF 2.0, 3.11 of the extension KHR_mesh_quantization).
template <typename T>
double value_of_integer(const Elements& elements, const unsigned char* from) {
    const double value = load<T>(from);
    return elements.is_normalized ? std::max(value / std::numeric_limits<T>::max(), -1.0) : value;
}

}  // namespace

std::size_t component_bytes(int component_type) {
    if (component_type <= TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return 1;
    return component_type <= TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 2 : 4;
}

double component(const Elements& elements, std::size_t i, int c) {
    const unsigned char* from = elements.first + i * elements.stride +
                                static_cast<std::size_t>(c) * component_bytes(elements.component_type);
    switch (elements.component_type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return value_of_integer<std::int8_t>(elements, from);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return value_of_integer<std::uint8_t>(elements, from);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return value_of_integer<std::int16_t>(elements, from);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return value_of_integer<std::uint16_t>(elements, from);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return value_of_integer<std::uint32_t>(elements, from);
        default:
            return static_cast<double>(load<float>(from));
    }
}

namespace {

/// read(T{}) with the type T of the indices.
template <typename Read>
auto by_index_type(const Elements& indices, const Read& read) {
    switch (indices.component_type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return read(std::uint8_t{});
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return read(std::uint16_t{});
        default:
            return read(std::uint32_t{});
    }
}

template <typename T>
void read_indices_of(const Elements& elements, std::size_t first, std::span<std::uint32_t> to) {
    const unsigned char* from = elements.first + first * elements.stride;
    if (elements.stride == sizeof(T))  // a constant, so that they are read side by side
        for (std::size_t i = 0; i < to.size(); ++i) to[i] = load<T>(from + i * sizeof(T));
    else
        for (std::size_t i = 0; i < to.size(); ++i) to[i] = load<T>(from + i * elements.stride);
}

/// largest() of many, side by side.
template <typename T>
T largest_of_many(const unsigned char* numbers, std::size_t count, T mask = T(-1)) {
    constexpr std::size_t worth_a_task = 1 << 16;
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, count, worth_a_task), T{0},
        [=](const auto& some, T most) {
            return std::max(most, largest(numbers + some.begin() * sizeof(T), some.size(), mask));
        },
        [](T a, T b) { return std::max(a, b); });
}

template <typename T>
std::uint32_t largest_index_of(const Elements& elements) {
    if (elements.stride == sizeof(T)) return largest_of_many<T>(elements.first, elements.count);
    T most = 0;
    for (std::size_t i = 0; i < elements.count; ++i)
        most = std::max(most, load<T>(elements.first + i * elements.stride));
    return most;
}

/// The first element with a float that is not finite.
std::optional<std::size_t> first_not_finite(const Elements& elements) {
    if (elements.component_type != TINYGLTF_COMPONENT_TYPE_FLOAT) return std::nullopt;
    const auto components = static_cast<std::size_t>(elements.components);
    if (elements.stride == element_bytes(elements) &&
        largest_of_many(elements.first, elements.count * components, magnitude_bits) < infinite_bits)
        return std::nullopt;
    for (std::size_t i = 0; i < elements.count; ++i) {
        bool is_finite = true;
        for (std::size_t c = 0; c < components; ++c)
            is_finite &= std::isfinite(load<float>(elements.first + i * elements.stride + c * sizeof(float)));
        if (!is_finite) return i;
    }
    return std::nullopt;
}

}  // namespace

std::uint32_t index_at(const Elements& elements, std::size_t i) {
    const unsigned char* from = elements.first + i * elements.stride;
    return by_index_type(elements, [=]<typename T>(T) -> std::uint32_t { return load<T>(from); });
}

void read_indices(const Elements& elements, std::size_t first, std::span<std::uint32_t> to) {
    by_index_type(elements, [&]<typename T>(T) { read_indices_of<T>(elements, first, to); });
}

std::uint32_t largest_index(const Elements& elements) {
    return by_index_type(elements, [&]<typename T>(T) { return largest_index_of<T>(elements); });
}

const Elements& Accessors::elements(int accessor) {
    const Elements& elements = unchecked(accessor);
    if (!is_finite(accessor))
        refuse(model_.file, pointer("accessors", accessor),
               "element " + std::to_string(*first_not_finite(elements)) +
                   " is not finite; expected finite numbers: mend the model or export it again");
    return elements;
}

bool Accessors::is_finite(int accessor) {
    const auto known = is_finite_.find(accessor);
    if (known != is_finite_.end()) return known->second;
    return is_finite_[accessor] = !first_not_finite(unchecked(accessor));
}

const Elements& Accessors::unchecked(int accessor) {
    if (const auto found = known_.find(accessor); found != known_.end()) return found->second;
    Elements elements = packed(accessor);
    if (at(model_.document.accessors, accessor).sparse.count > 0) elements = with_sparse(accessor, elements);
    if (elements.first == nullptr)
        refuse(model_.file, pointer("accessors", accessor),
               "has neither bufferView nor sparse; its data is missing: export without compression");
    return known_.emplace(accessor, elements).first->second;
}

Elements Accessors::packed(int accessor) const {
    const gltf::Accessor& declared = at(model_.document.accessors, accessor);
    Elements elements{nullptr,
                      0,
                      declared.count,
                      declared.componentType,
                      component_count(declared.type),
                      declared.normalized};
    return declared.bufferView < 0 ? elements : view_of(declared.bufferView, declared.byteOffset, elements);
}

Elements Accessors::view_of(int buffer_view, std::size_t offset, const Elements& type) const {
    const gltf::BufferView& view = at(model_.document.bufferViews, buffer_view);
    const std::span<const unsigned char> bytes = at(model_.document.buffers, view.buffer).data();
    Elements elements = type;
    elements.stride = view.byteStride != 0 ? view.byteStride : element_bytes(type);
    elements.first = bytes.data() + view.byteOffset + offset;
    if (view.byteOffset + offset + elements.stride * (type.count - 1) + element_bytes(type) > bytes.size())
        refuse(model_.file, pointer("bufferViews", buffer_view),
               "its elements run past the buffer's " + std::to_string(bytes.size()) +
                   " bytes; export the file again");
    return elements;
}

Elements Accessors::with_sparse(int accessor, const Elements& base) {
    const auto& sparse = at(model_.document.accessors, accessor).sparse;
    const std::size_t size = element_bytes(base), count = sparse.count;
    written_bytes_ += size * base.count;
    if (written_bytes_ > limits::sparse_bytes)
        refuse(model_.file, pointer("accessors", accessor),
               "sparse accessors need more than " + std::to_string(limits::sparse_bytes) +
                   " bytes written out; export without sparse accessors");
    Bytes& bytes = written_out_.emplace_back(size * base.count, 0);
    for (std::size_t i = 0; base.first != nullptr && i < base.count; ++i)
        std::memcpy(bytes.data() + i * size, base.first + i * base.stride, size);
    const Elements indices = view_of(sparse.indices.bufferView, sparse.indices.byteOffset,
                                     {nullptr, 0, count, sparse.indices.componentType, 1, false});
    Elements values = base;
    values.count = count;
    values = view_of(sparse.values.bufferView, sparse.values.byteOffset, values);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t index = index_at(indices, i);
        if (index >= base.count || (i > 0 && index <= index_at(indices, i - 1)))
            refuse(model_.file, pointer("accessors", accessor, "/sparse/indices"),
                   "index " + std::to_string(index) + " at " + std::to_string(i) +
                       "; expected rising indices below " + std::to_string(base.count));
        std::memcpy(bytes.data() + index * size, values.first + i * values.stride, size);
    }
    Elements result = base;
    result.first = bytes.data();
    result.stride = size;
    return result;
}

namespace {

/// The corners of triangle i (glTF 2.0, 3.7.2.1). A fan's triangle ends in the hub.
glm::uvec3 corners_of(int mode, std::uint32_t i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) return corners_in_strip(i);
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) return {i + 1, i + 2, 0};
    return {3 * i, 3 * i + 1, 3 * i + 2};
}

/// The indices in use, ascending and once each.
std::vector<std::uint32_t> in_use(std::vector<std::uint32_t> indices) {
    std::ranges::sort(indices);
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return indices;
}

}  // namespace

std::uint64_t triangle_count(int mode, std::uint64_t corners) {
    if (mode == TINYGLTF_MODE_TRIANGLES) return corners / 3;
    const bool is_run = mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN;
    return is_run && corners > 2 ? corners - 2 : 0;
}

void Corners::read(std::uint32_t first, std::span<glm::uvec3> to) const {
    if (mode_ == TINYGLTF_MODE_TRIANGLES && indices_ != nullptr && within_used_.empty())
        return read_indices(*indices_, 3 * std::size_t{first}, {&to.data()->x, 3 * to.size()});
    for (std::uint32_t i = 0; i < to.size(); ++i) to[i] = triangle(first + i);
}

glm::uvec3 Corners::triangle(std::uint32_t i) const {
    const glm::uvec3 at = corners_of(mode_, i);
    return {index(at.x), index(at.y), index(at.z)};
}

std::uint32_t Corners::index(std::uint32_t corner) const {
    if (!within_used_.empty()) return within_used_[corner];
    return indices_ == nullptr ? corner : index_at(*indices_, corner);
}

void Unroller::check_indices(int accessor, const Elements& elements, std::uint32_t vertex_count) const {
    // the largest of the type restarts a strip (glTF 2.0, 3.7.2.1)
    const std::uint32_t end =
        std::min(vertex_count, by_index_type(elements, [&]<typename T>(T) -> std::uint32_t {
                     return std::numeric_limits<T>::max();
                 }));
    if (largest_index(elements) < end) return;
    std::size_t bad = 0;
    while (index_at(elements, bad) < end) ++bad;
    refuse(model_.file, "/accessors/" + std::to_string(accessor),
           "index " + std::to_string(index_at(elements, bad)) + " at " + std::to_string(bad) +
               "; expected indices below " + std::to_string(end) +
               (end < vertex_count ? ", the largest of their type" : ", the number of vertices"));
}

Corners Unroller::unroll(const gltf::Primitive& primitive, std::uint32_t vertex_count) {
    Corners corners;
    corners.mode_ = primitive.mode;
    corners.triangles_ = static_cast<std::uint32_t>(zproof::triangle_count(primitive.mode, vertex_count));
    if (primitive.indices < 0) return corners;
    const Elements& elements = accessors_.elements(primitive.indices);
    check_indices(primitive.indices, elements, vertex_count);
    corners.triangles_ = static_cast<std::uint32_t>(zproof::triangle_count(primitive.mode, elements.count));
    corners.indices_ = &elements;
    if (elements.count >= vertex_count) return corners;
    std::vector<std::uint32_t> indices(elements.count);
    read_indices(elements, 0, indices);
    corners.used_ = in_use(indices);
    for (std::uint32_t& index : indices)
        index = static_cast<std::uint32_t>(std::ranges::lower_bound(corners.used_, index) -
                                           corners.used_.begin());
    corners.within_used_ = std::move(indices);
    return corners;
}

}  // namespace zproof
