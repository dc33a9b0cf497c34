/// An OpenGL core context, of 3.3 or what the driver has beyond, without a window, and how a thread takes
/// hold of it.
#pragma once

#include <EGL/egl.h>

#include <mutex>
#include <string>

namespace zproof::oracle::opengl {

class Context {
  public:
    /// Throws OracleError with the step at which EGL refused.
    Context();
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Makes the context current on this thread for its own lifetime. Another thread waits meanwhile, so no
    /// other work may be waited for in between.
    class Current {
      public:
        explicit Current(const Context& context);
        ~Current();
        Current(const Current&) = delete;
        Current& operator=(const Current&) = delete;

      private:
        std::scoped_lock<std::mutex> lock_;
        EGLDisplay display_;
    };

  private:
    mutable std::mutex one_thread_;
    EGLDisplay display_;
    EGLContext context_;
};

/// Throws OracleError where OpenGL has recorded an error since it was last asked; `action` says what was
/// done.
void raise_gl_error(const std::string& action);

}  // namespace zproof::oracle::opengl
