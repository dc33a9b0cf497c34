#include "oracle/opengl/drawing.h"

#include <algorithm>
#include <limits>
#include <string>

#include "oracle/opengl/context.h"
#include "oracle/oracle_error.h"

namespace zproof::oracle::opengl {
namespace {

constexpr GLuint no_id = 0xFFFF'FFFF;

/// Every row in one fixed order, nothing fused: what docs/bounds.md counts roundings of.
constexpr const char* vertex_source = R"(#version 450 core
layout(location = 0) in vec3 p_world;
layout(location = 0) uniform vec4 x_row;
layout(location = 1) uniform vec4 y_row;
layout(location = 2) uniform vec4 z_row;
layout(location = 3) uniform vec4 w_row;
layout(location = 4) uniform vec4 far_row;
layout(location = 5) uniform vec3 eye_world;
out gl_PerVertex { vec4 gl_Position; float gl_ClipDistance[1]; };
float times(vec4 row) {
    precise vec3 p = p_world - eye_world;
    precise float sum = ((row.x * p.x + row.y * p.y) + row.z * p.z) + row.w;
    return sum;
}
void main() {
    gl_Position = vec4(times(x_row), times(y_row), times(z_row), times(w_row));
    gl_ClipDistance[0] = times(far_row);
})";

constexpr const char* fragment_source = R"(#version 450 core
layout(location = 0) out uint id;
void main() { id = uint(gl_PrimitiveID); })";

using Shader = Owned<glDeleteShader>;

/// What the driver says of a shader or program, by its pair of asking functions.
template <class GetLength, class GetLog>
std::string log_of(GLuint name, GetLength get_length, GetLog get_log) {
    GLint length = 0;
    get_length(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(std::max(length, 1)), ' ');
    get_log(name, GLsizei(log.size()), nullptr, log.data());
    return log;
}

Shader compiled(GLenum stage, const char* source) {
    Shader shader(glCreateShader(stage));
    glShaderSource(shader.name(), 1, &source, nullptr);
    glCompileShader(shader.name());
    GLint done = 0;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &done);
    if (!done)
        throw OracleError("OpenGL: the driver refuses our shader: " +
                          log_of(shader.name(), glGetShaderiv, glGetShaderInfoLog));
    return shader;
}

GLsizei index_count_of(const Scene& scene) {
    if (scene.triangles.size() > std::size_t(std::numeric_limits<GLsizei>::max()) / 3)
        throw OracleError("OpenGL: the scene '" + scene.name + "' has " +
                          std::to_string(scene.triangles.size()) +
                          " triangles, more than one draw call takes; split it");
    return GLsizei(3 * scene.triangles.size());
}

template <class Container>
void fill(const Buffer& buffer, const Container& values) {
    glNamedBufferStorage(buffer.name(), GLsizeiptr(values.size() * sizeof(values[0])), values.data(), 0);
}

void set_row(GLint location, const glm::vec4& row) { glUniform4f(location, row.x, row.y, row.z, row.w); }

void raise_if_too_large(Resolution size) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (size.width > largest || size.height > largest)
        throw OracleError("OpenGL: an image of " + std::to_string(size.width) + " x " +
                          std::to_string(size.height) + " is larger than the driver's largest side, " +
                          std::to_string(largest) + "; ask for a smaller one");
}

}  // namespace

GLuint created(void(APIENTRY* create)(GLsizei, GLuint*)) {
    GLuint name = 0;
    create(1, &name);
    return name;
}

Program id_program() { return linked_program(vertex_source, fragment_source); }

Program linked_program(const char* of_vertex, const char* of_fragment) {
    const Shader vertex = compiled(GL_VERTEX_SHADER, of_vertex);
    const Shader fragment = compiled(GL_FRAGMENT_SHADER, of_fragment);
    Program program(glCreateProgram());
    glAttachShader(program.name(), vertex.name());
    glAttachShader(program.name(), fragment.name());
    glLinkProgram(program.name());
    GLint done = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &done);
    if (!done)
        throw OracleError("OpenGL: the driver cannot link our program: " +
                          log_of(program.name(), glGetProgramiv, glGetProgramInfoLog));
    return program;
}

Mesh::Mesh(const Scene& scene)
    : index_count_(index_count_of(scene)),
      position_world_(created(glCreateBuffers)),
      index_(created(glCreateBuffers)),
      layout_(created(glCreateVertexArrays)) {
    if (index_count_ == 0) return;
    fill(position_world_, scene.vertices.position_world);
    fill(index_, scene.triangles);
    glVertexArrayVertexBuffer(layout_.name(), 0, position_world_.name(), 0, sizeof(glm::vec3));
    glVertexArrayElementBuffer(layout_.name(), index_.name());
    glVertexArrayAttribFormat(layout_.name(), 0, 3, GL_FLOAT, GL_FALSE, 0);
    glEnableVertexArrayAttrib(layout_.name(), 0);
    raise_gl_error("takes over the scene '" + scene.name + "'");
}

void Mesh::draw() const {
    if (index_count_ == 0) return;
    glBindVertexArray(layout_.name());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

Target::Target(Resolution size)
    : size_(size),
      id_(created(glCreateRenderbuffers)),
      depth_(created(glCreateRenderbuffers)),
      framebuffer_(created(glCreateFramebuffers)) {
    raise_if_too_large(size);
    const GLuint framebuffer = framebuffer_.name();
    glNamedRenderbufferStorage(id_.name(), GL_R32UI, size.width, size.height);
    glNamedRenderbufferStorage(depth_.name(), GL_DEPTH_COMPONENT32F, size.width, size.height);
    glNamedFramebufferRenderbuffer(framebuffer, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, id_.name());
    glNamedFramebufferRenderbuffer(framebuffer, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    if (glCheckNamedFramebufferStatus(framebuffer, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw OracleError("OpenGL: the driver cannot draw uint32 ids with a float32 depth buffer");
    raise_gl_error("makes room for an image");
}

void Target::start() const {
    constexpr float farthest = 0;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, size_.width, size_.height);
    glDepthMask(GL_TRUE);
    glClearNamedFramebufferuiv(framebuffer_.name(), GL_COLOR, 0, &no_id);
    glClearNamedFramebufferfv(framebuffer_.name(), GL_DEPTH, 0, &farthest);
}

Plane<GLuint> Target::ids() const {
    Plane<GLuint> ids(size_);
    glReadPixels(0, 0, size_.width, size_.height, GL_RED_INTEGER, GL_UNSIGNED_INT, ids.pixels().data());
    return ids;
}

Plane<float> Target::depths() const {
    Plane<float> depths(size_);
    glReadPixels(0, 0, size_.width, size_.height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.pixels().data());
    return depths;
}

void draw(const Program& program, const Mesh& mesh, const ClipRows& rows) {
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glDepthRange(0, 1);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glEnable(GL_CLIP_DISTANCE0);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDisable(GL_DITHER);
    glDisable(GL_MULTISAMPLE);
    glUseProgram(program.name());
    set_row(0, rows.x);
    set_row(1, rows.y);
    set_row(2, rows.z);
    set_row(3, rows.w);
    set_row(4, rows.far_distance);
    glUniform3f(5, rows.eye_world.x, rows.eye_world.y, rows.eye_world.z);
    mesh.draw();
    raise_gl_error("draws");
}

}  // namespace zproof::oracle::opengl
