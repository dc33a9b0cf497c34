#include <algorithm>
#include <array>

#include "oracle/vulkan/id_pipeline.h"
#include "oracle/vulkan/memory.h"
#include "oracle/vulkan/shaders/texture_fragment_shader.h"
#include "oracle/vulkan/shaders/texture_vertex_shader.h"
#include "oracle/vulkan_textures.h"

namespace zproof::oracle {
namespace {

using vulkan::Buffer;
using vulkan::Device;
using Access = vk::AccessFlagBits;
using Kind = vk::DescriptorType;
using Layout = vk::ImageLayout;
using Stage = vk::PipelineStageFlagBits;
using ShaderStage = vk::ShaderStageFlagBits;

constexpr vk::Format texel_format = vk::Format::eR32G32B32A32Sfloat;
constexpr std::array kinds{Kind::eCombinedImageSampler, Kind::eUniformTexelBuffer, Kind::eUniformTexelBuffer,
                           Kind::eStorageBuffer};

/// The push constants of oracle/vulkan/shaders/texture.frag.
struct TextureRead {
    std::int32_t width, has_steps;
};

Buffer buffer_of(const Device& device, std::span<const glm::vec4> values, vk::BufferUsageFlags usage) {
    Buffer buffer(device, values.size_bytes(), usage);
    std::ranges::copy(values, buffer.as<glm::vec4>().begin());
    return buffer;
}

vk::Extent2D extent_of(Resolution size) { return {std::uint32_t(size.width), std::uint32_t(size.height)}; }

/// The levels in the device's memory.
class MippedImage {
  public:
    MippedImage(const Device& device, const std::vector<texture::LinearImage>& levels)
        : levels_{vk::ImageAspectFlagBits::eColor, 0, std::uint32_t(levels.size()), 0, 1} {
        image_ = {device.logical(),
                  {.imageType = vk::ImageType::e2D,
                   .format = texel_format,
                   .extent = {std::uint32_t(levels[0].width), std::uint32_t(levels[0].height), 1},
                   .mipLevels = std::uint32_t(levels.size()),
                   .arrayLayers = 1,
                   .samples = vk::SampleCountFlagBits::e1,
                   .usage = vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst}};
        memory_ =
            device.memory(image_.getMemoryRequirements(), {vk::MemoryPropertyFlagBits::eDeviceLocal, {}});
        image_.bindMemory(*memory_, 0);
        view_ = {device.logical(),
                 {.image = *image_,
                  .viewType = vk::ImageViewType::e2D,
                  .format = texel_format,
                  .subresourceRange = levels_}};
        fill(device, levels);
    }
    const vk::ImageView& view() const { return *view_; }

  private:
    void fill(const Device& device, const std::vector<texture::LinearImage>& levels) const {
        std::vector<glm::vec4> texels;
        std::vector<vk::BufferImageCopy> copies;
        for (const texture::LinearImage& level : levels) {
            copies.push_back({.bufferOffset = texels.size() * sizeof(glm::vec4),
                              .imageSubresource = {levels_.aspectMask, std::uint32_t(copies.size()), 0, 1},
                              .imageExtent = {std::uint32_t(level.width), std::uint32_t(level.height), 1}});
            texels.insert(texels.end(), level.texels.begin(), level.texels.end());
        }
        const Buffer from = buffer_of(device, texels, vk::BufferUsageFlagBits::eTransferSrc);
        device.run([&](const vk::raii::CommandBuffer& commands) {
            turn(commands,
                 {.dstAccessMask = Access::eTransferWrite, .newLayout = Layout::eTransferDstOptimal},
                 Stage::eTopOfPipe, Stage::eTransfer);
            commands.copyBufferToImage(from.handle(), *image_, Layout::eTransferDstOptimal, copies);
            turn(commands,
                 {.srcAccessMask = Access::eTransferWrite,
                  .dstAccessMask = Access::eShaderRead,
                  .oldLayout = Layout::eTransferDstOptimal,
                  .newLayout = Layout::eShaderReadOnlyOptimal},
                 Stage::eTransfer, Stage::eFragmentShader);
        });
    }
    void turn(const vk::raii::CommandBuffer& commands, vk::ImageMemoryBarrier barrier, Stage before,
              Stage after) const {
        barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barrier.image = *image_;
        barrier.subresourceRange = levels_;
        commands.pipelineBarrier(before, after, {}, nullptr, nullptr, barrier);
    }

