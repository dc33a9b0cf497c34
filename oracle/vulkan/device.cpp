#include "oracle/vulkan/device.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "frame/joined.h"

namespace zproof::oracle::vulkan {
namespace {

std::string name_of(const vk::PhysicalDeviceProperties& properties) { return properties.deviceName; }

std::string version_text(std::uint32_t version) {
    return std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
           std::to_string(VK_API_VERSION_MINOR(version)) + "." +
           std::to_string(VK_API_VERSION_PATCH(version));
}

/// "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)"; only from Vulkan 1.2 on does a device say it in words.
std::string driver_text(const vk::raii::PhysicalDevice& device, const vk::PhysicalDeviceProperties& own) {
    if (own.apiVersion < VK_API_VERSION_1_2) return "driver " + std::to_string(own.driverVersion);
    const auto chain =
        device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
    return std::string(driver.driverName) + " " + std::string(driver.driverInfo);
}

/// The sample counts of an image that is drawn into and read back.
vk::SampleCountFlags sample_counts(const vk::raii::PhysicalDevice& device, vk::Format format,
                                   vk::ImageUsageFlagBits drawn) {
    try {
        return device
            .getImageFormatProperties(format, vk::ImageType::e2D, vk::ImageTiling::eOptimal,
                                      drawn | vk::ImageUsageFlagBits::eSampled)
            .sampleCounts;
    } catch (const vk::FormatNotSupportedError&) {
        return vk::SampleCountFlagBits::e1;
    }
}

std::vector<int> sample_counts_of(const vk::raii::PhysicalDevice& device,
                                  const vk::PhysicalDeviceLimits& limits) {
    const vk::SampleCountFlags both =
        sample_counts(device, vk::Format::eR32Uint, vk::ImageUsageFlagBits::eColorAttachment) &
        sample_counts(device, vk::Format::eD32Sfloat, vk::ImageUsageFlagBits::eDepthStencilAttachment);
    std::vector<int> counts{1};
    for (const int count : {2, 4, 8, 16})
        if (limits.standardSampleLocations && (both & vk::SampleCountFlagBits(count)))
            counts.push_back(count);
    return counts;
}

vk::raii::PhysicalDevice chosen_device(const vk::raii::Instance& instance, const std::string& wanted) {
    std::vector<vk::raii::PhysicalDevice> devices = all_devices(instance);
    std::vector<std::string> names;
    for (vk::raii::PhysicalDevice& device : devices) {
        names.push_back(name_of(device.getProperties()));
        if (names.back().find(wanted) != std::string::npos) return std::move(device);
    }
    if (names.empty()) throw OracleError("Vulkan: no device; install a driver, e.g. mesa-vulkan-drivers");
    throw OracleError("Vulkan: no device '" + wanted + "'; expected part of one of: " + joined(names, "; "));
}

/// A queue that draws and computes: where there is one that draws, one does both (Vulkan 1.3, 4.1).
std::uint32_t queue_family_of(const vk::raii::PhysicalDevice& device) {
    constexpr vk::QueueFlags both = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
    const std::vector<vk::QueueFamilyProperties> families = device.getQueueFamilyProperties();
    const auto found =
        std::ranges::find_if(families, [&](const auto& f) { return (f.queueFlags & both) == both; });
    if (found == families.end())
        throw OracleError("Vulkan: the device '" + name_of(device.getProperties()) + "' draws nothing");
    return std::uint32_t(found - families.begin());
}

/// Throws OracleError where the device lacks what is needed.
vk::PhysicalDeviceFeatures features_for(const vk::raii::PhysicalDevice& device,
                                        const VulkanSettings& settings) {
    const vk::PhysicalDeviceFeatures has = device.getFeatures();
    const auto require = [&](bool is_there, const std::string& what) {
        if (is_there) return;
        throw OracleError("Vulkan: the device '" + name_of(device.getProperties()) + "' has no " + what);
    };
    require(has.shaderClipDistance, "shaderClipDistance");
    require(settings.planes != PlanesBy::distances || has.depthClamp, "depthClamp");
    require(settings.ids != IdSource::primitive || has.geometryShader,
            "geometryShader, so no gl_PrimitiveID");
    if (settings.ids == IdSource::primitive && settings.attributes == Values::all)
        throw OracleError("Vulkan: attributes=all needs ids of vertices; expected ids=any or ids=vertex");
    require(format_of(device, settings.depth_format) != vk::Format::eUndefined,
            std::string("depth buffer of ") +
                (settings.depth_format == DepthFormat::unorm24 ? "24 bits" : "that format"));
    return {.fullDrawIndexUint32 = has.fullDrawIndexUint32,
            .geometryShader = has.geometryShader,
            .depthClamp = has.depthClamp,
            .samplerAnisotropy = has.samplerAnisotropy,
            .fragmentStoresAndAtomics = has.fragmentStoresAndAtomics,
            .shaderClipDistance = true};
}

vk::raii::Device new_device(const vk::raii::PhysicalDevice& physical, std::uint32_t queue_family,
                            const VulkanSettings& settings) {
    constexpr float priority = 1;
    const vk::PhysicalDeviceFeatures features = features_for(physical, settings);
    const vk::DeviceQueueCreateInfo queue{
        .queueFamilyIndex = queue_family, .queueCount = 1, .pQueuePriorities = &priority};
    return {physical,
            {.queueCreateInfoCount = 1, .pQueueCreateInfos = &queue, .pEnabledFeatures = &features}};
}

}  // namespace

vk::raii::Context opened_loader() {
    try {
        return {};
    } catch (const std::runtime_error&) {
        throw OracleError("Vulkan: no loader; install libvulkan1 and a driver, e.g. mesa-vulkan-drivers");
    }
}

vk::raii::Instance new_instance(const vk::raii::Context& loader) {
    const vk::ApplicationInfo application{.pApplicationName = "zproof", .apiVersion = VK_API_VERSION_1_2};
    try {
        return {loader, {.pApplicationInfo = &application}};
    } catch (const vk::SystemError& e) {
        throw OracleError(std::string("Vulkan: no instance: ") + e.what() +
                          "; install a driver, e.g. mesa-vulkan-drivers");
    }
}

std::vector<vk::raii::PhysicalDevice> all_devices(const vk::raii::Instance& instance) {
    constexpr std::array cards_first{vk::PhysicalDeviceType::eDiscreteGpu,
                                     vk::PhysicalDeviceType::eIntegratedGpu,
                                     vk::PhysicalDeviceType::eVirtualGpu};
    std::vector<vk::raii::PhysicalDevice> devices = vk::raii::PhysicalDevices(instance);
    std::ranges::stable_sort(devices, {}, [&](const vk::raii::PhysicalDevice& device) {
        return std::ranges::find(cards_first, device.getProperties().deviceType) - cards_first.begin();
    });
    return devices;
}

VulkanDevice facts_of(const vk::raii::PhysicalDevice& device) {
    const vk::PhysicalDeviceProperties own = device.getProperties();
    const vk::PhysicalDeviceLimits& limits = own.limits;
    std::vector<DepthFormat> formats;
    for (const DepthFormat format : {DepthFormat::float32, DepthFormat::unorm24, DepthFormat::unorm16})
        if (format_of(device, format) != vk::Format::eUndefined) formats.push_back(format);
    const std::uint32_t side =
        std::min({limits.maxImageDimension2D, limits.maxFramebufferWidth, limits.maxFramebufferHeight,
                  limits.maxViewportDimensions[0], limits.maxViewportDimensions[1]});
    return {.version =
                name_of(own) + ", " + driver_text(device, own) + ", Vulkan " + version_text(own.apiVersion),
            .subpixel_bits = int(limits.subPixelPrecisionBits),
            .subtexel_bits = int(limits.subTexelPrecisionBits),
            .mipmap_bits = int(limits.mipmapPrecisionBits),
            .depth_formats = formats,
            .sample_counts = sample_counts_of(device, limits),
            .largest_side_px = int(std::min<std::uint32_t>(side, std::numeric_limits<int>::max()))};
}

vk::Format format_of(const vk::raii::PhysicalDevice& device, DepthFormat format) {
    const auto can_be_drawn = [&](vk::Format candidate) {
        return bool(device.getFormatProperties(candidate).optimalTilingFeatures &
                    vk::FormatFeatureFlagBits::eDepthStencilAttachment);
    };
    const auto first_of = [&](std::initializer_list<vk::Format> candidates) {
        const auto found = std::ranges::find_if(candidates, can_be_drawn);
        return found == candidates.end() ? vk::Format::eUndefined : *found;
    };
    switch (format) {
        case DepthFormat::float32:
            return first_of({vk::Format::eD32Sfloat, vk::Format::eD32SfloatS8Uint});
        case DepthFormat::unorm24:
            return first_of({vk::Format::eX8D24UnormPack32, vk::Format::eD24UnormS8Uint});
        case DepthFormat::unorm16:
            return first_of({vk::Format::eD16Unorm});
        default:
            return vk::Format::eUndefined;
    }
}

Device::Device(const VulkanSettings& settings)
    : loader_(opened_loader()),
      instance_(new_instance(loader_)),
      physical_(chosen_device(instance_, settings.device)),
      queue_family_(queue_family_of(physical_)),
      logical_(new_device(physical_, queue_family_, settings)),
      queue_(logical_, queue_family_, 0),
      commands_(logical_, vk::CommandPoolCreateInfo{.queueFamilyIndex = queue_family_}) {}

void Device::run(const std::function<void(const vk::raii::CommandBuffer&)>& record) const {
    const vk::raii::CommandBuffers buffers(logical_, {.commandPool = *commands_, .commandBufferCount = 1});
    const vk::raii::CommandBuffer& commands = buffers.front();
    commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    record(commands);
    commands.end();
    const vk::CommandBuffer recorded = *commands;
    const vk::raii::Fence done(logical_, vk::FenceCreateInfo{});
    const vk::SubmitInfo submitted{.commandBufferCount = 1, .pCommandBuffers = &recorded};
    queue_.submit(submitted, *done);
    while (logical_.waitForFences(*done, true, std::numeric_limits<std::uint64_t>::max()) ==
           vk::Result::eTimeout)
        continue;
}

vk::raii::DeviceMemory Device::memory(const vk::MemoryRequirements& needed,
                                      const std::vector<vk::MemoryPropertyFlags>& kinds) const {
    const vk::PhysicalDeviceMemoryProperties all = physical_.getMemoryProperties();
    for (const vk::MemoryPropertyFlags kind : kinds)
        for (std::uint32_t i = 0; i < all.memoryTypeCount; ++i)
            if ((needed.memoryTypeBits >> i & 1) != 0 && (all.memoryTypes[i].propertyFlags & kind) == kind)
                return {logical_, {.allocationSize = needed.size, .memoryTypeIndex = i}};
    throw OracleError("Vulkan: the device has no memory of the kind that is needed");
}

}  // namespace zproof::oracle::vulkan
