/// A Vulkan device, chosen by name, and its queue. Nothing here needs a surface.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "oracle/oracle_error.h"
#include "oracle/vulkan.h"

namespace zproof::oracle::vulkan {

/// Does it, and says in one line what Vulkan refuses meanwhile, as OracleError.
template <class Do>
auto in_one_line(const Do& action) {
    try {
        return action();
    } catch (const vk::SystemError& e) {
        throw OracleError(std::string("Vulkan: the device reports ") + e.what());
    }
}

/// Throws OracleError where there is none.
vk::raii::Context opened_loader();
vk::raii::Instance new_instance(const vk::raii::Context& loader);

/// Graphics cards first, else in Vulkan's order.
std::vector<vk::raii::PhysicalDevice> all_devices(const vk::raii::Instance& instance);

/// What it says of itself.
VulkanDevice facts_of(const vk::raii::PhysicalDevice& device);

/// The device's own format; eUndefined where it has none.
vk::Format format_of(const vk::raii::PhysicalDevice& device, DepthFormat format);

class Device {
  public:
    /// Throws OracleError where there is no such device, or it lacks what the settings ask for.
    explicit Device(const VulkanSettings& settings);

    const vk::raii::PhysicalDevice& physical() const { return physical_; }
    const vk::raii::Device& logical() const { return logical_; }
    /// Does what is recorded, and waits until it is done.
    void run(const std::function<void(const vk::raii::CommandBuffer&)>& record) const;
    /// Memory of the first of these kinds that the device has. Throws OracleError where it has none.
    vk::raii::DeviceMemory memory(const vk::MemoryRequirements& needed,
                                  const std::vector<vk::MemoryPropertyFlags>& kinds) const;

  private:
    vk::raii::Context loader_;
    vk::raii::Instance instance_;
    vk::raii::PhysicalDevice physical_;
    std::uint32_t queue_family_;
    vk::raii::Device logical_;
    vk::raii::Queue queue_;
    vk::raii::CommandPool commands_;
};

}  // namespace zproof::oracle::vulkan
