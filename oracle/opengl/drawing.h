/// What the driver holds for us: the program, a scene's triangles, and the planes of pixels of one image. A
/// context must be current wherever these are made, used or destroyed.
#pragma once

#include <GL/glcorearb.h>

#include <utility>

#include "frame/plane.h"
#include "oracle/clip_space.h"
#include "scenes/scene.h"

namespace zproof::oracle::opengl {

/// The name of an object of the driver's, which Free gives back.
template <void (*Free)(GLuint)>
class Owned {
  public:
    explicit Owned(GLuint name) : name_(name) {}
    ~Owned() {
        if (name_ != 0) Free(name_);
    }
    Owned(Owned&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Owned& operator=(Owned&&) = delete;

    GLuint name() const { return name_; }

  private:
    GLuint name_;
};

/// Frees one object that the driver frees by the list.
template <void(APIENTRY* FreeAll)(GLsizei, const GLuint*)>
void free_one(GLuint name) {
    FreeAll(1, &name);
}

using Program = Owned<glDeleteProgram>;
using Buffer = Owned<free_one<glDeleteBuffers>>;
using VertexArray = Owned<free_one<glDeleteVertexArrays>>;
using Renderbuffer = Owned<free_one<glDeleteRenderbuffers>>;
using Framebuffer = Owned<free_one<glDeleteFramebuffers>>;

using Texture2d = Owned<free_one<glDeleteTextures>>;

/// One object made by the driver's list-making function.
GLuint created(void(APIENTRY* create)(GLsizei, GLuint*));

/// Throws OracleError with the driver's log where it does not compile or link.
Program linked_program(const char* vertex_source, const char* fragment_source);

/// Writes gl_PrimitiveID at gl_Position = rows times p_world, all in float32. Throws OracleError with the
/// driver's log where it does not compile.
Program id_program();

/// A scene's triangles in the driver's memory, in scene order.
class Mesh {
  public:
    /// Throws OracleError where there are more triangles than one draw call takes.
    explicit Mesh(const Scene& scene);
    /// All triangles by one call, so that the driver counts primitives as the scene does.
    void draw() const;

  private:
    GLsizei index_count_;
    Buffer position_world_, index_;
    VertexArray layout_;
};

/// One uint32 and one float32 depth per pixel, to draw into and to read back from. Row 0 is the top.
class Target {
  public:
    /// Throws OracleError where the driver's largest image is smaller.
    explicit Target(Resolution size);
    /// Makes this what is drawn into, without an id anywhere and at depth 0.
    void start() const;
    Plane<GLuint> ids() const;
    Plane<float> depths() const;

  private:
    Resolution size_;
    Renderbuffer id_, depth_;
    Framebuffer framebuffer_;
};

/// Draws the mesh into the started target: both faces, nearest stays, nothing blended.
void draw(const Program& program, const Mesh& mesh, const ClipRows& rows);

}  // namespace zproof::oracle::opengl
