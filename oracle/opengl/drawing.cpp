#include "oracle/opengl/drawing.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "frame/number_text.h"
#include "oracle/opengl/context.h"
#include "oracle/oracle_error.h"

namespace zproof::oracle::opengl {
namespace {

constexpr GLuint no_id = 0xFFFF'FFFF;

/// Every row in one fixed order, nothing fused: what docs/bounds.md counts roundings of. GLSL 3.30 has no
/// word for that; drivers of OpenGL 4 take it as an extension.
constexpr const char* vertex_source = R"(
#extension GL_ARB_gpu_shader5 : enable
#ifdef GL_ARB_gpu_shader5
#define AS_WRITTEN precise
#else
#define AS_WRITTEN
#endif
layout(location = 0) in vec3 p_world;
layout(location = 1) in uint id_of_vertex;
uniform vec4 x_row, y_row, z_row, w_row, far_row;
uniform vec3 eye_world;
out float gl_ClipDistance[1];
flat out uint vertex_id;
float times(vec4 row) {
    AS_WRITTEN vec3 p = p_world - eye_world;
    AS_WRITTEN float sum = ((row.x * p.x + row.y * p.y) + row.z * p.z) + row.w;
    return sum;
}
void main() {
    gl_Position = vec4(times(x_row), times(y_row), times(z_row), times(w_row));
    gl_ClipDistance[0] = times(far_row);
    vertex_id = id_of_vertex;
})";

/// `last`: the scene's last triangle where it is drawn first, else 0.
constexpr const char* fragment_source = R"(
uniform int last;
flat in uint vertex_id;
layout(location = 0) out uint id;
void main() { id = ID; })";

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

GLsizei corner_count_of(const Scene& scene) {
    if (scene.triangles.size() > std::size_t(std::numeric_limits<GLsizei>::max()) / 3)
        throw OracleError("OpenGL: the scene '" + scene.name + "' has " +
                          std::to_string(scene.triangles.size()) +
                          " triangles, more than one draw call takes; split it");
    return GLsizei(3 * scene.triangles.size());
}

template <class Container>
void fill(GLenum target, const Buffer& buffer, const Container& values) {
    glBindBuffer(target, buffer.name());
    glBufferData(target, GLsizeiptr(values.size() * sizeof(values[0])), values.data(), GL_STATIC_DRAW);
}

/// Three for each triangle.
struct VerticesWithIds {
    std::vector<glm::vec3> position_world;
    std::vector<GLuint> id;
};

VerticesWithIds vertices_with_ids(const Scene& scene, DrawOrder order) {
    VerticesWithIds vertices;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        const std::size_t id = order == DrawOrder::first_first ? i : scene.triangles.size() - 1 - i;
        const glm::uvec3 t = scene.triangles[id];
        for (const std::uint32_t vertex : {t.x, t.y, t.z}) {
            vertices.position_world.push_back(scene.vertices.position_world[vertex]);
            vertices.id.push_back(GLuint(id));
        }
    }
    return vertices;
}

bool has_extension(std::string_view wanted) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i)
        if (wanted == reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, GLuint(i)))) return true;
    return false;
}

void raise_if_too_large(Resolution size) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (size.width > largest || size.height > largest)
        throw OracleError("OpenGL: an image of " + size_text(size.width, size.height) +
                          " is larger than the driver's largest side, " + std::to_string(largest) +
                          "; ask for a smaller one");
}

}  // namespace

GLuint created(void(APIENTRY* create)(GLsizei, GLuint*)) {
    GLuint name = 0;
    create(1, &name);
    return name;
}

Program id_program(IdSource ids) {
    const std::string head = std::string("#version 330 core\n#define ID ") +
                             (ids == IdSource::primitive ? "uint(abs(last - gl_PrimitiveID))" : "vertex_id");
    return linked_program((head + vertex_source).c_str(), (head + fragment_source).c_str());
}

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

bool has_clip_control() {
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    return major > 4 || (major == 4 && minor >= 5) || has_extension("GL_ARB_clip_control");
}

