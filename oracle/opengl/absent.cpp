/// Stands in where zproof was built without OpenGL.
#include "oracle/opengl.h"
#include "oracle/oracle_error.h"

namespace zproof::oracle {
namespace {

constexpr const char* not_built_in =
    "OpenGL: not built in; install libegl-dev and libopengl-dev, then configure again";

}  // namespace

struct OpenGlDriver::State {};
struct OpenGl::Model {};

OpenGlDriver::OpenGlDriver() { throw OracleError(not_built_in); }

Frame OpenGlDriver::render(const Scene&, const View&) const { throw OracleError(not_built_in); }
Precision OpenGlDriver::precision() const { throw OracleError(not_built_in); }
std::string OpenGlDriver::version() const { throw OracleError(not_built_in); }

OpenGl::OpenGl(const Scene&, const OpenGlDriver&) { throw OracleError(not_built_in); }
OpenGl::~OpenGl() = default;
OpenGl::OpenGl(OpenGl&&) noexcept = default;
OpenGl& OpenGl::operator=(OpenGl&&) noexcept = default;

Frame OpenGl::render(const View&) const { throw OracleError(not_built_in); }

std::optional<std::string> opengl_is_missing() { return not_built_in; }

}  // namespace zproof::oracle
