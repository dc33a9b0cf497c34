#include "oracle/opengl.h"

#include <tbb/parallel_for.h>

#include "oracle/opengl/clip_space.h"
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
    const opengl::DepthFromZ depth_from(camera);
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

struct OpenGl::Device {
    /// Lives while the context is current.
    struct Objects {
        explicit Objects(const Scene& scene) : program(opengl::id_program()), mesh(scene) {}
        opengl::Program program;
        opengl::Mesh mesh;
    };

    explicit Device(const Scene& scene) {
        const Context::Current current(context);
        objects.emplace(scene);
    }
    ~Device() {
        const Context::Current current(context);
        objects.reset();
    }

    Pixels draw(const View& view) const {
        const Context::Current current(context);
        const opengl::Target target({view.width, view.height});
        target.start();
        opengl::draw(objects->program, objects->mesh, opengl::clip_rows(view.camera));
        Pixels pixels{target.ids(), target.depths()};
        opengl::raise_gl_error("reads the view '" + view.name + "' back");
        return pixels;
    }

    Context context;
    std::optional<Objects> objects;
};

OpenGl::OpenGl(const Scene& scene) : device_(std::make_unique<Device>(scene)) {}
OpenGl::~OpenGl() = default;
OpenGl::OpenGl(OpenGl&&) noexcept = default;
OpenGl& OpenGl::operator=(OpenGl&&) noexcept = default;

Frame OpenGl::render(const View& view) const { return to_frame(device_->draw(view), view.camera); }

std::optional<std::string> opengl_is_missing() {
    try {
        const Context context;
        return std::nullopt;
    } catch (const OracleError& e) {
        return e.what();
    }
}

Precision opengl_precision() {
    const Context context;
    const Context::Current current(context);
    GLint bits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
    return RasterPrecision{.origin = Origin::eye,
                           .subpixel_bits = bits,
                           .clipping = Clipping::view_volume,
                           .depth_buffer = DepthBuffer::reversed_z,
                           .depth_roundings = 1};
}

std::string opengl_version() {
    const Context context;
    const Context::Current current(context);
    return words_of(GL_VENDOR) + ", " + words_of(GL_RENDERER) + ", OpenGL " + words_of(GL_VERSION);
}

}  // namespace zproof::oracle
