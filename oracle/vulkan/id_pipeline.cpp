#include "oracle/vulkan/id_pipeline.h"

#include <array>
#include <span>

#include "oracle/vulkan/shaders/fragment_shader.h"
#include "oracle/vulkan/shaders/fragment_shader_with_vertex_id.h"
#include "oracle/vulkan/shaders/vertex_shader.h"
#include "oracle/vulkan/shaders/vertex_shader_with_id.h"

namespace zproof::oracle::vulkan {
namespace {

using Access = vk::AccessFlagBits;
using Stage = vk::PipelineStageFlagBits;

vk::AttachmentDescription attachment(vk::Format format, vk::SampleCountFlagBits samples,
                                     vk::ImageLayout afterwards) {
    return {.format = format,
            .samples = samples,
            .loadOp = vk::AttachmentLoadOp::eClear,
            .storeOp = vk::AttachmentStoreOp::eStore,
            .stencilLoadOp = vk::AttachmentLoadOp::eDontCare,
            .stencilStoreOp = vk::AttachmentStoreOp::eDontCare,
            .initialLayout = vk::ImageLayout::eUndefined,
            .finalLayout = afterwards};
}

/// Clears both images, draws, and leaves them to be copied, or to be read by a shader where they have several
/// samples.
vk::raii::RenderPass new_pass(const Device& device, vk::Format depth, vk::SampleCountFlagBits samples) {
    using Layout = vk::ImageLayout;
    const bool copied = samples == vk::SampleCountFlagBits::e1;
    const std::array attachments{
        attachment(id_format, samples, copied ? Layout::eTransferSrcOptimal : Layout::eShaderReadOnlyOptimal),
        attachment(depth, samples,
                   copied ? Layout::eTransferSrcOptimal : Layout::eDepthStencilReadOnlyOptimal)};
    const vk::AttachmentReference id{0, Layout::eColorAttachmentOptimal},
        z{1, Layout::eDepthStencilAttachmentOptimal};
    const vk::SubpassDescription drawing{.pipelineBindPoint = vk::PipelineBindPoint::eGraphics,
                                         .colorAttachmentCount = 1,
                                         .pColorAttachments = &id,
                                         .pDepthStencilAttachment = &z};
    const vk::SubpassDependency read_afterwards{
        .srcSubpass = 0,
        .dstSubpass = VK_SUBPASS_EXTERNAL,
        .srcStageMask = Stage::eColorAttachmentOutput | Stage::eLateFragmentTests,
        .dstStageMask = Stage::eTransfer | Stage::eComputeShader,
        .srcAccessMask = Access::eColorAttachmentWrite | Access::eDepthStencilAttachmentWrite,
        .dstAccessMask = Access::eTransferRead | Access::eShaderRead};
    return {device.logical(),
            {.attachmentCount = std::uint32_t(attachments.size()),
             .pAttachments = attachments.data(),
             .subpassCount = 1,
             .pSubpasses = &drawing,
             .dependencyCount = 1,
             .pDependencies = &read_afterwards}};
}

vk::raii::PipelineLayout new_layout(const Device& device) {
    const vk::PushConstantRange rows{vk::ShaderStageFlagBits::eVertex, 0, sizeof(ClipRowsPushed)};
    return {device.logical(), {.pushConstantRangeCount = 1, .pPushConstantRanges = &rows}};
}

vk::PipelineShaderStageCreateInfo stage(vk::ShaderStageFlagBits which, const vk::raii::ShaderModule& module) {
    return {.stage = which, .module = *module, .pName = "main"};
}

vk::PipelineDepthStencilStateCreateInfo depth_test(DepthBuffer buffer) {
    return {.depthTestEnable = true,
            .depthWriteEnable = true,
            .depthCompareOp = buffer == DepthBuffer::reversed_z ? vk::CompareOp::eGreaterOrEqual
                                                                : vk::CompareOp::eLessOrEqual};
}

/// All that does not change from one pipeline to the next is said here.
vk::raii::Pipeline new_pipeline(const Device& device, const VulkanSettings& settings,
                                vk::SampleCountFlagBits samples, const vk::raii::RenderPass& pass,
                                const vk::raii::PipelineLayout& layout) {
    const bool of_vertices = ids_are_of_vertices(device, settings);
    const vk::raii::ShaderModule vertex =
        of_vertices ? shader_module(device, vertex_shader_with_id) : shader_module(device, vertex_shader);
    const vk::raii::ShaderModule fragment = of_vertices
                                                ? shader_module(device, fragment_shader_with_vertex_id)
                                                : shader_module(device, fragment_shader);
    const std::array stages{stage(vk::ShaderStageFlagBits::eVertex, vertex),
                            stage(vk::ShaderStageFlagBits::eFragment, fragment)};
    const vk::VertexInputBindingDescription corners{0, sizeof(glm::vec3), vk::VertexInputRate::eVertex};
    const vk::VertexInputAttributeDescription p_world{0, 0, vk::Format::eR32G32B32Sfloat, 0};
    const vk::PipelineVertexInputStateCreateInfo input{.vertexBindingDescriptionCount = 1,
                                                       .pVertexBindingDescriptions = &corners,
                                                       .vertexAttributeDescriptionCount = 1,
                                                       .pVertexAttributeDescriptions = &p_world};
    const vk::PipelineInputAssemblyStateCreateInfo triangles{.topology =
                                                                 vk::PrimitiveTopology::eTriangleList};
    const vk::PipelineViewportStateCreateInfo viewport{.viewportCount = 1, .scissorCount = 1};
    const vk::PipelineRasterizationStateCreateInfo rasterizer{
        .depthClampEnable = settings.planes == PlanesBy::distances,
        .cullMode = vk::CullModeFlagBits::eNone,
        .lineWidth = 1};
    const vk::PipelineMultisampleStateCreateInfo multisample{.rasterizationSamples = samples};
    const vk::PipelineDepthStencilStateCreateInfo depth = depth_test(settings.depth_buffer);
    const vk::PipelineColorBlendAttachmentState red{.colorWriteMask = vk::ColorComponentFlagBits::eR};
    const vk::PipelineColorBlendStateCreateInfo ids{.attachmentCount = 1, .pAttachments = &red};
    constexpr std::array set_later{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic{.dynamicStateCount = std::uint32_t(set_later.size()),
                                                     .pDynamicStates = set_later.data()};
    const vk::GraphicsPipelineCreateInfo all{.stageCount = std::uint32_t(stages.size()),
                                             .pStages = stages.data(),
                                             .pVertexInputState = &input,
                                             .pInputAssemblyState = &triangles,
                                             .pViewportState = &viewport,
                                             .pRasterizationState = &rasterizer,
                                             .pMultisampleState = &multisample,
                                             .pDepthStencilState = &depth,
                                             .pColorBlendState = &ids,
                                             .pDynamicState = &dynamic,
                                             .layout = *layout,
                                             .renderPass = *pass};
    return {device.logical(), nullptr, all};
}

}  // namespace

bool ids_are_of_vertices(const Device& device, const VulkanSettings& settings) {
    if (settings.ids == IdSource::as_there_is) return !device.physical().getFeatures().geometryShader;
    return settings.ids == IdSource::vertex;
}

vk::raii::ShaderModule shader_module(const Device& device, std::span<const std::uint32_t> code) {
    return {device.logical(), {.codeSize = code.size_bytes(), .pCode = code.data()}};
}

IdPipeline::IdPipeline(const Device& device, const VulkanSettings& settings, vk::SampleCountFlagBits samples)
    : samples_(samples),
      depth_format_(format_of(device.physical(), settings.depth_format)),
      farthest_z_(settings.depth_buffer == DepthBuffer::reversed_z ? 0 : 1),
      pass_(new_pass(device, depth_format_, samples)),
      layout_(new_layout(device)),
      pipeline_(new_pipeline(device, settings, samples, pass_, layout_)) {}

void IdPipeline::bind(const vk::raii::CommandBuffer& commands, const vk::Extent2D& size,
                      const ClipRowsPushed& rows) const {
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline_);
    const vk::Viewport viewport{0, 0, float(size.width), float(size.height), 0, 1};
    const vk::Rect2D scissor{{0, 0}, size};
    commands.setViewport(0, viewport);
    commands.setScissor(0, scissor);
    commands.pushConstants<ClipRowsPushed>(*layout_, vk::ShaderStageFlagBits::eVertex, 0, rows);
}

}  // namespace zproof::oracle::vulkan
