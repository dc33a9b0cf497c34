/// Vulkan as a renderer and a reference: a device of this machine without a surface, Mesa's lavapipe where
/// there is no graphics card.
///
/// All triangles are one draw call, the last one first; the fixed-function rasterizer, clipper and depth test
/// do the rest, as with OpenGL (oracle/opengl.h). Of equal depths the triangle drawn last stays: the one with
/// the smaller id. A view that is sampled beside its pixels' centres is drawn into a multisampled target, of
/// which that sample is read. The loader is opened when it is needed: zproof runs where there is none.
#pragma once

#include <compare>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "frame/precision.h"
#include "oracle/clip_space.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// What tells the fragment shader its triangle.
enum class IdSource {
    as_there_is,  ///< gl_PrimitiveID where the device has geometryShader, else as below
    primitive,    ///< gl_PrimitiveID
    vertex,       ///< a flat output of the vertex shader; no two triangles share a vertex then
};

/// What the device interpolates beside depth.
enum class Values {
    none,
    all,  ///< barycentrics, positions, and the uv and normals that the scene has: as with IdSource::vertex
};

struct VulkanSettings {
    std::string
        device{};  ///< part of its name; empty: graphics cards first, else the first that Vulkan names
    DepthFormat depth_format = DepthFormat::float32;     ///< float32, unorm24 or unorm16
    DepthBuffer depth_buffer = DepthBuffer::reversed_z;  ///< reversed_z or standard_z
    PlanesBy planes = PlanesBy::z;                       ///< distances: with depthClamp
    IdSource ids = IdSource::as_there_is;
    Values attributes = Values::none;

    auto operator<=>(const VulkanSettings&) const = default;
};

/// What a device says of itself (docs/vulkan.md).
struct VulkanDevice {
    std::string version;  ///< its name, driver and version of Vulkan, in one line
    int subpixel_bits;
    int subtexel_bits, mipmap_bits;          ///< of places within a level, and of a blend of two levels
    std::vector<DepthFormat> depth_formats;  ///< of those in VulkanSettings
    std::vector<int> sample_counts;          ///< with ids and depth; more than 1 at standard places only
    int largest_side_px;
};

/// A device at work, for scenes that are drawn once. Copies share it; one view is drawn at a time, and any
/// thread may ask.
class VulkanDriver {
  public:
    /// Throws OracleError where vulkan_is_missing gives a reason.
    explicit VulkanDriver(const VulkanSettings& settings = {});

    /// Renders as Vulkan::render does.
    Frame render(const Scene& scene, const View& view) const;
    /// What Vulkan promises, with the device's limits in it (docs/vulkan.md).
    Precision precision() const;
    /// VulkanDevice's, and the settings that are not the usual ones.
    std::string version() const;

  private:
    friend class Vulkan;
    struct State;
    std::shared_ptr<const State> state_;
};

/// A scene in the device's memory, copied there. Threads as with the driver.
class Vulkan {
  public:
    /// Throws OracleError where there is no device, or in its words where it refuses the scene.
    explicit Vulkan(const Scene& scene, const VulkanDriver& driver = VulkanDriver());
    ~Vulkan();
    Vulkan(Vulkan&&) noexcept;
    Vulkan& operator=(Vulkan&&) noexcept;

    /// Throws OracleError where the image or the number of samples is larger than the device's largest, the
    /// view is sampled at no standard place, or the device reports an error. Pixels are as the device left
    /// them.
    Frame render(const View& view) const;

  private:
    struct Model;
    std::unique_ptr<Model> model_;
};

/// Why Vulkan cannot be asked so, in one line ("Vulkan: not built in", no loader, no such device, a feature
/// that the device lacks); nothing where it can.
std::optional<std::string> vulkan_is_missing(const VulkanSettings& settings = {});

/// All devices, in the order in which they are taken. Throws OracleError where there is no loader.
std::vector<VulkanDevice> vulkan_devices();

}  // namespace zproof::oracle
