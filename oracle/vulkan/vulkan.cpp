#include "oracle/vulkan.h"

#include <tbb/parallel_for.h>

#include <map>
#include <mutex>
#include <utility>

#include "frame/joined.h"
#include "frame/number_text.h"
#include "oracle/oracle_error.h"
#include "oracle/vulkan/device.h"
#include "oracle/vulkan/drawing.h"
#include "oracle/vulkan/id_pipeline.h"
#include "scenes/standard_samples.h"

namespace zproof::oracle {
namespace {

using vulkan::in_one_line;
using vulkan::Pixels;

/// z is that of the farthest where nothing was drawn; background has no depth. Anything else is handed on for
/// the judge to see.
Frame to_frame(Pixels pixels, const Camera& camera, DepthBuffer buffer) {
    const DepthFromZ depth_from(camera, buffer);
    const double farthest_z = buffer == DepthBuffer::reversed_z ? 0 : 1;
    Frame frame(pixels.id.size());
    tbb::parallel_for(0, frame.size().height, [&](int y) {
        for (int x = 0; x < frame.size().width; ++x) {
            const PrimitiveId id{pixels.id.at(x, y)};
            const double z = pixels.z.at(x, y);
            frame.primitive.at(x, y) = id;
            if (id != PrimitiveId::none || z != farthest_z) frame.camera_depth.at(x, y) = depth_from(z);
        }
    });
    frame.attributes = std::move(pixels.attributes);
    return frame;
}

/// Is it one of the standard pattern's, the centre among them?
bool is_standard(const Sample& sample) {
    const std::vector<Sample> pattern = standard_samples(sample.count);
    return std::size_t(sample.index) < pattern.size() &&
           pattern[std::size_t(sample.index)].offset_px == sample.offset_px;
}

}  // namespace

struct VulkanDriver::State {
    explicit State(const VulkanSettings& with)
        : settings(with), device(with), facts(vulkan::facts_of(device.physical())), reader(device) {}

    Pixels draw(const vulkan::Mesh& mesh, const View& view) const {
        require_answerable(view);
        const ClipRows rows = clip_rows(view.camera, {.z = settings.depth_buffer, .planes = settings.planes});
        return vulkan::draw(device, pipeline_for(view.sample.count), reader, mesh, rows,
                            {view.width, view.height}, view.sample.index);
    }

    vulkan::Mesh mesh(const Scene& scene) const { return {device, scene, settings}; }

    VulkanSettings settings;
    mutable std::mutex one_thread;
    vulkan::Device device;
    VulkanDevice facts;
    vulkan::SampleReader reader;

  private:
    /// Throws OracleError.
    void require_answerable(const View& view) const {
        if (view.width > facts.largest_side_px || view.height > facts.largest_side_px)
            throw OracleError("Vulkan: an image of " + size_text(view.width, view.height) +
                              " is larger than the device's largest side, " +
                              std::to_string(facts.largest_side_px) + "; ask for a smaller one");
        const int count = view.sample.count;
        if (!is_standard(view.sample))
            throw OracleError("Vulkan samples pixels at standard places only; expected standard:N for " +
                              sample_word(view.sample));
        if (std::ranges::count(facts.sample_counts, count) == 0)
            throw OracleError("Vulkan: the device has no " + std::to_string(count) +
                              " samples at standard places; it has: " +
                              joined(facts.sample_counts, ", ", [](int n) { return std::to_string(n); }));
        if (count > 1 && settings.depth_format == DepthFormat::unorm24)
            throw OracleError(
                "Vulkan: a depth of 24 bits is read without loss from one sample only; "
                "expected depth_format=float32 or unorm16");
        if (count > 1 && settings.attributes == Values::all)
            throw OracleError("Vulkan: attributes are read from one sample only; expected attributes=none");
    }

    const vulkan::IdPipeline& pipeline_for(int samples) const {
        const auto found = pipelines_.find(samples);
        if (found != pipelines_.end()) return found->second;
        return pipelines_.try_emplace(samples, device, settings, vk::SampleCountFlagBits(samples))
            .first->second;
    }

    mutable std::map<int, vulkan::IdPipeline> pipelines_;  ///< by the number of samples
};

VulkanDriver::VulkanDriver(const VulkanSettings& settings)
    : state_(in_one_line([&] { return std::make_shared<State>(settings); })) {}

/// Threads join in only when the device is free again.
Frame VulkanDriver::render(const Scene& scene, const View& view) const {
    const auto draw = [&] {
        const std::scoped_lock lock(state_->one_thread);
        return in_one_line([&] { return state_->draw(state_->mesh(scene), view); });
    };
    return to_frame(draw(), view.camera, state_->settings.depth_buffer);
}

Precision VulkanDriver::precision() const {
    return RasterPrecision{.origin = Origin::eye,
                           .subpixel_bits = state_->facts.subpixel_bits,
                           .clipping = Clipping::view_volume,
                           .depth_buffer = state_->settings.depth_buffer,
                           .depth_format = state_->settings.depth_format,
                           .depth_rounding = DepthRounding::either,
                           .matrix_far = state_->settings.depth_buffer == DepthBuffer::standard_z
                                             ? MatrixFar::finite
                                             : MatrixFar::infinite,
                           .depth_interpolation = DepthInterpolation::plane,
                           .depth_roundings = 1};
}

std::string VulkanDriver::version() const { return state_->facts.version; }

struct Vulkan::Model {
    Model(const Scene& scene, const VulkanDriver& of)
        : driver(of), mesh([&] {
              const std::scoped_lock lock(of.state_->one_thread);
              return in_one_line([&] { return of.state_->mesh(scene); });
          }()) {}

    Pixels draw(const View& view) const {
        const std::scoped_lock lock(driver.state_->one_thread);
        return in_one_line([&] { return driver.state_->draw(mesh, view); });
    }

    VulkanDriver driver;
    vulkan::Mesh mesh;
};

Vulkan::Vulkan(const Scene& scene, const VulkanDriver& driver)
    : model_(std::make_unique<Model>(scene, driver)) {}
Vulkan::~Vulkan() = default;
Vulkan::Vulkan(Vulkan&&) noexcept = default;
Vulkan& Vulkan::operator=(Vulkan&&) noexcept = default;

Frame Vulkan::render(const View& view) const {
    return to_frame(model_->draw(view), view.camera, model_->driver.state_->settings.depth_buffer);
}

std::optional<std::string> vulkan_is_missing(const VulkanSettings& settings) {
    try {
        const VulkanDriver driver(settings);
        return std::nullopt;
    } catch (const OracleError& e) {
        return e.what();
    }
}

std::vector<VulkanDevice> vulkan_devices() {
    const vk::raii::Context loader = vulkan::opened_loader();
    const vk::raii::Instance instance = vulkan::new_instance(loader);
    return in_one_line([&] {
        std::vector<VulkanDevice> facts;
        for (const vk::raii::PhysicalDevice& device : vulkan::all_devices(instance))
            facts.push_back(vulkan::facts_of(device));
        return facts;
    });
}

}  // namespace zproof::oracle
