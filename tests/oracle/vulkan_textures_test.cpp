/// A Vulkan device's sampler, by values worked by hand, under Khronos' validation layer.
#include "oracle/vulkan_textures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/oracle/validated_vulkan.h"

namespace zproof::oracle {
namespace {

using VulkanTexturesTest = ValidatedVulkan;

texture::LinearImage level(int width, int height, float value) {
    return {width, height, std::vector<glm::vec4>(std::size_t(width * height), glm::vec4(value))};
}

/// Levels that are told apart by their values: 1, 3 and 5.
VulkanTexture told_apart() { return {.levels = {level(4, 4, 1), level(2, 2, 3), level(1, 1, 5)}}; }

/// 8 x 2 pixels, each so many texels of level 0 beside its neighbours.
TextureLookups steps_of(float texels) {
    const Resolution size{8, 4};
    TextureLookups lookups{Plane<glm::vec4>{size}, Plane<glm::vec4>{size}};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            lookups.place.at(x, y) = glm::vec4(float(x) * texels / 4, float(y) * texels / 4, 1, 0);
            lookups.steps.at(x, y) = glm::vec4(texels / 4, 0, 0, texels / 4);
        }
    return lookups;
}

TEST_F(VulkanTexturesTest, AreReadAtTheLevelOfTheStepsThatAreGivenOrFound) {
    for (const Gradients gradients : {Gradients::given, Gradients::of_the_device})
        for (const auto& [texels, expected] : {std::pair{0.5f, 1.f}, {1.f, 1.f}, {2.f, 3.f}, {4.f, 5.f}}) {
            SCOPED_TRACE(texels);
            const Plane<glm::vec4> colours = vulkan_sampled(told_apart(), steps_of(texels), gradients);
            for (const glm::vec4& colour : colours.pixels()) EXPECT_EQ(colour, glm::vec4(expected));
        }
}

/// The LOD of steps of sqrt(2) texels is 1/2, to the 4 bits that Vulkan asks for at least.
TEST_F(VulkanTexturesTest, AreBlendedBetweenLevels) {
    const Plane<glm::vec4> colours = vulkan_sampled(told_apart(), steps_of(std::sqrt(2.f)), Gradients::given);
    for (const glm::vec4& colour : colours.pixels()) EXPECT_NEAR(colour.r, 2, 2 * (0x1p-4 + 0.087));
}

TEST_F(VulkanTexturesTest, AreAddressedAsAsked) {
    VulkanTexture texture{.levels = {level(2, 1, 0)}};
    texture.levels[0].texels[1] = glm::vec4(1);
    const auto at_the_left = [&](Wrap wrap) {
        texture.wrap_u = wrap;
        return vulkan_sampled(texture, {Plane<glm::vec4>({1, 1}), Plane<glm::vec4>({1, 1})}, Gradients::given)
            .at(0, 0)
            .r;
    };
    EXPECT_EQ(at_the_left(Wrap::repeat), 0.5f);
    EXPECT_EQ(at_the_left(Wrap::clamp_to_edge), 0);
    EXPECT_EQ(at_the_left(Wrap::mirrored_repeat), 0);
}

}  // namespace
}  // namespace zproof::oracle
