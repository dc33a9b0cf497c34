#include <gmock/gmock.h>

#include <vulkan/vulkan_raii.hpp>

#include "validated_vulkan.h"

namespace zproof::oracle {
namespace {

/// An instance of ours that breaks a rule: a buffer without a byte. Else the layer's silence would say
/// nothing.
TEST(VulkanValidation, IsOn) {
    turn_validation_on();
    testing::internal::CaptureStdout();
    {
        const vk::raii::Context loader;
        const vk::raii::Instance instance(loader, vk::InstanceCreateInfo{});
        const vk::raii::PhysicalDevices devices(instance);
        constexpr float priority = 1;
        const vk::DeviceQueueCreateInfo queue{.queueCount = 1, .pQueuePriorities = &priority};
        const vk::raii::Device device(
            devices.front(), vk::DeviceCreateInfo{.queueCreateInfoCount = 1, .pQueueCreateInfos = &queue});
        const vk::raii::Buffer empty(
            device, vk::BufferCreateInfo{.size = 0, .usage = vk::BufferUsageFlagBits::eTransferSrc});
    }
    EXPECT_THAT(testing::internal::GetCapturedStdout(), testing::HasSubstr("VUID-VkBufferCreateInfo-size"));
}

}  // namespace
}  // namespace zproof::oracle
