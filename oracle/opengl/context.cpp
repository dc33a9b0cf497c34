#include "oracle/opengl/context.h"

#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <array>
#include <string_view>

#include "oracle/oracle_error.h"

namespace zproof::oracle::opengl {
namespace {

std::string in_hex(unsigned code) {
    std::string digits;
    for (; code != 0; code /= 16) digits.insert(digits.begin(), "0123456789ABCDEF"[code % 16]);
    return "0x" + (digits.empty() ? "0" : digits);
}

[[noreturn]] void refuse(const std::string& what) {
    throw OracleError("OpenGL: " + what + " (EGL error " + in_hex(unsigned(eglGetError())) +
                      "); install a driver, e.g. libgl1-mesa-dri");
}

bool egl_has(std::string_view extension) {
    const char* listed = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    return listed && std::string_view(listed).find(extension) != std::string_view::npos;
}

EGLDisplay started(EGLDisplay display) {
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
}

EGLDisplay surfaceless_display() {
    if (!egl_has("EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
    return started(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
}

/// The display of the first device that starts.
EGLDisplay device_display() {
    const auto query_devices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    if (!egl_has("EGL_EXT_platform_device") || !query_devices) return EGL_NO_DISPLAY;
    std::array<EGLDeviceEXT, 16> devices;
    EGLint count = 0;
    if (!query_devices(EGLint(devices.size()), devices.data(), &count)) return EGL_NO_DISPLAY;
    for (EGLint index = 0; index < count; ++index)
        if (const EGLDisplay display =
                started(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(index)], nullptr));
            display != EGL_NO_DISPLAY)
            return display;
    return EGL_NO_DISPLAY;
}

/// A display that needs no window system: Mesa's, or else a device's, as drivers of graphics cards have them.
/// Displays are shared by the whole process and are not ended here.
EGLDisplay windowless_display() {
    for (const auto display_of : {surfaceless_display, device_display})
        if (const EGLDisplay display = display_of(); display != EGL_NO_DISPLAY) return display;
    refuse("no EGL device: neither EGL_MESA_platform_surfaceless nor EGL_EXT_platform_device has a display");
}

EGLContext core_context(EGLDisplay display) {
    if (!eglBindAPI(EGL_OPENGL_API)) refuse("EGL offers no desktop OpenGL");
    constexpr std::array<EGLint, 7> wanted{EGL_CONTEXT_MAJOR_VERSION,
                                           3,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           3,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
    if (context == EGL_NO_CONTEXT) refuse("the driver has no OpenGL 3.3 core context");
    return context;
}

}  // namespace

Context::Context() : display_(windowless_display()), context_(core_context(display_)) {}

Context::~Context() { eglDestroyContext(display_, context_); }

Context::Current::Current(const Context& context) : lock_(context.one_thread_), display_(context.display_) {
    eglBindAPI(EGL_OPENGL_API);  // the bound API is the thread's, not the context's
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context.context_))
        refuse("the context cannot be made current");
}

/// EGL keeps what it knows of a thread until the thread ends; threads that end while the process does (a
/// scheduler's) have been seen to free it a second time. So nothing is left for them.
Context::Current::~Current() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglReleaseThread();
}

void raise_gl_error(const std::string& action) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    while (glGetError() != GL_NO_ERROR) continue;
    throw OracleError("OpenGL: the driver reports error " + in_hex(error) + " when it " + action);
}

}  // namespace zproof::oracle::opengl
