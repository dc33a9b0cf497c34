// OpenGL 3.3 without a window, ids and float32 depths: a renderer by the contract
// (docs/renderer-contract.md).
//
//   g++ -O2 -std=c++17 -o opengl opengl.cpp -lOpenGL -lEGL
//   zproof contract-check './opengl {scene} {camera} {width} {height} {out}' --precision opengl,origin=eye
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include "zproof_contract.h"

namespace zc = zproof_contract;

constexpr const char* vertex_text = R"(#version 330
uniform mat4 clip_from_eye;
layout(location = 0) in vec3 p_eye;
void main() { gl_Position = clip_from_eye * vec4(p_eye, 1); }
)";
constexpr const char* fragment_text = R"(#version 330
layout(location = 0) out uint id;
void main() { id = uint(gl_PrimitiveID); }
)";

void require(bool is_so, const char* what) {
    if (!is_so) throw std::runtime_error(std::string("OpenGL: ") + what);
}

void make_context() {
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    require(eglInitialize(display, nullptr, nullptr) != 0, "no EGL display without a surface");
    require(eglBindAPI(EGL_OPENGL_API) != 0, "EGL has no OpenGL here");
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    require(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != 0,
            "no context of version 3.3");
}

GLuint shader(GLenum kind, const char* text, GLuint program) {
    const GLuint made = glCreateShader(kind);
    glShaderSource(made, 1, &text, nullptr);
    glCompileShader(made);
    glAttachShader(program, made);
    return made;
}

GLuint renderbuffer(GLenum attachment, GLenum format, const zc::Camera& camera) {
    GLuint made = 0;
    glGenRenderbuffers(1, &made);
    glBindRenderbuffer(GL_RENDERBUFFER, made);
    glRenderbufferStorage(GL_RENDERBUFFER, format, camera.width, camera.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, made);
    return made;
}

/// Its z from -1 at near to 1 at far, as OpenGL clips it, whatever the view's own is.
zc::Camera with_opengl_z(zc::Camera camera) {
    const double near = camera.near, far = camera.far;
    auto& z = camera.clip_from_camera[2];
    if (!camera.perspective)
        z = {0, 0, 2 / (near - far), (near + far) / (near - far)};
    else if (far == zc::infinity)
        z = {0, 0, -1, -2 * near};
    else
        z = {0, 0, (near + far) / (near - far), 2 * near * far / (near - far)};
    return camera;
}

/// By columns, in float32, of positions from which the eye is subtracted: the product is rounded once.
std::vector<float> clip_from_eye(const zc::Camera& camera) {
    std::vector<float> matrix;
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row) {
            double sum = column < 3 ? 0 : camera.clip_from_camera[row][3];
            for (std::size_t k = 0; k < 3 && column < 3; ++k)
                sum += camera.clip_from_camera[row][k] * camera.camera_from_world[k][column];
            matrix.push_back(float(sum));
        }
    return matrix;
}

void draw(const std::vector<zc::Triangle>& triangles, const zc::Camera& camera) {
    std::vector<float> p_eye;
    for (const zc::Triangle& triangle : triangles)
        for (const zc::Vec3& corner : triangle) {
            const zc::Vec3 p = corner - camera.eye;  // far from the origin float32 is coarse
            for (const double x : {p.x, p.y, p.z}) p_eye.push_back(float(x));
        }
    GLuint array = 0, buffer = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(p_eye.size() * sizeof(float)), p_eye.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(0);

    const GLuint program = glCreateProgram();
    shader(GL_VERTEX_SHADER, vertex_text, program);
    shader(GL_FRAGMENT_SHADER, fragment_text, program);
    glLinkProgram(program);
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "clip_from_eye"), 1, GL_FALSE,
                       clip_from_eye(camera).data());
    glViewport(0, 0, camera.width, camera.height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);  // what lies as far as nothing does is drawn
    const GLuint nothing[4] = {zc::background, 0, 0, 0};
    glClearBufferuiv(GL_COLOR, 0, nothing);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(3 * triangles.size()));
}

/// The camera depth of a window z in [0, 1]: both clip coordinates that it came from are affine in camera z.
double depth_of(double window_z, const zc::Camera& camera) {
    const double ndc = 2 * window_z - 1;
    const auto &z = camera.clip_from_camera[2], &w = camera.clip_from_camera[3];
    return (ndc * w[3] - z[3]) / (ndc * w[2] - z[2]);
}

zc::Frame render(const std::vector<zc::Triangle>& triangles, const zc::Camera& given) {
    const zc::Camera camera = with_opengl_z(given);
    make_context();
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    renderbuffer(GL_COLOR_ATTACHMENT0, GL_R32UI, camera);
    renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, camera);
    require(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
            "no framebuffer of R32UI and 32F");
    draw(triangles, camera);

    const std::size_t pixels = std::size_t(camera.width) * std::size_t(camera.height);
    std::vector<std::uint32_t> ids(pixels);
    std::vector<float> window_z(pixels);
    glReadPixels(0, 0, camera.width, camera.height, GL_RED_INTEGER, GL_UNSIGNED_INT, ids.data());
    glReadPixels(0, 0, camera.width, camera.height, GL_DEPTH_COMPONENT, GL_FLOAT, window_z.data());
    require(glGetError() == GL_NO_ERROR, "an error while drawing");

    zc::Frame frame(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const std::size_t at =
                std::size_t(camera.height - 1 - y) * std::size_t(camera.width) + std::size_t(x);
            if (ids[at] != zc::background) frame.set(x, y, ids[at], depth_of(window_z[at], camera));
        }
    return frame;
}

int main(int argc, char** argv) { return zc::run(argc, argv, render); }
