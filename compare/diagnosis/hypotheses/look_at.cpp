#include "compare/diagnosis/hypotheses/look_at.h"

#include <algorithm>
#include <array>

namespace zproof {

namespace {

struct Advice {
    std::string_view begins;  ///< of the cause's name
    std::string_view sentence;
};

/// The first whose beginning fits holds.
constexpr std::array signs{
    Advice{"depth is not a number",
           "Look for 0/0 where depth is interpolated or turned back: w or an area of 0, or 1/depth of 0."},
    Advice{"depth is infinite",
           "Look at where a hit writes its depth: the clear value stays, or something is divided by 0."},
    Advice{"background has a depth",
           "Look at the depth buffer's clear value and at how it is turned back: background is +infinity."},
    Advice{"background has an id", "Look at the id buffer's clear value: background is 0xFFFFFFFF."},
    Advice{"depth has the wrong sign", "Look at the view matrix: z in camera space is negative ahead."},
};

constexpr std::array places{
    Advice{"the image is flipped in y",
           "Look at the viewport transform and at how rows are written: row 0 is the top."},
    Advice{"the image is flipped in x", "Look at the camera's right axis, or its cross product's order."},
    Advice{"the image is turned", "Look at the viewport transform and the camera's axes: both are negated."},
    Advice{"the image is transposed",
           "Look at indices such as y * width + x: rows and columns are exchanged."},
    Advice{"the image is shifted by a fraction",
           "Look at the viewport transform's offset and at a jitter meant for antialiasing."},
    Advice{
        "the image is shifted",
        "Look at where pixels are sampled: the centre is (x + 1/2, y + 1/2); look at loop bounds as well."},
    Advice{"pixels are sampled at their centres", "Look at where the sample's offset is added."},
    Advice{"pixels are sampled at sample",
           "Look at the multisample state: one sample was read instead of the pixel's centre."},
    Advice{"the sample's", "Look at the table of sample positions: x is to the right, y is down."},
    Advice{"it is sample", "Look at which sample is resolved or read back."},
    Advice{"the pixel grid",
           "Look at how pixels become rays or NDC: divide by W, not W - 1, and add 1/2 to the index."},
    Advice{"2 x 2 pixels", "Look at the shading rate, or at a picture that is drawn small and enlarged."},
    Advice{"4 x 4 pixels", "Look at the shading rate, or at a picture that is drawn small and enlarged."},
};

constexpr std::array depths{
    Advice{"depth is the ray's length from",
           "Look at where rays start: on the near plane; add near and divide by the ray's length per depth."},
    Advice{"depth is the ray's length less",
           "Look at where near is subtracted, and at the hit's distance that is taken for depth."},
    Advice{"depth is the ray's length",
           "Look at where the hit's distance is stored: multiply it by the ray's component ahead."},
    Advice{"depth is NDC z", "Look at the read-back of the depth buffer: z is not turned back to depth."},
    Advice{"depth is counted from the near plane", "Look at where depth is stored: near was subtracted."},
    Advice{"depth is in other units", "Look at the units of the scene's import and of the depth's export."},
    Advice{"depths lie one pixel", "Look at the offsets at which the depth plane is read or written."},
    Advice{
        "depth is affine",
        "Look at depth's interpolation: interpolate 1/depth over the image, or divide by w for each pixel."},
    Advice{"depth is of a", "Look at how z is turned back: by the formula of the other kind of projection."},
    Advice{"depth is 1/depth", "Look at where depth is stored: what is interpolated was not inverted."},
    Advice{"depth is scaled to 0 at near",
           "Look at the depth's export: a normalization between near and far was left in."},
    Advice{"depth is scaled by",
           "Look at the camera node's scale, which the view matrix must not keep, and at units."},
    Advice{"depth is biased", "Look at polygon offset and depth bias, and at offsets of the ray's start."},
    Advice{"depth is read with another",
           "Look at near and far where z is turned back: they must be those of the projection matrix."},
    Advice{"depth is averaged",
           "Look at multisample resolve, filters and resizing: depth must be one sample's, unfiltered."},
    Advice{"depth is that of the first of 2 x 2",
           "Look at where depth is interpolated: for each pixel, not once for a block of lanes."},
    Advice{"depth is taken",
           "Look at where depth is interpolated: at the same place of the pixel as coverage is decided."},
    Advice{"depth has",
           "Look at the depth buffer's format, and at the format of the file that it is read from."},
    Advice{"depth is a float of",
           "Look for half floats or reduced precision where depth is kept or exported."},
    Advice{"undeclared depth buffer",
           "Look at the depth buffer's format: declare it (docs/bounds.md), or interpolate depth apart."},
};

constexpr std::array ids{
    Advice{"ids are too",
           "Look at where the id is made: a counter that is increased too early or too late, or a 0 that "
           "means nothing."},
    Advice{
        "ids count from 1",
        "Look at how the id buffer is read: 0 means nothing there; subtract 1 and write 0xFFFFFFFF for 0."},
    Advice{"even and odd ids",
           "Look at how a quad is cut into triangles, and in which order they are listed."},
    Advice{"ids count from the last", "Look at the order in which triangles are submitted or numbered."},
    Advice{"ids lie one pixel", "Look at the offsets at which the id plane is read or written."},
    Advice{"ids restart", "Look at gl_PrimitiveID and its like: add the triangles of the draw calls before."},
    Advice{"ids are those of the", "Look at the base id of each draw call: it is that of another part."},
    Advice{"the id is the part's",
           "Look at what the id buffer is given: the draw call's index, not the triangle's."},
    Advice{"the id is the node's",
           "Look at what the id buffer is given: the object's index, not the triangle's."},
    Advice{"the id is the material's",
           "Look at what the id buffer is given: the material's index, not the triangle's."},
    Advice{"the id is the quad's", "Look at the mesh's faces: the id counts quads; count triangles."},
    Advice{"both triangles of a quad", "Look at the mesh's faces: both halves of a quad were given one id."},
    Advice{"the id is a vertex's",
           "Look at flat attributes: the id comes from the provoking vertex, not from the primitive."},
    Advice{"ids keep their low",
           "Look at the id buffer's format, and at the format of the file: it has too few bits."},
    Advice{"ids end at", "Look at the id buffer's format: ids are clamped where they should be kept whole."},
    Advice{"ids went through a float",
           "Look for a float between the id and the file: write ids as unsigned integers."},
    Advice{"ids are exchanged",
           "Look at whatever sorts or reorders triangles (BVH build, vertex cache) and keep the original "
           "index."},
    Advice{"all triangles have", "Look at whether the id is written at all: a default value stays."},
    Advice{"several triangles have one id",
           "Look at what the id stands for: a face, an object or a cluster instead of the triangle."},
    Advice{"vertex indices keep",
           "Look at the index buffer's type: 16 bits hold 65 536 vertices; use 32, or split the mesh."},
};

constexpr std::array drawing{
    Advice{"triangles across the near plane",
           "Look at clipping: a triangle with a corner before the near plane must be cut, not rejected."},
    Advice{"triangles with a corner behind the eye",
           "Look at clipping: a triangle with a corner of w <= 0 must be cut before the division by w."},
    Advice{"triangles across the guard band",
           "Look at clipping: what leaves the range of the fixed-point grid must be cut, not rejected."},
    Advice{"triangles across the far plane",
           "Look at clipping: reject a triangle only if all its corners lie beyond the far plane."},
    Advice{
        "triangles across a side",
        "Look at frustum culling: reject only if all corners lie beyond one side; clip or clamp the rest."},
    Advice{"triangles of less than",
           "Look at the test that rejects small triangles: only an area of 0 may go."},
    Advice{"triangles beyond a count",
           "Look at buffers of a fixed size, at the number of indices drawn, and at 16-bit counters."},
    Advice{"small triangles are dropped",
           "Look at the test that rejects small triangles, and at bounding boxes that round to nothing."},
    Advice{"triangles of a determinant below",
           "Look at the ray test's epsilon: it scales with the triangle's area; reject 0 alone."},
    Advice{"triangles with a small determinant",
           "Look at the ray test's epsilon: it scales with the triangle's area; reject 0 alone."},
    Advice{"the near clip",
           "Look at the near plane's equation in clip space: it depends on the range of NDC z."},
    Advice{"the far clip", "Look at the far plane: depth clamping, or a ray whose end is not far."},
    Advice{"the near plane lies", "Look at near: the projection matrix's, the ray's start, scene units."},
    Advice{"the far plane lies", "Look at far: the projection matrix's, the ray's end, scene units."},
    Advice{"the top-left rule",
           "Look at the edge test: one of two triangles must own a centre on their edge."},
    Advice{"back faces",
           "Look at face culling and at the winding that counts as front: both sides are seen."},
    Advice{"front faces",
           "Look at face culling and at the winding that counts as front: both sides are seen."},
    Advice{"the depth test is reversed", "Look at the depth test's comparison and at the clear value."},
    Advice{"the depth test is missing",
           "Look at whether depth test and depth writes are on, and the buffer attached."},
    Advice{"some triangles are not drawn",
           "Look at lists with a fixed size, at binning, and at loops that end one too early."},
    Advice{"triangles show wherever they touch",
           "Look at the rasterizer's state: conservative coverage is on."},
    Advice{"triangles show only where they cover",
           "Look at the rasterizer's state: conservative coverage of the inner kind is on."},
};

constexpr std::array parts{
    Advice{"nothing was drawn", "Look at whether the draw call is reached, and at what the camera sees."},
    Advice{"the last rows", "Look at the last block of rows, and at how the height is divided among them."},
    Advice{"the last columns",
           "Look at the last block of columns, and at how the width is divided among them."},
    Advice{"the first rows", "Look at the scissor, the viewport, and loop bounds."},
    Advice{"the first columns", "Look at the scissor, the viewport, and loop bounds."},
    Advice{"rows are missing", "Look at how rows are shared among threads, and at loop bounds."},
    Advice{"columns are missing", "Look at the last block of each row, and at loop bounds."},
    Advice{"tiles of", "Look at binning: which tiles a triangle is listed in, and which tiles are run."},
    Advice{"some rows show", "Look at the row's first address: pitch, padding, and the order of threads."},
    Advice{"a tile of", "Look at the tile's first address, and at which tile a thread writes."},
};

constexpr std::array windows{
    Advice{"pixels are taken for square",
           "Look at the aspect: it is the window's width by its height, not the picture's."},
    Advice{"the window's width and height", "Look at the projection's arguments: x and y are exchanged."},
    Advice{"the window's offset",
           "Look at the projection's arguments: left, right, bottom and top need not lie about the axis."},
    Advice{"a perspective is", "Look at the division by w, and at which of the two matrices is used."},
    Advice{"a parallel view is", "Look at the division by w, which is 1, and at which matrix is used."},
    Advice{"the shear", "Look at the projection of an oblique view: depth moves points aside."},
    Advice{"the window is half as large",
           "Look at whether a number is a half-size or a size: xmag and ymag are half-sizes."},
    Advice{"the window is twice as large",
           "Look at whether a number is a half-size or a size: xmag and ymag are half-sizes."},
    Advice{"the window is square",
           "Look at the aspect: it comes from the camera, or is width by height, not 1."},
    Advice{"the window is", "Look at the projection's scale of that axis, and at the aspect."},
    Advice{"the field of view",
           "Look at the axis that the field of view is of: glTF's yfov is the vertical one."},
    Advice{"z is up", "Look at the import: the file's y is up, and the scene was turned as if z were."},
    Advice{"y is up", "Look at the import: the scene was turned from z up to y up although y was up."},
    Advice{"the scene's", "Look at the conversion between left-handed and right-handed axes."},
    Advice{"the camera's rotation",
           "Look at the view matrix: rows against columns, or the camera's pose taken for its inverse."},
    Advice{"the camera looks backwards, upside down",
           "Look at the camera's axes: OpenCV has y down and z ahead, OpenGL y up and z back."},
    Advice{"the camera looks backwards", "Look at the camera's forward axis: it looks along -z."},
};

constexpr std::array precisions{
    Advice{"vertices are snapped",
           "Look at the conversion to fixed point: round to the nearest, do not cut."},
    Advice{"vertices are transformed in float32",
           "Look at the type of matrices and vertices on the way to the grid."},
    Advice{"only", "Look at the fixed-point scale of the rasterizer's vertices: the sub-pixel bits."},
};

template <std::size_t count>
std::string_view found_in(const std::array<Advice, count>& table, std::string_view name) {
    const auto found =
        std::ranges::find_if(table, [&](const Advice& advice) { return name.starts_with(advice.begins); });
    return found == table.end() ? std::string_view() : found->sentence;
}

}  // namespace

std::string look_at(std::string_view name) {
    for (const std::string_view sentence :
         {found_in(signs, name), found_in(places, name), found_in(depths, name), found_in(ids, name),
          found_in(drawing, name), found_in(parts, name), found_in(windows, name),
          found_in(precisions, name)})
        if (!sentence.empty()) return std::string(sentence);
    return "";
}

}  // namespace zproof
