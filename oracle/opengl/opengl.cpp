#include "oracle/opengl.h"

#include <tbb/parallel_for.h>

#include "oracle/centre_only.h"
#include "oracle/clip_space.h"
#include "oracle/opengl/context.h"
#include "oracle/opengl/drawing.h"
#include "oracle/oracle_error.h"

namespace zproof::oracle {
namespace {

using opengl::Context;

/// What the driver says of one of its names.
std::string words_of(GLenum name) {
    const GLubyte* words = glGetString(name);
    std::string text;
    for (; words != nullptr && *words != 0; ++words) text += static_cast<char>(*words);
    return text;
}

struct Pixels {
    Plane<GLuint> id;
    Plane<float> z;
};

/// The z of a cleared buffer.
float farthest(DepthBuffer z) { return z == DepthBuffer::reversed_z ? 0 : 1; }

/// Background has no depth, and z as it was cleared. Anything else is handed on for the judge to see.
Frame to_frame(const Pixels& pixels, const Camera& camera, DepthBuffer buffer) {
    const DepthFromZ depth_from(camera, buffer);
    Frame frame(pixels.id.size());
    tbb::parallel_for(0, frame.size().height, [&](int y) {
        for (int x = 0; x < frame.size().width; ++x) {
            const PrimitiveId id{pixels.id.at(x, y)};
            const float z = pixels.z.at(x, y);
            frame.primitive.at(x, y) = id;
            if (id != PrimitiveId::none || z != farthest(buffer)) frame.camera_depth.at(x, y) = depth_from(z);
        }
    });
    return frame;
}

}  // namespace

struct OpenGlDriver::State {
    State() {
        const Context::Current current(context);
        if (!opengl::has_clip_control()) space = {DepthBuffer::standard_z, ClipRange::minus_one_to_one};
        program.emplace(opengl::id_program(ids));
        if (counts_primitives()) return;
        ids = opengl::IdSource::vertex;
        program.emplace(opengl::id_program(ids));
    }
    ~State() {
        const Context::Current current(context);
        program.reset();
    }

    /// The context must be current.
    opengl::Mesh mesh(const Scene& scene) const {
        return {scene,
                space.z == DepthBuffer::reversed_z ? opengl::DrawOrder::first_first
                                                   : opengl::DrawOrder::last_first,
                ids};
    }
    /// The context must be current.
    Pixels draw(const opengl::Mesh& mesh, const View& view) const {
        return draw(mesh, {view.width, view.height}, clip_rows(view.camera, space));
    }

    Context context;
    ClipSpace space;  ///< the best that the driver has
    opengl::IdSource ids = opengl::IdSource::primitive;
    std::optional<opengl::Program> program;  ///< lives and dies while the context is current

  private:
    /// Does the second of two triangles, which alone is seen, have the number 1?
    bool counts_primitives() const {
        Scene two;
        two.vertices.position_world = {{2, 2, 0}, {3, 2, 0}, {2, 3, 0}, {-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
        two.triangles = {{0, 1, 2}, {3, 4, 5}};
        const ClipRows as_it_is{.eye_world = {},
                                .x = {1, 0, 0, 0},
                                .y = {0, 1, 0, 0},
                                .z = {0, 0, 0, 0.5f},
                                .w = {0, 0, 0, 1},
                                .near_distance = {0, 0, 0, 1},
                                .far_distance = {0, 0, 0, 1}};
        return draw(mesh(two), {1, 1}, as_it_is).id.at(0, 0) == 1;
    }
    Pixels draw(const opengl::Mesh& mesh, Resolution size, const ClipRows& rows) const {
        const opengl::Target target(size);
        target.start(farthest(space.z));
        opengl::draw(*program, mesh, rows, space.z);
        Pixels pixels{target.ids(), target.depths()};
        opengl::raise_gl_error("reads an image back");
        return pixels;
    }
};

OpenGlDriver::OpenGlDriver() : state_(std::make_shared<State>()) {}

/// Threads join in only when the context is free again.
Frame OpenGlDriver::render(const Scene& scene, const View& view) const {
    const auto draw = [&] {
        const Context::Current current(state_->context);
        return state_->draw(state_->mesh(scene), view);
    };
    return to_frame(draw(), view.camera, state_->space.z);
}

Precision OpenGlDriver::precision() const {
    const Context::Current current(state_->context);
    GLint bits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
    return RasterPrecision{
        .origin = Origin::eye,
        .subpixel_bits = bits,
        .clipping = Clipping::view_volume,
        .depth_buffer = state_->space.z,
        .clip_range = state_->space.range,
        .matrix_far = state_->space.z == DepthBuffer::standard_z ? MatrixFar::finite : MatrixFar::infinite,
        .depth_interpolation = DepthInterpolation::plane,
        .depth_roundings = 1};
}

std::string OpenGlDriver::version() const {
    const Context::Current current(state_->context);
    const bool is_wrong = state_->ids != opengl::IdSource::primitive;
    return words_of(GL_VENDOR) + ", " + words_of(GL_RENDERER) + ", OpenGL " + words_of(GL_VERSION) +
           (is_wrong ? "; its gl_PrimitiveID is wrong, so vertices tell ids" : "");
}

struct OpenGl::Model {
    Model(const Scene& scene, const OpenGlDriver& of) : driver(of) {
        const Context::Current current(driver.state_->context);
        mesh.emplace(driver.state_->mesh(scene));
    }
    ~Model() {
        const Context::Current current(driver.state_->context);
        mesh.reset();
    }
    Pixels draw(const View& view) const {
        require_centre(view, "OpenGL");
        const Context::Current current(driver.state_->context);
        return driver.state_->draw(*mesh, view);
    }

    OpenGlDriver driver;
    std::optional<opengl::Mesh> mesh;
};

OpenGl::OpenGl(const Scene& scene, const OpenGlDriver& driver)
    : model_(std::make_unique<Model>(scene, driver)) {}
OpenGl::~OpenGl() = default;
OpenGl::OpenGl(OpenGl&&) noexcept = default;
OpenGl& OpenGl::operator=(OpenGl&&) noexcept = default;

Frame OpenGl::render(const View& view) const {
    return to_frame(model_->draw(view), view.camera, model_->driver.state_->space.z);
}

std::optional<std::string> opengl_is_missing() {
    try {
        const OpenGlDriver driver;
        return std::nullopt;
    } catch (const OracleError& e) {
        return e.what();
    }
}

}  // namespace zproof::oracle
