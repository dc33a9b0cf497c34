/// Stands in where zproof was built without Vulkan.
#include "oracle/oracle_error.h"
#include "oracle/vulkan.h"
#include "oracle/vulkan_textures.h"

namespace zproof::oracle {
namespace {

constexpr const char* vulkan_not_built_in =
    "Vulkan: not built in; install libvulkan-dev and glslang-tools, then configure again";

}  // namespace

struct VulkanDriver::State {};
struct Vulkan::Model {};

VulkanDriver::VulkanDriver(const VulkanSettings&) { throw OracleError(vulkan_not_built_in); }
Frame VulkanDriver::render(const Scene&, const View&) const { throw OracleError(vulkan_not_built_in); }
Precision VulkanDriver::precision() const { throw OracleError(vulkan_not_built_in); }
std::string VulkanDriver::version() const { throw OracleError(vulkan_not_built_in); }

Vulkan::Vulkan(const Scene&, const VulkanDriver&) { throw OracleError(vulkan_not_built_in); }
Vulkan::~Vulkan() = default;
Vulkan::Vulkan(Vulkan&&) noexcept = default;
Vulkan& Vulkan::operator=(Vulkan&&) noexcept = default;
Frame Vulkan::render(const View&) const { throw OracleError(vulkan_not_built_in); }

std::optional<std::string> vulkan_is_missing(const VulkanSettings&) { return vulkan_not_built_in; }
std::vector<VulkanDevice> vulkan_devices() { throw OracleError(vulkan_not_built_in); }

Plane<glm::vec4> vulkan_sampled(const VulkanTexture&, const TextureLookups&, Gradients) {
    throw OracleError(vulkan_not_built_in);
}

}  // namespace zproof::oracle
