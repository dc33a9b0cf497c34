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

/// Where a fragment has the number of its triangle from.
enum class IdSource {
    primitive,  ///< gl_PrimitiveID
    vertex,     ///< vertices that no two triangles share, for drivers whose gl_PrimitiveID is wrong
};

/// Writes the number at gl_Position = rows times p_world, all in float32. Throws OracleError with the
/// driver's log where it does not compile.
Program id_program(IdSource ids);

/// Is there glClipControl? It makes reversed z worth while, and is of OpenGL 4.5.
bool has_clip_control();

/// Which of equal depths stays is the one that is drawn first, or the one that is drawn last. In either case
/// it is to be the scene's first.
enum class DrawOrder { first_first, last_first };

/// A scene's triangles in the driver's memory.
class Mesh {
  public:
    /// Throws OracleError where there are more triangles than one draw call takes.
    Mesh(const Scene& scene, DrawOrder order, IdSource ids);
    /// All triangles by one call, so that the driver counts primitives.
    void draw() const;
    GLint last() const { return last_; }  ///< the scene's last triangle where it is drawn first, else 0

  private:
    GLsizei corner_count_;
    GLint last_;
    bool is_indexed_;
    Buffer position_world_, index_or_id_;
    VertexArray layout_;
};

/// One uint32 and one float32 depth per pixel, to draw into and to read back from. Row 0 is the top.
class Target {
  public:
    /// Throws OracleError where the driver's largest image is smaller.
    explicit Target(Resolution size);
    /// Makes this what is drawn into, without an id anywhere and at this z.
    void start(float farthest_z) const;
    Plane<GLuint> ids() const;
    Plane<float> depths() const;

  private:
    Resolution size_;
    Renderbuffer id_, depth_;
    Framebuffer framebuffer_;
};

/// Draws the mesh into the started target: both faces, nearest stays, nothing blended. The rows are of this
/// z: reversed_z in [0, 1], which needs glClipControl, for a mesh in order; standard_z in [-1, 1] for one
/// that is drawn last first, since what lies as far as nothing does is to be seen.
void draw(const Program& program, const Mesh& mesh, const ClipRows& rows, DepthBuffer z);

}  // namespace zproof::oracle::opengl
