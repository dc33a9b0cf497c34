#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "compare/diagnosis/hypotheses/catalogue.h"

namespace zproof {

namespace {

constexpr std::array tile_sides{256, 128, 64, 32, 16, 8};  ///< px, the largest first

struct Rectangle {
    int x0, y0, x1, y1;
};

bool is_blank(const Frame& frame, const Rectangle& r) {
    for (int y = r.y0; y < r.y1; ++y)
        for (int x = r.x0; x < r.x1; ++x)
            if (frame.primitive.at(x, y) != PrimitiveId::none) return false;
    return true;
}

/// The hypothesis that nothing was drawn in the grid cells that the candidate left blank altogether.
Hypothesis blank(const DiagnosisInput& input, const Cause& cause, Resolution cell) {
    const Resolution size = input.candidate.frame.size();
    const Resolution cells{(size.width + cell.width - 1) / cell.width,
                           (size.height + cell.height - 1) / cell.height};
    Plane<std::uint8_t> is_missing(cells);
    for (int y = 0; y < cells.height; ++y)
        for (int x = 0; x < cells.width; ++x)
            is_missing.at(x, y) =
                is_blank(input.candidate.frame,
                         {x * cell.width, y * cell.height, std::min(size.width, (x + 1) * cell.width),
                          std::min(size.height, (y + 1) * cell.height)});
    Hypothesis h = as_declared(input, cause);
    h.cell = cell;
    h.amend = [is_missing, cell](Neighbourhood& around, PrimitiveId) {
        if (is_missing.at(around.x / cell.width, around.y / cell.height)) around.neighbours.clear();
    };
    return h;
}

/// A side of the picture, from which on rows or columns are missing.
enum class Side { top, bottom, left, right };

/// The strip of so many rows or columns along a side.
Rectangle strip_along(Side side, Resolution size, int count) {
    switch (side) {
        case Side::top:
            return {0, 0, size.width, count};
        case Side::bottom:
            return {0, size.height - count, size.width, size.height};
        case Side::left:
            return {0, 0, count, size.height};
        default:
            return {size.width - count, 0, size.width, size.height};
    }
}

/// The most rows or columns along a side that the candidate left blank and the reference did not; 0 where the
/// reference leaves the same blank, or all is blank.
int blank_along(const DiagnosisInput& input, Side side) {
    const Resolution size = input.candidate.frame.size();
    const bool is_of_rows = side == Side::top || side == Side::bottom;
    const int most = is_of_rows ? size.height : size.width;
    int count = 0;
    while (count < most && is_blank(input.candidate.frame, strip_along(side, size, count + 1))) ++count;
    const bool is_right = is_blank(input.reference.frame, strip_along(side, size, count));
    return count == most || is_right ? 0 : count;
}

std::vector<Hypothesis> blank_sides(const DiagnosisInput& input) {
    const Resolution size = input.candidate.frame.size();
    std::vector<Hypothesis> all;
    const char* bounds = "Look at the scissor, the viewport, and loop bounds.";
    for (const auto& [side, most, name, look_at] :
         {std::tuple{Side::bottom, size.height, "the last rows are missing",
                     "Look at the last block of rows, and at how the height is divided among them."},
          {Side::right, size.width, "the last columns are missing",
           "Look at the last block of columns, and at how the width is divided among them."},
          {Side::top, size.height, "the first rows are missing", bounds},
          {Side::left, size.width, "the first columns are missing", bounds}}) {
        const int count = blank_along(input, side);
        if (count == 0) continue;
        Hypothesis h = as_declared(
            input,
            {name, "Nothing is drawn there: " + std::to_string(count) + " of them are background.", look_at});
        h.learned_bits = std::log2(double(most));
        h.fits_a_limit = true;
        h.amend = [strip = strip_along(side, size, count)](Neighbourhood& around, PrimitiveId) {
            if (around.x >= strip.x0 && around.x < strip.x1 && around.y >= strip.y0 && around.y < strip.y1)
                around.neighbours.clear();
        };
        all.push_back(h);
    }
    return all;
}

struct Step {
    int dx, dy;
};

/// Cells that hold a defect hold what belongs a step back.
Hypothesis moved(const DiagnosisInput& input, const Cause& cause, Resolution cell, Step step) {
    Hypothesis h = as_declared(input, cause);
    h.cell = cell;
    h.restate = [=](Claim claim) -> std::optional<Claim> {
        claim.x -= step.dx;
        claim.y -= step.dy;
        return claim;
    };
    return h;
}

std::vector<Hypothesis> moved_rows(const DiagnosisInput& input) {
    const auto rows = [&](const std::string& from, Step step) {
        return moved(input,
                     {"some rows show the pixel " + from,
                      "Rows that hold a defect hold what belongs to the pixel " + from + ".",
                      "Look at the row's first address: pitch, padding, and the order of threads."},
                     {input.view.width, 1}, step);
    };
    return {rows("to the left", {1, 0}), rows("to the right", {-1, 0}), rows("above", {0, 1}),
            rows("below", {0, -1})};
}

std::vector<Hypothesis> moved_tiles(const DiagnosisInput& input) {
    std::vector<Hypothesis> all;
    for (const int side : tile_sides) {
        const std::string px = std::to_string(side);
        const auto tile = [&](const std::string& which, Step step) {
            return moved(input,
                         {"a tile of " + px + " px shows the one " + which,
                          "Tiles that hold a defect hold what belongs " + px + " px away.",
                          "Look at the tile's first address, and at which tile a thread writes."},
                         {side, side}, step);
        };
        for (Hypothesis& h : std::vector{tile("to its left", {side, 0}), tile("to its right", {-side, 0}),
                                         tile("above it", {0, side}), tile("below it", {0, -side})})
            all.push_back(std::move(h));
    }
    return all;
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_blank_frames(const DiagnosisInput& input) {
    Hypothesis h = blank(input,
                         {"nothing was drawn", "The whole frame is background.",
                          "Look at whether the draw call is reached, and at what the camera sees."},
                         input.candidate.frame.size());
    h.supposes_no_rule = true;
    return {h};
}

std::vector<Hypothesis> hypotheses_of_parts(const DiagnosisInput& input) {
    const Resolution size = input.candidate.frame.size();
    std::vector<Hypothesis> all{blank(input,
                                      {"rows are missing", "Whole rows are background.",
                                       "Look at how rows are shared among threads, and at loop bounds."},
                                      {size.width, 1}),
                                blank(input,
                                      {"columns are missing", "Whole columns are background.",
                                       "Look at the last block of each row, and at loop bounds."},
                                      {1, size.height})};
    for (Hypothesis& h : blank_sides(input)) all.push_back(std::move(h));
    for (const int side : tile_sides)
        if (side < std::max(size.width, size.height))  // else there is one tile, and it is the picture
            all.push_back(
                blank(input,
                      {"tiles of " + std::to_string(side) + " px are missing",
                       "Whole squares of the grid are background.",
                       "Look at binning: which tiles a triangle is listed in, and which tiles are run."},
                      {side, side}));
    for (const auto& more : {moved_rows(input), moved_tiles(input)})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace zproof
