#include "oracle/vulkan/drawing.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace zproof::oracle::vulkan {
namespace {

constexpr std::uint32_t no_id = 0xFFFF'FFFF;

std::uint32_t checked_index_count(const Device& device, const Scene& scene, bool own_vertices) {
    const std::size_t count = 3 * scene.triangles.size();
    const std::size_t largest = own_vertices ? count : scene.vertices.position_world.size();
    const std::uint32_t allowed = device.physical().getProperties().limits.maxDrawIndexedIndexValue;
    if (count < std::numeric_limits<std::uint32_t>::max() && largest <= allowed) return std::uint32_t(count);
    throw OracleError("Vulkan: the scene '" + scene.name + "' has " + std::to_string(scene.triangles.size()) +
                      " triangles, more than one draw call takes; split it");
}

template <class Values>
Buffer filled(const Device& device, const Values& values, vk::BufferUsageFlagBits usage) {
    using Value = std::decay_t<decltype(values[0])>;
    Buffer buffer(device, std::max<std::size_t>(1, values.size()) * sizeof(Value), usage);
    std::ranges::copy(values, buffer.as<Value>().begin());
    return buffer;
}

/// The last triangle first: the depth test keeps the one that is drawn last of equal depths, so that what
/// lies as far as nothing does is still drawn.
std::vector<glm::uvec3> last_first(const Scene& scene) {
    return {scene.triangles.rbegin(), scene.triangles.rend()};
}

std::vector<glm::vec3> corners_last_first(const Scene& scene) {
    std::vector<glm::vec3> corners;
    corners.reserve(3 * scene.triangles.size());
    for (const glm::uvec3& triangle : last_first(scene))
        for (int i = 0; i < 3; ++i) corners.push_back(scene.vertices.position_world[triangle[i]]);
    return corners;
}

/// 0 where the scene has no such values.
std::vector<VertexValues> values_last_first(const Scene& scene) {
    const Vertices& v = scene.vertices;
    std::vector<VertexValues> corners;
    corners.reserve(3 * scene.triangles.size());
    for (const glm::uvec3& triangle : last_first(scene))
        for (int i = 0; i < 3; ++i)
            corners.push_back({v.position_world[triangle[i]],
                               v.uv.empty() ? glm::vec2(0) : v.uv.front()[triangle[i]],
                               v.normal_world.empty() ? glm::vec3(0) : v.normal_world[triangle[i]]});
    return corners;
}

std::vector<Attribute> attributes_of(const Scene& scene) {
    std::vector<Attribute> all{Attribute::barycentrics, Attribute::position};
    if (!scene.vertices.uv.empty()) all.push_back(Attribute::uv);
    if (!scene.vertices.normal_world.empty()) all.push_back(Attribute::normal);
    return all;
}

Buffer new_vertices(const Device& device, const Scene& scene, bool own_vertices, Values values) {
    constexpr auto usage = vk::BufferUsageFlagBits::eVertexBuffer;
    if (values == Values::all) return filled(device, values_last_first(scene), usage);
    return own_vertices ? filled(device, corners_last_first(scene), usage)
                        : filled(device, scene.vertices.position_world, usage);
}

Buffer new_indices(const Device& device, const Scene& scene, bool own_vertices) {
    constexpr auto usage = vk::BufferUsageFlagBits::eIndexBuffer;
    if (!own_vertices) return filled(device, last_first(scene), usage);
    std::vector<std::uint32_t> counted(3 * scene.triangles.size());
    std::iota(counted.begin(), counted.end(), 0);
    return filled(device, counted, usage);
}

/// Clip space has y up, Vulkan's has y down.
ClipRowsPushed pushed(const ClipRows& rows) {
    return {.x = rows.x,
            .y = -rows.y,
            .z = rows.z,
            .w = rows.w,
            .near_distance = rows.near_distance,
            .far_distance = rows.far_distance,
            .eye_world = glm::vec4(rows.eye_world, 0)};
}

/// What is drawn into.
struct Target {
    Target(const Device& device, const IdPipeline& pipeline, Resolution size)
        : id(device, id_format, size, pipeline.samples(), vk::ImageAspectFlagBits::eColor),
          depth(device, pipeline.depth_format(), size, pipeline.samples(), vk::ImageAspectFlagBits::eDepth),
          framebuffer(nullptr) {
        std::vector views{depth.view(), id.view()};
        for (int i = 0; i < pipeline.values(); ++i)
            views.push_back(values
                                .emplace_back(device, value_format, size, pipeline.samples(),
                                              vk::ImageAspectFlagBits::eColor)
                                .view());
        framebuffer = {device.logical(),
                       {.renderPass = pipeline.pass(),
                        .attachmentCount = std::uint32_t(views.size()),
                        .pAttachments = views.data(),
                        .width = std::uint32_t(size.width),
                        .height = std::uint32_t(size.height),
                        .layers = 1}};
    }

