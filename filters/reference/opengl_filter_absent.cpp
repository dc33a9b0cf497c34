/// Stands in where zproof was built without OpenGL.
#include "filters/reference/filter_peers.h"
#include "oracle/opengl.h"
#include "oracle/oracle_error.h"

namespace zproof::oracle {

Picture opengl_filtered(const Scene&, const View&, const Frame&, const OpenGlFilter&, const FilterSettings&) {
    throw OracleError(*opengl_is_missing());
}

FilterPrecision opengl_filter_precision() { throw OracleError(*opengl_is_missing()); }

}  // namespace zproof::oracle
