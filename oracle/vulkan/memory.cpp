#include "oracle/vulkan/memory.h"

namespace zproof::oracle::vulkan {
namespace {

using Property = vk::MemoryPropertyFlagBits;

}  // namespace

Buffer::Buffer(const Device& device, std::size_t bytes, vk::BufferUsageFlags usage) : byte_count_(bytes) {
    constexpr vk::MemoryPropertyFlags seen = Property::eHostVisible | Property::eHostCoherent;
    buffer_ = {device.logical(), {.size = bytes, .usage = usage}};
    memory_ = device.memory(buffer_.getMemoryRequirements(), {seen | Property::eHostCached, seen});
    buffer_.bindMemory(*memory_, 0);
    bytes_ = memory_.mapMemory(0, bytes);
}

Image::Image(const Device& device, vk::Format format, Resolution size, vk::SampleCountFlagBits samples,
             vk::ImageAspectFlagBits aspect) {
    using Usage = vk::ImageUsageFlagBits;
    const bool is_colour = aspect == vk::ImageAspectFlagBits::eColor;
    const auto read = samples == vk::SampleCountFlagBits::e1 ? Usage::eTransferSrc : Usage::eSampled;
    image_ = {device.logical(),
              {.imageType = vk::ImageType::e2D,
               .format = format,
               .extent = {std::uint32_t(size.width), std::uint32_t(size.height), 1},
               .mipLevels = 1,
               .arrayLayers = 1,
               .samples = samples,
               .usage = (is_colour ? Usage::eColorAttachment : Usage::eDepthStencilAttachment) | read}};
    memory_ = device.memory(image_.getMemoryRequirements(), {Property::eDeviceLocal, {}});
    image_.bindMemory(*memory_, 0);
    view_ = {device.logical(),
             {.image = *image_,
              .viewType = vk::ImageViewType::e2D,
              .format = format,
              .subresourceRange = {aspect, 0, 1, 0, 1}}};
}

}  // namespace zproof::oracle::vulkan