    Image id, depth;
    std::vector<Image> values;
    vk::raii::Framebuffer framebuffer;
};

void record_drawing(const vk::raii::CommandBuffer& commands, const IdPipeline& pipeline, const Target& target,
                    const Mesh& mesh, const ClipRows& rows, const vk::Extent2D& size) {
    std::vector<vk::ClearValue> nothing(2 + target.values.size());
    nothing[0].depthStencil = vk::ClearDepthStencilValue{pipeline.farthest_z(), 0};
    nothing[1].color = vk::ClearColorValue(std::array<std::uint32_t, 4>{no_id, 0, 0, 0});
    const vk::RenderPassBeginInfo begin{.renderPass = pipeline.pass(),
                                        .framebuffer = *target.framebuffer,
                                        .renderArea = {{0, 0}, size},
                                        .clearValueCount = std::uint32_t(nothing.size()),
                                        .pClearValues = nothing.data()};
    commands.beginRenderPass(begin, vk::SubpassContents::eInline);
    pipeline.bind(commands, size, pushed(rows));
    mesh.draw(commands);
    commands.endRenderPass();
}

/// Values of 32 bits, or four of them; depths of 16 bits where the format has no more.
void record_copy(const vk::raii::CommandBuffer& commands, const Image& image, vk::ImageAspectFlagBits aspect,
                 const vk::Extent2D& size, const Buffer& into) {
    const vk::BufferImageCopy all{.imageSubresource = {aspect, 0, 0, 1},
                                  .imageExtent = {size.width, size.height, 1}};
    commands.copyImageToBuffer(image.handle(), vk::ImageLayout::eTransferSrcOptimal, into.handle(), all);
}

void record_end(const vk::raii::CommandBuffer& commands) {
    const vk::MemoryBarrier seen_here{
        .srcAccessMask = vk::AccessFlagBits::eTransferWrite | vk::AccessFlagBits::eShaderWrite,
        .dstAccessMask = vk::AccessFlagBits::eHostRead};
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eTransfer | vk::PipelineStageFlagBits::eComputeShader,
                             vk::PipelineStageFlagBits::eHost, {}, seen_here, nullptr, nullptr);
}

/// z of what was copied.
double z_of_texel(const Buffer& texels, vk::Format format, std::size_t at) {
    switch (format) {
        case vk::Format::eD16Unorm:
            return texels.as<std::uint16_t>()[at] / double(0xFFFF);
        case vk::Format::eX8D24UnormPack32:
        case vk::Format::eD24UnormS8Uint:
            return (texels.as<std::uint32_t>()[at] & 0xFF'FFFF) / double(0xFF'FFFF);
        default:
            return std::bit_cast<float>(texels.as<std::uint32_t>()[at]);
    }
}

/// z of what a shader has read: a float made of the format's value.
double z_of_sample(const Buffer& samples, vk::Format format, std::size_t at) {
    const double z = std::bit_cast<float>(samples.as<std::uint32_t>()[at]);
    return format == vk::Format::eD16Unorm ? std::nearbyint(z * 0xFFFF) / 0xFFFF : z;
}

/// Which of the images of values has the channel, and where in its four floats: attribute_channels in their
/// order, no attribute in two images.
struct ChannelPlace {
    std::size_t image, component;
};
constexpr std::array<ChannelPlace, attribute_channels.size()> channel_places{
    {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {1, 0}, {1, 1}, {1, 2}, {2, 0}, {2, 1}, {2, 2}}};

