#version 450
// World -> clip space, every row in one fixed order and nothing fused: what docs/bounds.md counts roundings of.
layout(location = 0) in vec3 p_world;
layout(push_constant) uniform Rows { vec4 x, y, z, w, near_distance, far_distance, eye_world; } rows;
out gl_PerVertex { vec4 gl_Position; float gl_ClipDistance[2]; };
#ifdef ID_OF_VERTEX
layout(location = 0) flat out uint id;
#endif
#ifdef ATTRIBUTES
layout(location = 1) in vec2 uv;
layout(location = 2) in vec3 normal_world;
layout(location = 1) out vec4 bary_uv;
layout(location = 2) out vec3 normal;
layout(location = 3) out vec3 position;
#endif

float times(vec4 row) {
    precise vec3 p = p_world - rows.eye_world.xyz;
    precise float sum = ((row.x * p.x + row.y * p.y) + row.z * p.z) + row.w;
    return sum;
}

void main() {
    gl_Position = vec4(times(rows.x), times(rows.y), times(rows.z), times(rows.w));
    gl_ClipDistance[0] = times(rows.near_distance);
    gl_ClipDistance[1] = times(rows.far_distance);
#ifdef ID_OF_VERTEX
    id = uint(gl_VertexIndex) / 3u;  // each triangle has three vertices of its own
#endif
#ifdef ATTRIBUTES
    int corner = gl_VertexIndex % 3;
    bary_uv = vec4(corner == 1, corner == 2, uv);
    normal = normal_world;
    position = p_world;
#endif
}
