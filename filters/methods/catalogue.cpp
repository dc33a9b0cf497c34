#include "filters/methods/catalogue.h"

#include <algorithm>

#include "filters/methods/families.h"

namespace zproof::texture {

std::span<const Method> methods() {
    static const std::vector<Method> all = [] {
        std::vector<Method> list;
        for (const auto& family :
             {point_methods, separable_methods, mip_methods, cardinality_methods, bilinear_reads_methods,
              ripmap_methods, sat_methods, repeated_sat_methods, anisotropic_methods, openimageio_methods,
              feline_methods, ewa_methods, supersample_methods, stochastic_methods})
            for (Method& method : family()) list.push_back(std::move(method));
        return list;
    }();
    return all;
}

const Method* find_method(std::string_view name) {
    const auto found = std::ranges::find(methods(), name, &Method::name);
    return found == methods().end() ? nullptr : &*found;
}

}  // namespace zproof::texture
