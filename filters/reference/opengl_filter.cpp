#include <utility>

#include "filters/reference/filter_peers.h"
#include "filters/reference/picture_by_sampler.h"
#include "oracle/opengl/context.h"
#include "oracle/opengl/drawing.h"
#include "oracle/oracle_error.h"

namespace zproof::oracle {

namespace {

using opengl::Texture2d;

/// One triangle that covers the image.
constexpr const char* vertex_source = R"(#version 330 core
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); })";

/// `place`: uv and, in z, whether the pixel shows this texture; `steps`: per pixel of x, and of y.
constexpr const char* fragment_source = R"(#version 330 core
uniform sampler2D image, place, steps;
uniform bool has_steps;
layout(location = 0) out vec4 colour;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 at = texelFetch(place, pixel, 0).xyz;
    vec4 step = texelFetch(steps, pixel, 0);
    colour = has_steps ? textureGrad(image, at.xy, step.xy, step.zw) : texture(image, at.xy);
})";

GLint gl_wrap_of(Wrap wrap) {
    if (wrap == Wrap::repeat) return GL_REPEAT;
    return wrap == Wrap::clamp_to_edge ? GL_CLAMP_TO_EDGE : GL_MIRRORED_REPEAT;
}

/// Bound, with the first of its levels filled.
Texture2d bound_texture(int width, int height, const glm::vec4* texels) {
    Texture2d texture{opengl::created(glGenTextures)};
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, texels);
    return texture;
}

/// A texture of one level.
Texture2d plane_texture(const Plane<glm::vec4>& plane) {
    const auto [width, height] = plane.size();
    Texture2d texture = bound_texture(width, height, plane.pixels().data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

Texture2d mipped_texture(const Image& image, const Sampler& sampler, PeerFilter filter,
                         const FilterSettings& settings) {
    const texture::LinearImage linear =
        texture::linear_image({image.width, image.height, image.texels, image.light});
    Texture2d texture = bound_texture(image.width, image.height, linear.texels.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, gl_wrap_of(sampler.wrap_u));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, gl_wrap_of(sampler.wrap_v));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    filter == PeerFilter::bilinear ? GL_LINEAR : GL_LINEAR_MIPMAP_LINEAR);
    if (filter == PeerFilter::anisotropic)
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY, float(settings.max_anisotropy));
    return texture;
}

/// What the sampler gives for every pixel, RGBA; the context must be current.
Plane<glm::vec4> sampled(const opengl::Program& program, const Texture2d& image, const TextureLookups& inputs,
                         StepRule steps) {
    const Resolution size = inputs.place.size();
    const Texture2d place = plane_texture(inputs.place), step = plane_texture(inputs.steps),
                    target = plane_texture(Plane<glm::vec4>{size});
    const opengl::Framebuffer framebuffer{opengl::created(glGenFramebuffers)};
    const opengl::VertexArray nothing{opengl::created(glGenVertexArrays)};
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.name(), 0);
    glViewport(0, 0, size.width, size.height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CLIP_DISTANCE0);
    glUseProgram(program.name());
    const auto set = [&](const char* name, GLint value) {
        glUniform1i(glGetUniformLocation(program.name(), name), value);
    };
    set("has_steps", steps == StepRule::analytic ? 1 : 0);
    const std::array<std::pair<const char*, GLuint>, 3> units{
        {{"image", image.name()}, {"place", place.name()}, {"steps", step.name()}}};
    for (GLint unit = 0; const auto& [name, texture] : units) {
        set(name, unit);
        glActiveTexture(GL_TEXTURE0 + GLenum(unit++));
        glBindTexture(GL_TEXTURE_2D, texture);
    }
    glBindVertexArray(nothing.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    Plane<glm::vec4> colours{size};
    glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_FLOAT, colours.pixels().data());
    opengl::raise_gl_error("filters a texture");
    return colours;
}

}  // namespace

Picture opengl_filtered(const Scene& scene, const View& view, const Frame& frame, const OpenGlFilter& asked,
                        const FilterSettings& settings) {
    const opengl::Context context;
    const opengl::Context::Current current(context);
    const opengl::Program program = opengl::linked_program(vertex_source, fragment_source);
    return picture_by_sampler(
        scene, view, frame, [&](const Image& image, const Sampler& sampler, const TextureLookups& lookups) {
            const Texture2d texture = mipped_texture(image, sampler, asked.filter, settings);
            return sampled(program, texture, lookups, asked.steps);
        });
}

FilterPrecision opengl_filter_precision() {
    return {.coordinate_bits = 24,
            .weight_bits = 8,
            .lod_bits = 8,
            .tap_bits = 8,
            .sum_bits = 24,
            .sum_roundings = 80,
            .colour_bits = 22};
}

}  // namespace zproof::oracle
