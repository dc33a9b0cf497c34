/// What lies in a device's memory: bytes that the program sees as well, and images that only the device sees.
#pragma once

#include <cstdint>
#include <span>
#include <vulkan/vulkan_raii.hpp>

#include "frame/plane.h"
#include "oracle/vulkan/device.h"

namespace zproof::oracle::vulkan {

class Buffer {
  public:
    /// Its values are not set. Throws what Device::memory() throws.
    Buffer(const Device& device, std::size_t bytes, vk::BufferUsageFlags usage);
    const vk::Buffer& handle() const { return *buffer_; }
    /// As so many values of a kind as there is room for.
    template <class T>
    std::span<T> as() const {
        return {static_cast<T*>(bytes_), byte_count_ / sizeof(T)};
    }

  private:
    std::size_t byte_count_;
    vk::raii::DeviceMemory memory_ = nullptr;  // outlives what lies in it
    vk::raii::Buffer buffer_ = nullptr;
    void* bytes_ = nullptr;
};

/// One value per sample of each pixel.
class Image {
  public:
    /// `aspect` is what is looked at: colour, or depth.
    Image(const Device& device, vk::Format format, Resolution size, vk::SampleCountFlagBits samples,
          vk::ImageAspectFlagBits aspect);
    const vk::Image& handle() const { return *image_; }
    const vk::ImageView& view() const { return *view_; }

  private:
    vk::raii::DeviceMemory memory_ = nullptr;  // outlives what lies in it
    vk::raii::Image image_ = nullptr;
    vk::raii::ImageView view_ = nullptr;
};

}  // namespace zproof::oracle::vulkan
