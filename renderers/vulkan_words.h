/// How Vulkan is to draw, as typed after its name: vulkan:depth_format=unorm16:depth_buffer=standard_z.
#pragma once

#include <string>
#include <string_view>

#include "oracle/vulkan.h"

namespace zproof {

inline constexpr std::string_view vulkan_name = "vulkan";

/// Is it Vulkan's name, with or without settings?
inline bool names_vulkan(std::string_view word) { return word.substr(0, word.find(':')) == vulkan_name; }

/// ":KEY=VALUE" for each key that is not as usual. docs/vulkan.md has the keys. Throws UsageError.
oracle::VulkanSettings vulkan_settings_from_words(const std::string& words);

/// The same, but for the device. Empty for what is usual.
std::string words_of(const oracle::VulkanSettings& settings);

/// What a device promises, in one line.
std::string promise_in_words(const oracle::VulkanDevice& device);

}  // namespace zproof
