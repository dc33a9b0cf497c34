/// What tests of Vulkan take for granted of its layer, its errors and its loader.
#include <gmock/gmock.h>

#include <vulkan/vulkan_raii.hpp>

#include "oracle/vulkan/device.h"
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

TEST(VulkanErrors, ALostDeviceIsOneLine) {
    try {
        vulkan::in_one_line([] { throw vk::DeviceLostError("vk::Queue::submit"); });
        ADD_FAILURE() << "accepted";
    } catch (const OracleError& error) {
        EXPECT_STREQ(error.what(), "Vulkan: the device reports vk::Queue::submit: ErrorDeviceLost");
    }
}

/// The loader is told of a driver that is not there.
TEST(VulkanErrors, NoDriverIsOneLineThatNamesOne) {
    setenv("VK_ICD_FILENAMES", "/nowhere/icd.json", 1);
    EXPECT_THAT(vulkan_is_missing(),
                testing::Optional(testing::HasSubstr("install a driver, e.g. mesa-vulkan-drivers")));
    unsetenv("VK_ICD_FILENAMES");
}

}  // namespace
}  // namespace zproof::oracle
