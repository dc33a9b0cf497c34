#include "rasterizer/shading.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "rasterizer/shader.h"

namespace zproof::rasterizer {

Picture shade(const Scene& scene, const View& view, const Frame& frame, const Light& light) {
    const Shader shader{scene, view, light};
    Picture picture{frame.size()};
    tbb::parallel_for(tbb::blocked_range<int>{0, view.height}, [&](const tbb::blocked_range<int>& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y)
            for (int x = 0; x < view.width; ++x)
                if (const PrimitiveId id = frame.primitive.at(x, y); id != PrimitiveId::none)
                    picture.at(x, y) = shader.colour_at(x, y, id);
    });
    return picture;
}

}  // namespace zproof::rasterizer
