#version 450
#extension GL_EXT_samplerless_texture_functions : require
// One sample of every pixel of a multisampled target: its id, and its depth as the bits of a float.
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform utexture2DMS ids;
layout(set = 0, binding = 1) uniform texture2DMS depths;
layout(set = 0, binding = 2, std430) writeonly buffer Ids { uint of_sample_id[]; };
layout(set = 0, binding = 3, std430) writeonly buffer Depths { uint of_sample_z[]; };
layout(push_constant) uniform Which { ivec2 size; int index; } which;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, which.size))) return;
    int at = pixel.y * which.size.x + pixel.x;
    of_sample_id[at] = texelFetch(ids, pixel, which.index).x;
    of_sample_z[at] = floatBitsToUint(texelFetch(depths, pixel, which.index).x);
}
