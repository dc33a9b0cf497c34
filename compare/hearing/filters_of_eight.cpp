#include "compare/hearing/filters_of_eight.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "compare/bounds/in_four.h"
#include "compare/search/acquaintance.h"

namespace zproof {

namespace {

constexpr std::size_t side_by_side_count = 8;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// They miss every place.
constexpr FiltersOfEight nobody = [] {
    FiltersOfEight none{};
    for (strips::EdgesOfEight& edges : none.points.edges)
        for (double& reach : edges.reach) reach = -infinite;
    return none;
}();

/// Compiled once per instruction set, with everything that it calls. No bit depends on which runs.
[[gnu::flatten, gnu::target_clones("default", "avx2")]] void set_four(
    const FiltersByEights::Lens& lens, const std::array<CornersWorld, four_count>& p_world, std::size_t lane,
    FiltersOfEight& to) {
    const Corners<Four> p = side_by_side(p_world);
    FilterLens<Four>::Edges edges{};
    if (lens.filters.is_perspective()) edges = lens.filters.edges_of(p);
    const FilterTerms<Four> terms = lens.filters.terms_of(p, PlaneErrorOf<Four>(lens.gauge(p).plane), edges);
    const auto put = [&](const Four& four, double* eight) { std::memcpy(eight + lane, &four, sizeof four); };
    const Four no_limit = everywhere<Four>(infinite);
    for (std::size_t k = 0; k < terms.edge.size(); ++k) {
        strips::EdgesOfEight& of_eight = to.points.edges[k];
        put(terms.edge[k].a, of_eight.a);
        put(terms.edge[k].b, of_eight.b);
        put(terms.edge[k].c, of_eight.c);
        put(terms.is_trusted ? terms.edge_error[k] : no_limit, of_eight.reach);
    }
    put(terms.nearness.a, to.nearness.a);
    put(terms.nearness.b, to.nearness.b);
    put(terms.nearness.c, to.nearness.c);
    put(terms.is_trusted ? terms.nearness_error : no_limit, to.nearness.error);
}

void clear(std::size_t lane, FiltersOfEight& of) {
    for (std::size_t k = 0; k < 3; ++k) {
        strips::EdgesOfEight& edges = of.points.edges[k];
        edges.a[lane] = edges.b[lane] = edges.c[lane] = 0;
        edges.reach[lane] = -infinite;
    }
}

FilterLens<Four> in_four(const FilterLens<double>& lens) {
    return {.sight = zproof::in_four(lens.sight),
            .width = everywhere<Four>(lens.width),
            .height = everywhere<Four>(lens.height),
            .origin_size = everywhere<Four>(lens.origin_size),
            .direction_size = everywhere<Four>(lens.direction_size)};
}

}  // namespace

FiltersByEights::FiltersByEights(const Scene& scene, const View& view)
    : scene_(scene),
      lens_{in_four(filter_lens_of(view)), ViewBounds(view, RasterPrecision{}).gauge<Four>()} {}

void FiltersByEights::make(std::span<const std::uint32_t> triangles,
                           std::vector<FiltersOfEight>& eights) const {
    expect_corners(scene_, triangles);
    eights.assign((triangles.size() + side_by_side_count - 1) / side_by_side_count, nobody);
    std::array<CornersWorld, four_count> p_world{};
    for (std::size_t first = 0; first < triangles.size(); first += four_count) {
        const std::size_t count = std::min(four_count, triangles.size() - first);
        for (std::size_t i = 0; i < count; ++i) p_world[i] = corners_of(scene_, triangles[first + i]);
        FiltersOfEight& to = eights[first / side_by_side_count];
        set_four(lens_, p_world, first % side_by_side_count, to);
        for (std::size_t i = count; i < four_count; ++i) clear(first % side_by_side_count + i, to);
    }
}

}  // namespace zproof
