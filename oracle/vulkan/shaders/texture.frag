#version 450
// What the sampler gives for every pixel's place, with the pixel's own steps or those that the device finds.
layout(set = 0, binding = 0) uniform sampler2D image;
layout(set = 0, binding = 1) uniform samplerBuffer place;  // read by helper invocations as well, for the steps
layout(set = 0, binding = 2) uniform samplerBuffer steps;
layout(set = 0, binding = 3, std430) writeonly buffer Colours { vec4 colours[]; };
layout(push_constant) uniform Which { int width; int has_steps; } which;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int at = pixel.y * which.width + pixel.x;
    vec2 uv = texelFetch(place, at).xy;
    vec4 step = texelFetch(steps, at);
    colours[at] = which.has_steps != 0 ? textureGrad(image, uv, step.xy, step.zw) : texture(image, uv);
}
