#include "compare/diagnosis/hypotheses/renamed_ids.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/srgb.h"

namespace zproof {

Hypothesis with_ids_reported_as(const DiagnosisInput& input, const Cause& cause, const Renamed& told) {
    Hypothesis h = as_declared(input, cause);
    h.reads_surroundings = true;
    h.restate = [told, &seen = input.reference.frame.primitive](Claim claim) -> std::optional<Claim> {
        if (claim.answer.primitive == PrimitiveId::none) return claim;
        for (const int dy : {0, -1, 1})
            for (const int dx : {0, -1, 1}) {
                const int x = claim.x + dx, y = claim.y + dy;
                if (x < 0 || y < 0 || x >= seen.size().width || y >= seen.size().height) continue;
                const std::uint32_t id = std::uint32_t(seen.at(x, y));
                if (id == std::uint32_t(PrimitiveId::none) ||
                    told(id) != std::uint32_t(claim.answer.primitive))
                    continue;
                claim.answer.primitive = PrimitiveId(id);
                return claim;
            }
        return std::nullopt;
    };
    return h;
}

Ids most_often_with(std::span<const PrimitiveId> ids, std::span<const PrimitiveId> others) {
    std::unordered_map<std::uint64_t, std::uint32_t> together;
    for (std::size_t i = 0; i < ids.size(); ++i)
        if (ids[i] != PrimitiveId::none && others[i] != PrimitiveId::none)
            ++together[std::uint64_t(ids[i]) << 32 | std::uint64_t(others[i])];
    Ids most, times;
    for (const auto& [pair, count] : together) {
        const auto id = std::uint32_t(pair >> 32), other = std::uint32_t(pair);
        if (count < times[id] || (count == times[id] && other > most[id])) continue;
        times[id] = count;
        most[id] = other;
    }
    return most;
}

Cause ByteCurve::cause(const std::string& what) const {
    return {what + " went through " + name, "Each byte was taken for a colour and changed by the curve.",
            "Look at the format of the texture and of the file: ids must be stored as data, not as colours."};
}

std::uint32_t ByteCurve::operator()(std::uint32_t id) const {
    std::uint32_t changed = 0;
    for (int byte = 0; byte < 4; ++byte) {
        const double value = double(id >> 8 * byte & 0xFF) / 255;
        changed |= std::uint32_t(std::round(255 * at(value))) << 8 * byte;
    }
    return changed;
}

std::span<const ByteCurve> byte_curves() {
    static constexpr std::array curves{
        ByteCurve{"the curve of sRGB", encoded_srgb}, ByteCurve{"the curve of sRGB, backwards", decoded_srgb},
        ByteCurve{"a curve of gamma 2.2", [](double value) { return std::pow(value, 1 / 2.2); }},
        ByteCurve{"a curve of gamma 1/2.2", [](double value) { return std::pow(value, 2.2); }}};
    return curves;
}

std::size_t part_of(const Scene& scene, std::uint32_t triangle) {
    const auto after = std::ranges::upper_bound(scene.parts, triangle, {}, &Part::first_triangle);
    return std::size_t(after - scene.parts.begin()) - 1;
}

}  // namespace zproof
