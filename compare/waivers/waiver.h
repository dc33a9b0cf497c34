/// A waiver: somebody's signed word that certain defects are known and may stay for a while. Waived pixels
/// keep their class and stay in every report; only the gate lets them pass.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "compare/pixel_class.h"
#include "frame/frame.h"

namespace zproof {

/// A calendar day; it has no time zone.
using Day = std::chrono::year_month_day;

/// Every pixel of the view. Has to be asked for in so many words (allow_all).
struct Anywhere {};

/// Pixels at which the candidate or the reference names one of these.
struct AtTriangles {
    std::vector<PrimitiveId> triangles;
};

/// Pixels at which candidate and reference name exactly these two, in this order; none is background.
struct AtPairs {
    std::vector<std::pair<PrimitiveId, PrimitiveId>> pairs;
};

/// Half open: x <= column < x + width.
struct PixelRectangle {
    int x = 0, y = 0, width = 1, height = 1;
};

/// Pixels of an image of this size; of any other size the waiver says nothing.
struct AtPixels {
    Resolution size;
    std::vector<PixelRectangle> rectangles;
};

struct Waiver {
    static constexpr std::chrono::days longest_life{180};

    std::string id;                   ///< unique in its file
    std::string scene, view = "*";    ///< patterns with * and ?
    std::vector<PixelClass> classes;  ///< of those that fail the gate, but never `invalid`
    std::variant<Anywhere, AtTriangles, AtPairs, AtPixels> where;
    std::uint64_t least = 1, most = 1;  ///< pixels per view
    std::string reason, link;
    Day created{}, expires{};  ///< holds through the last day; at most longest_life after created
    std::string scene_sha256;  ///< sha256_of(Scene); empty: whatever the scene
    std::string origin;        ///< "waivers.toml:7", for messages
};

/// Has it run out by that day?
bool is_expired(const Waiver& waiver, Day today);

/// "2026-04-10"; std::nullopt for what is no day of the calendar.
std::optional<Day> day_from(std::string_view text);
std::string in_words(Day day);

}  // namespace zproof