    vk::ImageSubresourceRange levels_;
    vk::raii::DeviceMemory memory_ = nullptr;  // outlives what lies in it
    vk::raii::Image image_ = nullptr;
    vk::raii::ImageView view_ = nullptr;
};

vk::SamplerAddressMode mode_of(Wrap wrap) {
    if (wrap == Wrap::repeat) return vk::SamplerAddressMode::eRepeat;
    return wrap == Wrap::clamp_to_edge ? vk::SamplerAddressMode::eClampToEdge
                                       : vk::SamplerAddressMode::eMirroredRepeat;
}

vk::raii::Sampler new_sampler(const Device& device, const VulkanTexture& texture) {
    return {device.logical(),
            {.magFilter = vk::Filter::eLinear,
             .minFilter = vk::Filter::eLinear,
             .mipmapMode = vk::SamplerMipmapMode::eLinear,
             .addressModeU = mode_of(texture.wrap_u),
             .addressModeV = mode_of(texture.wrap_v),
             .anisotropyEnable = texture.max_anisotropy > 1,
             .maxAnisotropy = texture.max_anisotropy,
             .maxLod = VK_LOD_CLAMP_NONE}};
}

/// The fixed part: nothing is drawn into, the shader writes into a buffer.
struct Pipeline {
    explicit Pipeline(const Device& device) {
        std::array<vk::DescriptorSetLayoutBinding, kinds.size()> bindings;
        for (std::uint32_t i = 0; i < bindings.size(); ++i)
            bindings[i] = {.binding = i,
                           .descriptorType = kinds[i],
                           .descriptorCount = 1,
                           .stageFlags = ShaderStage::eFragment};
        set = {device.logical(),
               {.bindingCount = std::uint32_t(bindings.size()), .pBindings = bindings.data()}};
        const vk::PushConstantRange read{ShaderStage::eFragment, 0, sizeof(TextureRead)};
        layout = {device.logical(),
                  {.setLayoutCount = 1,
                   .pSetLayouts = &*set,
                   .pushConstantRangeCount = 1,
                   .pPushConstantRanges = &read}};
        const vk::SubpassDescription drawing{.pipelineBindPoint = vk::PipelineBindPoint::eGraphics};
        pass = {device.logical(), {.subpassCount = 1, .pSubpasses = &drawing}};
    }
    /// Draws into an image of this size.
    vk::raii::Pipeline of(const Device& device, const vk::Extent2D& size) const {
        const vk::raii::ShaderModule vertex = shader_module(device, texture_vertex_shader),
                                     fragment = shader_module(device, texture_fragment_shader);
        const std::array stages{vk::PipelineShaderStageCreateInfo{
                                    .stage = ShaderStage::eVertex, .module = *vertex, .pName = "main"},
                                vk::PipelineShaderStageCreateInfo{
                                    .stage = ShaderStage::eFragment, .module = *fragment, .pName = "main"}};
        const vk::PipelineVertexInputStateCreateInfo no_input;
        const vk::PipelineInputAssemblyStateCreateInfo triangles{.topology =
                                                                     vk::PrimitiveTopology::eTriangleList};
        const vk::Viewport viewport{0, 0, float(size.width), float(size.height), 0, 1};
        const vk::Rect2D scissor{{0, 0}, size};
        const vk::PipelineViewportStateCreateInfo whole{
            .viewportCount = 1, .pViewports = &viewport, .scissorCount = 1, .pScissors = &scissor};
        const vk::PipelineRasterizationStateCreateInfo rasterizer{.lineWidth = 1};
        const vk::PipelineMultisampleStateCreateInfo one{.rasterizationSamples = vk::SampleCountFlagBits::e1};
        const vk::GraphicsPipelineCreateInfo all{.stageCount = std::uint32_t(stages.size()),
                                                 .pStages = stages.data(),
                                                 .pVertexInputState = &no_input,
                                                 .pInputAssemblyState = &triangles,
                                                 .pViewportState = &whole,
                                                 .pRasterizationState = &rasterizer,
                                                 .pMultisampleState = &one,
                                                 .layout = *layout,
                                                 .renderPass = *pass};
        return {device.logical(), nullptr, all};
    }

    vk::raii::DescriptorSetLayout set = nullptr;
    vk::raii::PipelineLayout layout = nullptr;
    vk::raii::RenderPass pass = nullptr;
};

/// What the shader reads and writes, by its bindings.
struct Bound {
    Bound(const Device& device, const vk::DescriptorSetLayout& layout, const vk::DescriptorImageInfo& image,
          const std::array<vk::BufferView, 2>& read, const Buffer& written) {
        constexpr std::array sizes{vk::DescriptorPoolSize{Kind::eCombinedImageSampler, 1},
                                   vk::DescriptorPoolSize{Kind::eUniformTexelBuffer, 2},
                                   vk::DescriptorPoolSize{Kind::eStorageBuffer, 1}};
        pool = {device.logical(),
                {.flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                 .maxSets = 1,
                 .poolSizeCount = std::uint32_t(sizes.size()),
                 .pPoolSizes = sizes.data()}};
        sets = {device.logical(), {.descriptorPool = *pool, .descriptorSetCount = 1, .pSetLayouts = &layout}};
        const vk::DescriptorBufferInfo whole{written.handle(), 0, VK_WHOLE_SIZE};
        std::array<vk::WriteDescriptorSet, kinds.size()> writes;
        for (std::uint32_t i = 0; i < writes.size(); ++i)
            writes[i] = {.dstSet = *sets.front(),
                         .dstBinding = i,
                         .descriptorCount = 1,
                         .descriptorType = kinds[i],
                         .pImageInfo = &image,
                         .pBufferInfo = &whole,
                         .pTexelBufferView = i == 2 ? &read[1] : &read[0]};
        device.logical().updateDescriptorSets(writes, nullptr);
    }

