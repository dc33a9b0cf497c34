// What Mesa's softpipe gives for the number of a primitive and of a vertex (docs/found.md). Without a window.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <cstdio>
#include <string>
#include <vector>

static GLuint shader(GLenum stage, const std::string& text) {
    const GLuint name = glCreateShader(stage);
    const std::string whole = "#version 330 core\n" + text;
    const char* source = whole.c_str();
    glShaderSource(name, 1, &source, nullptr);
    glCompileShader(name);
    return name;
}

/// Draws so many triangles, of which the last covers the one pixel and all others nothing.
static void ask(const char* what, const char* number, int triangles) {
    const GLuint program = glCreateProgram();
    glAttachShader(program,
                   shader(GL_VERTEX_SHADER,
                          "layout(location = 0) in vec2 place; flat out uint vertex;\n"
                          "void main() { vertex = uint(gl_VertexID); gl_Position = vec4(place, 0, 1); }"));
    glAttachShader(program, shader(GL_FRAGMENT_SHADER, std::string("flat in uint vertex; out uint id;\n") +
                                                           "void main() { id = " + number + "; }"));
    glLinkProgram(program);
    glUseProgram(program);
    std::vector<float> places(std::size_t(6 * (triangles - 1)), 9);
    for (const float coordinate : {-1, -1, 3, -1, -1, 3}) places.push_back(coordinate);
    GLuint array, buffer, image, target;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(places.size() * sizeof(float)), places.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(0);
    glGenRenderbuffers(1, &image);
    glBindRenderbuffer(GL_RENDERBUFFER, image);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_R32UI, 1, 1);
    glGenFramebuffers(1, &target);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, image);
    glViewport(0, 0, 1, 1);
    glDrawArrays(GL_TRIANGLES, 0, 3 * triangles);
    GLuint id = 0;
    glReadPixels(0, 0, 1, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, &id);
    std::printf("%s of the last of %d triangles: %u, right is %d\n", what, triangles, id, triangles - 1);
}

int main() {
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    eglInitialize(display, nullptr, nullptr);
    eglBindAPI(EGL_OPENGL_API);
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE,
                   eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted));
    std::printf("%s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    ask("gl_PrimitiveID", "uint(gl_PrimitiveID)", 2);
    ask("gl_VertexID / 3", "vertex / 3u", 1365);
    ask("gl_VertexID / 3", "vertex / 3u", 1366);
}
