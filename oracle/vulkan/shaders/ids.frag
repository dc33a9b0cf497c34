#version 450
// The triangle's number in the draw call, into an image of uint32.
#ifdef ID_OF_VERTEX
layout(location = 0) flat in uint id_of_vertex;
#else
#define id_of_vertex uint(gl_PrimitiveID)
#endif
layout(location = 0) out uint id;
void main() { id = id_of_vertex; }
