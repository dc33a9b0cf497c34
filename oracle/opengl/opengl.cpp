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

/// z is 0 where nothing was drawn; background has no depth. Anything else is handed on for the judge to see.
Frame to_frame(const Pixels& pixels, const Camera& camera) {
    const DepthFromZ depth_from(camera);
    Frame frame(pixels.id.size());
    tbb::parallel_for(0, frame.size().height, [&](int y) {
        for (int x = 0; x < frame.size().width; ++x) {
            const PrimitiveId id{pixels.id.at(x, y)};
            const float z = pixels.z.at(x, y);
            frame.primitive.at(x, y) = id;
            if (id != PrimitiveId::none || z != 0) frame.camera_depth.at(x, y) = depth_from(z);
        }
    });
    return frame;
}

}  // namespace

struct OpenGlDriver::State {
    State() {
        const Context::Current current(context);
        program.emplace(opengl::id_program());
    }
    ~State() {
        const Context::Current current(context);
        program.reset();
    }

    /// The context must be current.
    Pixels draw(const opengl::Mesh& mesh, const View& view) const {
        const opengl::Target target({view.width, view.height});
        target.start();
        opengl::draw(*program, mesh, clip_rows(view.camera));
        Pixels pixels{target.ids(), target.depths()};
        opengl::raise_gl_error("reads the view '" + view.name + "' back");
        return pixels;
    }

    Context context;
    std::optional<opengl::Program> program;  ///< lives and dies while the context is current
};

OpenGlDriver::OpenGlDriver() : state_(std::make_shared<State>()) {}

/// Threads join in only when the context is free again.
Frame OpenGlDriver::render(const Scene& scene, const View& view) const {
    const auto draw = [&] {
        const Context::Current current(state_->context);
        return state_->draw(opengl::Mesh(scene), view);
    };
    return to_frame(draw(), view.camera);
}

Precision OpenGlDriver::precision() const {
    const Context::Current current(state_->context);
    GLint bits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
    return RasterPrecision{.origin = Origin::eye,
                           .subpixel_bits = bits,
                           .clipping = Clipping::view_volume,
                           .depth_buffer = DepthBuffer::reversed_z,
                           .depth_interpolation = DepthInterpolation::plane,
                           .depth_roundings = 1};
}

std::string OpenGlDriver::version() const {
    const Context::Current current(state_->context);
    return words_of(GL_VENDOR) + ", " + words_of(GL_RENDERER) + ", OpenGL " + words_of(GL_VERSION);
}

struct OpenGl::Model {
    Model(const Scene& scene, const OpenGlDriver& of) : driver(of) {
        const Context::Current current(driver.state_->context);
        mesh.emplace(scene);
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

Frame OpenGl::render(const View& view) const { return to_frame(model_->draw(view), view.camera); }

std::optional<std::string> opengl_is_missing() {
    try {
        const OpenGlDriver driver;
        return std::nullopt;
    } catch (const OracleError& e) {
        return e.what();
    }
}

Precision opengl_precision() { return OpenGlDriver().precision(); }

std::string opengl_version() { return OpenGlDriver().version(); }

}  // namespace zproof::oracle
