#include "filters/commands/filter_choice.h"

#include <gtest/gtest.h>

#include "program/usage_error.h"

namespace zproof {
namespace {

TEST(FilterChoice, IsANameWithSettings) {
    const FilterChoice choice = filter_choice("trilinear-gl:bias=-0.5:mip=box:derivatives=quad:uv=affine");
    EXPECT_EQ(choice.texturing.method.name, "trilinear-gl");
    EXPECT_EQ(choice.texturing.options.lod_bias, -0.5);
    EXPECT_EQ(choice.texturing.options.mip_kernel, texture::MipKernel::box);
    EXPECT_EQ(choice.texturing.derivatives, texture::Derivatives::quad_differences);
    EXPECT_EQ(choice.texturing.uv, rasterizer::UvInterpolation::affine);
    for (const char* word :
         {"neares", "nearest::", "nearest:bias", "nearest:bias=", "nearest:bias=nan", "nearest:bias=1x",
          "nearest:n=0", "nearest:mip=Box", "nearest:lod-min=3:lod-max=2"})
        EXPECT_THROW(filter_choice(word), UsageError) << word;
}

}  // namespace
}  // namespace zproof