Attributes attributes_from(const std::vector<Buffer>& values, const Mesh& mesh, Resolution size) {
    Attributes attributes;
    if (values.empty()) return attributes;
    for (std::size_t c = 0; c < attribute_channels.size(); ++c) {
        if (std::ranges::count(mesh.attributes(), attribute_channels[c].attribute) == 0) continue;
        const auto [image, component] = channel_places[c];
        const std::span<const glm::vec4> texels = values[image].as<glm::vec4>();
        attributes.planes[c] = Plane<float>::unwritten(size);
        std::ranges::transform(texels, attributes.planes[c].pixels().begin(),
                               [&](const glm::vec4& texel) { return texel[int(component)]; });
    }
    return attributes;
}

}  // namespace

Mesh::Mesh(const Device& device, const Scene& scene, const VulkanSettings& settings)
    : Mesh(device, scene, ids_are_of_vertices(device, settings), settings.attributes) {}

Mesh::Mesh(const Device& device, const Scene& scene, bool own_vertices, Values values)
    : index_count_(checked_index_count(device, scene, own_vertices)),
      attributes_(attributes_of(scene)),
      vertices_(new_vertices(device, scene, own_vertices, values)),
      index_(new_indices(device, scene, own_vertices)) {}

void Mesh::draw(const vk::raii::CommandBuffer& commands) const {
    if (index_count_ == 0) return;
    constexpr vk::DeviceSize from_its_beginning = 0;
    commands.bindVertexBuffers(0, vertices_.handle(), from_its_beginning);
    commands.bindIndexBuffer(index_.handle(), 0, vk::IndexType::eUint32);
    commands.drawIndexed(index_count_, 1, 0, 0, 0);
}

Pixels draw(const Device& device, const IdPipeline& pipeline, const SampleReader& reader, const Mesh& mesh,
            const ClipRows& rows, Resolution size, int index) {
    using Usage = vk::BufferUsageFlagBits;
    const bool copied = pipeline.samples() == vk::SampleCountFlagBits::e1;
    const Target target(device, pipeline, size);
    const auto new_buffer = [&](std::size_t bytes_per_pixel) {
        return Buffer(device, size.pixel_count() * bytes_per_pixel,
                      copied ? Usage::eTransferDst : Usage::eStorageBuffer);
    };
    const Buffer ids = new_buffer(sizeof(std::uint32_t)), depths = new_buffer(sizeof(std::uint32_t));
    std::vector<Buffer> values;
    while (values.size() < target.values.size()) values.push_back(new_buffer(sizeof(glm::vec4)));
    if (!copied) reader.bind(device, target.id, target.depth, ids, depths);
    const vk::Extent2D extent{std::uint32_t(size.width), std::uint32_t(size.height)};
    device.run([&](const vk::raii::CommandBuffer& commands) {
        record_drawing(commands, pipeline, target, mesh, rows, extent);
        if (copied) {
            record_copy(commands, target.id, vk::ImageAspectFlagBits::eColor, extent, ids);
            record_copy(commands, target.depth, vk::ImageAspectFlagBits::eDepth, extent, depths);
            for (std::size_t i = 0; i < values.size(); ++i)
                record_copy(commands, target.values[i], vk::ImageAspectFlagBits::eColor, extent, values[i]);
        } else {
            reader.read(commands, size, index);
        }
        record_end(commands);
    });
    Pixels pixels{Plane<std::uint32_t>::unwritten(size), Plane<double>::unwritten(size)};
    std::ranges::transform(ids.as<std::uint32_t>(), pixels.id.pixels().begin(),
                           [&](std::uint32_t id) { return id == no_id ? no_id : mesh.triangle(id); });
    const auto z_at = copied ? z_of_texel : z_of_sample;
    for (std::size_t i = 0; i < size.pixel_count(); ++i)
        pixels.z.pixels()[i] = z_at(depths, pipeline.depth_format(), i);
    pixels.attributes = attributes_from(values, mesh, size);
    return pixels;
}

}  // namespace zproof::oracle::vulkan
