#include <algorithm>
#include <functional>

#include "compare/hypotheses/catalogue.h"

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

/// Nothing was drawn in those cells of a grid that the candidate left blank altogether.
Hypothesis blank(const CaseFile& file, const std::string& name, const std::string& description,
                 Resolution cell) {
    const Resolution size = file.candidate.frame.size();
    const Resolution cells{(size.width + cell.width - 1) / cell.width,
                           (size.height + cell.height - 1) / cell.height};
    Plane<std::uint8_t> is_missing(cells);
    for (int y = 0; y < cells.height; ++y)
        for (int x = 0; x < cells.width; ++x)
            is_missing.at(x, y) =
                is_blank(file.candidate.frame,
                         {x * cell.width, y * cell.height, std::min(size.width, (x + 1) * cell.width),
                          std::min(size.height, (y + 1) * cell.height)});
    Hypothesis h = as_declared(file, name, description);
    h.scope = Scope::defects;
    h.amend = [is_missing, cell](Neighbourhood& around, PrimitiveId) {
        if (is_missing.at(around.x / cell.width, around.y / cell.height)) around.neighbours.clear();
    };
    return h;
}

Hypothesis moved(const CaseFile& file, const std::string& name, const std::string& description, int dx,
                 int dy) {
    Hypothesis h = as_declared(file, name, description);
    h.scope = Scope::defects;
    h.restate = [=](Claim claim) -> std::optional<Claim> {
        claim.x -= dx;
        claim.y -= dy;
        return claim;
    };
    return h;
}

std::vector<Hypothesis> moved_parts(const CaseFile& file) {
    const auto step = [&](int dx, int dy, const std::string& from) {
        return moved(file, "part of the image shows the pixel " + from,
                     "Only the defective pixels hold what belongs to the pixel " + from + ".", dx, dy);
    };
    std::vector<Hypothesis> all{step(1, 0, "to the left"), step(-1, 0, "to the right"), step(0, 1, "above"),
                                step(0, -1, "below")};
    for (const int side : tile_sides) {
        const std::string px = std::to_string(side);
        const auto tile = [&](int dx, int dy, const std::string& which) {
            return moved(file, "a tile of " + px + " px shows the one " + which,
                         "Defective pixels hold what belongs " + px + " px away.", dx * side, dy * side);
        };
        for (Hypothesis& h : std::vector{tile(1, 0, "to its left"), tile(-1, 0, "to its right"),
                                         tile(0, 1, "above it"), tile(0, -1, "below it")})
            all.push_back(std::move(h));
    }
    return all;
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_parts(const CaseFile& file) {
    const Resolution size = file.candidate.frame.size();
    std::vector<Hypothesis> all{
        blank(file, "nothing was drawn", "The whole frame is background.", size),
        blank(file, "rows are missing", "Whole rows are background.", {size.width, 1}),
        blank(file, "columns are missing", "Whole columns are background.", {1, size.height})};
    for (const int side : tile_sides)
        all.push_back(blank(file, "tiles of " + std::to_string(side) + " px are missing",
                            "Whole squares of the grid are background.", {side, side}));
    for (Hypothesis& h : moved_parts(file)) all.push_back(std::move(h));
    return all;
}

}  // namespace zproof
