#include "cli/texture_promises.h"

#include <optional>
#include <stdexcept>

#include "oracle/scratch_folder.h"
#include "oracle/subprocess.h"
#include "oracle/vulkan.h"
#include "program/companion.h"
#include "program/folder_names.h"
#include "program/interrupt.h"

namespace zproof {
namespace {

using Words = std::vector<std::string>;

struct AskedFilter {
    std::string method;          ///< as `zproof filters run` names the device's sampler
    int weight_bits, lod_bits;   ///< of its promise
    std::string other_device{};  ///< which it would ask in place of the one that is meant; empty: none
};

std::optional<AskedFilter> trilinear_of(const RendererChoice& renderer) {
    const auto* known = std::get_if<BuiltIn>(&renderer.who);
    if (known != nullptr && known->name == "opengl") return AskedFilter{"opengl-trilinear", 8, 8};
    if (known == nullptr || known->name != "vulkan") return std::nullopt;
    const oracle::VulkanDevice device = oracle::vulkan_devices().at(0);
    const bool is_meant = device.version.find(known->vulkan.device) != std::string::npos;
    return AskedFilter{"vulkan-trilinear:mip=box", device.subtexel_bits, device.mipmap_bits,
                       is_meant ? "" : device.version};
}

/// What zproof-filters prints. Throws std::runtime_error, in its words, where it did not do so much.
std::string told_by_filters(const Words& words) {
    const auto program = program_of(*companion_named("filters"));
    if (!program) throw std::runtime_error{"zproof-filters is not beside zproof"};
    oracle::Command command{.arguments = {program->string()}};
    command.arguments.insert(command.arguments.end(), words.begin(), words.end());
    command.kept_bytes = std::size_t{1} << 20;
    const oracle::Outcome outcome = oracle::run(command);
    if (interrupted()) throw std::runtime_error{"interrupted"};
    if (outcome.output.empty() || outcome.ending != oracle::Ending::exited)
        throw std::runtime_error{oracle::in_words(outcome, command.time_limit) + "; " + last_output(outcome)};
    return outcome.output;
}

/// The picture of the scene `worked` by the device, judged by the definition.
void judge(TexturePromise& promise, const AskedFilter& asked, const std::string& precision, int threads) {
    const Words view{"worked", "--view", "phi-0", "--threads", std::to_string(threads)};
    const auto told = [&](Words words) {
        words.insert(words.end(), view.begin(), view.end());
        return told_by_filters(words);
    };
    const oracle::ScratchFolder folder;
    const std::filesystem::path study = folder.path() / "study";
    told({"run", "--methods", asked.method, "--flicker", "0", "--quiet", "--out", study.string()});
    const auto picture = study / "pictures" / "worked-phi-0" / (safe_name(asked.method) + ".exr");
    read_filter_check(promise, told({"check", "trilinear-gl:mip=box", "--json", "--picture", picture.string(),
                                     "--precision", precision}));
}

}  // namespace

std::vector<TexturePromise> texture_promises(const RendererChoice& renderer, const CommonArguments& common) {
    const std::optional<AskedFilter> asked = trilinear_of(renderer);
    if (!asked) return {};
    const std::string weights = std::to_string(asked->weight_bits), lod = std::to_string(asked->lod_bits);
    TexturePromise promise{.filter = "trilinear",
                           .promise = "trilinear-gl, weights of " + weights + " bits, LOD of " + lod};
    try {
        if (!asked->other_device.empty())
            throw std::runtime_error{"zproof-filters would ask " + asked->other_device};
        judge(promise, *asked,
              "vulkan-min,arithmetic_bits=53,weight_bits=" + weights + ",tap_bits=" + weights +
                  ",lod_bits=" + lod,
              common.threads);
    } catch (const std::runtime_error& e) {
        promise.refusal = e.what();
    }
    return {promise};
}

}  // namespace zproof