Mesh::Mesh(const Scene& scene, DrawOrder order, IdSource ids)
    : corner_count_(corner_count_of(scene)),
      last_(order == DrawOrder::last_first ? std::max(corner_count_ / 3 - 1, 0) : 0),
      is_indexed_(ids == IdSource::primitive),
      position_world_(created(glGenBuffers)),
      index_or_id_(created(glGenBuffers)),
      layout_(created(glGenVertexArrays)) {
    if (corner_count_ == 0) return;
    glBindVertexArray(layout_.name());
    if (is_indexed_) {
        auto triangles = scene.triangles;
        if (order == DrawOrder::last_first) std::ranges::reverse(triangles);
        fill(GL_ELEMENT_ARRAY_BUFFER, index_or_id_, triangles);
        fill(GL_ARRAY_BUFFER, position_world_, scene.vertices.position_world);
    } else {
        const VerticesWithIds vertices = vertices_with_ids(scene, order);
        fill(GL_ARRAY_BUFFER, index_or_id_, vertices.id);
        glVertexAttribIPointer(1, 1, GL_UNSIGNED_INT, sizeof(GLuint), nullptr);
        glEnableVertexAttribArray(1);
        fill(GL_ARRAY_BUFFER, position_world_, vertices.position_world);
    }
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    glEnableVertexAttribArray(0);
    raise_gl_error("takes over the scene '" + scene.name + "'");
}

void Mesh::draw() const {
    if (corner_count_ == 0) return;
    glBindVertexArray(layout_.name());
    if (is_indexed_)
        glDrawElements(GL_TRIANGLES, corner_count_, GL_UNSIGNED_INT, nullptr);
    else
        glDrawArrays(GL_TRIANGLES, 0, corner_count_);
}

Target::Target(Resolution size)
    : size_(size),
      id_(created(glGenRenderbuffers)),
      depth_(created(glGenRenderbuffers)),
      framebuffer_(created(glGenFramebuffers)) {
    raise_if_too_large(size);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    const auto attach = [&](GLenum place, const Renderbuffer& buffer, GLenum format) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
        glRenderbufferStorage(GL_RENDERBUFFER, format, size.width, size.height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer.name());
    };
    attach(GL_COLOR_ATTACHMENT0, id_, GL_R32UI);
    attach(GL_DEPTH_ATTACHMENT, depth_, GL_DEPTH_COMPONENT32F);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw OracleError("OpenGL: the driver cannot draw uint32 ids with a float32 depth buffer");
    raise_gl_error("makes room for an image");
}

void Target::start(float farthest_z) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, size_.width, size_.height);
    glDepthMask(GL_TRUE);
    glClearBufferuiv(GL_COLOR, 0, &no_id);
    glClearBufferfv(GL_DEPTH, 0, &farthest_z);
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

void draw(const Program& program, const Mesh& mesh, const ClipRows& rows, DepthBuffer z) {
    const bool is_reversed = z == DepthBuffer::reversed_z;
    if (is_reversed) glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glDepthRange(0, 1);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(is_reversed ? GL_GREATER : GL_LEQUAL);
    glEnable(GL_CLIP_DISTANCE0);
    for (const auto off : {GL_CULL_FACE, GL_BLEND, GL_DITHER, GL_MULTISAMPLE}) glDisable(GLenum(off));
    glUseProgram(program.name());
    const auto place = [&](const char* name) { return glGetUniformLocation(program.name(), name); };
    const auto set = [&](const char* name, const glm::vec4& row) {
        glUniform4f(place(name), row.x, row.y, row.z, row.w);
    };
    set("x_row", rows.x);
    set("y_row", is_reversed ? rows.y : -rows.y);  // row 0 is the top
    set("z_row", rows.z);
    set("w_row", rows.w);
    set("far_row", rows.far_distance);
    glUniform3f(place("eye_world"), rows.eye_world.x, rows.eye_world.y, rows.eye_world.z);
    glUniform1i(place("last"), mesh.last());
    mesh.draw();
    raise_gl_error("draws");
}

}  // namespace zproof::oracle::opengl
