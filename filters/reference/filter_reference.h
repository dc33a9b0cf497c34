/// The filter reference: what each method's own definition permits at a pixel, given what arithmetic
/// may cost. Written from the definitions (docs/texture-filters.md, docs/filter-conformance.md) and never
/// from the methods, which it judges.
///
/// Judged is the albedo: base colour factor x filtered texture, no light, no vertex colour, alpha ignored,
/// black where nothing is seen. Which surfaces may be seen is told by
/// filters/reference/admissible_surfaces.h.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "filters/reference/filter_query.h"
#include "filters/reference/seen_texture.h"
#include "frame/frame.h"

namespace zproof::oracle {

using FilterSettings = filter_reference::Settings;

/// Every method that has a filter reference, by the name of the catalogue.
std::span<const filter_reference::Definition> filter_definitions();
/// Null where there is none of that name.
const filter_reference::Definition* find_filter_definition(std::string_view name);

/// One method on one view of a scene; wraps are those of the textures' samplers. The scene and the view must
/// outlive it. May be asked from many threads.
class FilterReference {
  public:
    FilterReference(const Scene& scene, const View& view, const filter_reference::Definition& definition,
                    const FilterSettings& settings, StepRule steps = StepRule::analytic);

    /// What pixel (x, y) may show where it sees one of these, triangles or background. Everything is
    /// permitted where even intervals cannot tell (a pixel on the plane's horizon).
    PermittedColours at(int x, int y, std::span<const PrimitiveId> seen,
                        const FilterPrecision& precision) const;

    /// Likewise what a sample of a stochastic definition may be. None where no texture is seen, or where
    /// intervals cannot tell.
    std::optional<ColourDraws> draws_at(int x, int y, PrimitiveId seen,
                                        const FilterPrecision& precision) const;

  private:
    struct OfMaterial {
        filter_reference::MethodReference reference;  ///< empty where a material has no texture
        filter_reference::DrawReference draws;        ///< of a stochastic definition
        double largest = 1;                           ///< of the texels' values, at least 1
    };
    const OfMaterial& of(const Material& material) const;
    /// The triangle that this thread asked about last is kept: its neighbours in the picture mostly show it,
    /// too.
    filter_reference::SeenTexture texture_of(PrimitiveId seen, const FilterPrecision& precision) const;
    PermittedColours of_surface(int x, int y, PrimitiveId seen, const FilterPrecision& precision) const;
    /// What was filtered with what the sum may cost, as linear light.
    ColourRange light_of(const ColourRange& filtered, double largest, const FilterPrecision& precision) const;

    const Scene& scene_;
    const View& view_;
    StepRule steps_;
    filter_reference::Decoding decoding_;
    std::vector<OfMaterial> by_material_;
    struct Asked {
        PrimitiveId triangle;
        FilterPrecision precision;
        filter_reference::SeenTexture texture;
    };
    mutable tbb::enumerable_thread_specific<std::optional<Asked>> last_asked_;
};

}  // namespace zproof::oracle