    vk::raii::DescriptorPool pool = nullptr;
    vk::raii::DescriptorSets sets = nullptr;
};

void require_texture_unit(const Device& device, const VulkanTexture& texture, std::size_t pixels) {
    const vk::PhysicalDeviceFeatures has = device.physical().getFeatures();
    if (!(device.physical().getFormatProperties(texel_format).optimalTilingFeatures &
          vk::FormatFeatureFlagBits::eSampledImageFilterLinear))
        throw OracleError("Vulkan: the device reads no float32 texture linearly");
    if (pixels > device.physical().getProperties().limits.maxTexelBufferElements)
        throw OracleError("Vulkan: the image has more pixels than the device's largest buffer of texels");
    if (!has.fragmentStoresAndAtomics)
        throw OracleError("Vulkan: the device has no fragmentStoresAndAtomics");
    if (texture.max_anisotropy > 1 && !has.samplerAnisotropy)
        throw OracleError("Vulkan: the device has no samplerAnisotropy");
}

Plane<glm::vec4> sampled(const Device& device, const VulkanTexture& texture, const TextureLookups& lookups,
                         Gradients gradients) {
    require_texture_unit(device, texture, lookups.place.size().pixel_count());
    constexpr auto texels = vk::BufferUsageFlagBits::eUniformTexelBuffer;
    const Resolution size = lookups.place.size();
    const vk::Extent2D extent = extent_of(size);
    const MippedImage image(device, texture.levels);
    const vk::raii::Sampler sampler = new_sampler(device, texture);
    const Buffer place = buffer_of(device, lookups.place.pixels(), texels),
                 steps = buffer_of(device, lookups.steps.pixels(), texels),
                 colours(device, size.pixel_count() * sizeof(glm::vec4),
                         vk::BufferUsageFlagBits::eStorageBuffer);
    const auto view_of = [&](const Buffer& buffer) {
        return vk::raii::BufferView{
            device.logical(), vk::BufferViewCreateInfo{
                                  .buffer = buffer.handle(), .format = texel_format, .range = VK_WHOLE_SIZE}};
    };
    const vk::raii::BufferView places = view_of(place), all_steps = view_of(steps);
    const Pipeline fixed(device);
    const vk::raii::Pipeline pipeline = fixed.of(device, extent);
    const vk::raii::Framebuffer nothing{
        device.logical(),
        {.renderPass = *fixed.pass, .width = extent.width, .height = extent.height, .layers = 1}};
    const Bound bound(device, *fixed.set, {*sampler, image.view(), Layout::eShaderReadOnlyOptimal},
                      {*places, *all_steps}, colours);
    const vk::DescriptorSet set = *bound.sets.front();
    device.run([&](const vk::raii::CommandBuffer& commands) {
        commands.beginRenderPass(
            {.renderPass = *fixed.pass, .framebuffer = *nothing, .renderArea = {{0, 0}, extent}},
            vk::SubpassContents::eInline);
        commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline);
        commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *fixed.layout, 0, set, nullptr);
        commands.pushConstants<TextureRead>(*fixed.layout, ShaderStage::eFragment, 0,
                                            TextureRead{size.width, gradients == Gradients::given ? 1 : 0});
        commands.draw(3, 1, 0, 0);
        commands.endRenderPass();
        const vk::MemoryBarrier seen_here{.srcAccessMask = Access::eShaderWrite,
                                          .dstAccessMask = Access::eHostRead};
        commands.pipelineBarrier(Stage::eFragmentShader, Stage::eHost, {}, seen_here, nullptr, nullptr);
    });
    Plane<glm::vec4> all{size};
    std::ranges::copy(colours.as<glm::vec4>(), all.pixels().begin());
    return all;
}

}  // namespace

Plane<glm::vec4> vulkan_sampled(const VulkanTexture& texture, const TextureLookups& lookups,
                                Gradients gradients) {
    return vulkan::in_one_line([&] { return sampled(Device({}), texture, lookups, gradients); });
}

}  // namespace zproof::oracle
