#include "filters/selftest/likely_cause.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <ranges>

#include "frame/joined.h"

namespace zproof::selftest {

namespace {

/// A definition that is tried, and what it would have to permit.
struct Trial {
    const DefinitionChange& change;
    const Picture& picture;
    PixelReference reference;
    FilterPrecision precision;

    PermittedColours permitted(const FilterPixel& p) const { return reference(p.x, p.y, precision); }
    bool permits(const FilterPixel& p) const {
        const std::optional<LinearRgb> told =
            change.of_picture ? change.of_picture(picture, p.x, p.y) : std::optional{picture.at(p.x, p.y)};
        return !told || slack_of(*told, permitted(p)) <= 1;
    }
    bool permits_all() const {
        std::atomic<bool> is_outside = false;
        tbb::parallel_for(0, picture.size().height, [&](int y) {
            for (int x = 0; x < picture.size().width && !is_outside; ++x)
                if (!permits({x, y})) is_outside = true;
        });
        return !is_outside;
    }
    double width_at(std::span<const FilterPixel> pixels) const {
        double sum = 0;
        for (const FilterPixel& p : pixels) sum += width_of(permitted(p));
        return sum;
    }
};

struct Cause {
    std::string name;
    double width;
};

/// Of two causes of which one permits more than so many times what the other does, the sharper one is told.
constexpr double far_more = 2;

std::vector<std::string> sharpest(const std::vector<Cause>& causes) {
    double least = std::numeric_limits<double>::infinity();
    for (const Cause& cause : causes) least = std::min(least, cause.width);
    std::vector<std::string> names;
    for (const auto& [name, width] : causes)
        if (!(width > far_more * least)) names.push_back(name);
    return names;
}

}  // namespace

std::vector<std::string> causes_of(const Picture& picture, const ChangedDefinitions& definitions,
                                   const FilterClaim& claim, const Conformance& found,
                                   const std::vector<DefinitionChange>& changes) {
    const std::vector<FilterPixel> wrong = some_pixels(found, std::nextafter(1.0f, 2.0f));
    if (wrong.empty()) return {};
    const PixelReference claimed = definitions.as_it_is();
    std::vector<LinearRgb> opposite;
    for (const FilterPixel& p : wrong)
        opposite.push_back(reflected(picture.at(p.x, p.y), claimed(p.x, p.y, claim.precision)));
    std::vector<Cause> causes;
    for (const DefinitionChange& change : changes) {
        const Trial trial{change, picture, definitions.under(change), claim_under(change, claim).precision};
        const auto permits = [&](const FilterPixel& p) { return trial.permits(p); };
        if (!permits(found.worst) || !std::ranges::all_of(wrong, permits) || !trial.permits_all()) continue;
        const auto permits_opposite = [&](std::size_t i) {
            return slack_of(opposite[i], trial.permitted(wrong[i])) <= 1;
        };
        const auto all = std::views::iota(std::size_t{0}, wrong.size());
        if (!change.of_picture && std::ranges::all_of(all, permits_opposite)) continue;
        causes.push_back({change.name, trial.width_at(wrong)});
    }
    return sharpest(causes);
}

std::string causes_in_words(const std::vector<std::string>& causes) {
    return causes.empty() ? "" : "; cause: " + joined(causes, ", or ");
}

}  // namespace zproof::selftest
