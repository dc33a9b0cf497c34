#version 450
// The triangle's number in the draw call, into an image of uint32; what is interpolated, into images of four floats.
#ifdef ID_OF_VERTEX
layout(location = 0) flat in uint id_of_vertex;
#else
#define id_of_vertex uint(gl_PrimitiveID)
#endif
layout(location = 0) out uint id;
#ifdef ATTRIBUTES
layout(location = 1) in vec4 bary_uv;
layout(location = 2) in vec3 normal;
layout(location = 3) in vec3 position;
layout(location = 1) out vec4 bary_uv_here;
layout(location = 2) out vec4 normal_here;
layout(location = 3) out vec4 position_here;
#endif

void main() {
    id = id_of_vertex;
#ifdef ATTRIBUTES
    bary_uv_here = bary_uv;
    normal_here = vec4(normal, 0);
    position_here = vec4(position, 0);
#endif
}
