/// Small scenes drawn by chance: of each kind as many as there are numbers, the same bits on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scenes/loaded.h"

namespace zproof {

inline constexpr int most_random_triangles = 500;
inline constexpr int largest_random_side = 128;  ///< pixels

struct RandomKind {
    std::string_view name, reason;
};

/// Every kind, in the order in which a mixture of all takes turns.
std::span<const RandomKind> random_kinds();

/// "any" takes turns: number n is of kind n modulo their count.
inline constexpr std::string_view any_random_kind = "any";

/// Which one is meant.
struct RandomScene {
    std::string kind;  ///< of random_kinds()
    std::uint64_t seed = 0, number = 0;
};

/// The scene of that number; of "any" the kind whose turn it is.
RandomScene random_scene(std::string_view kind, std::uint64_t seed, std::uint64_t number);

/// "random:soup:7:12", and back; "any" is understood. Throws SceneError for a word that begins with "random:"
/// and means none; nothing for other words.
std::string word_of(const RandomScene& scene);
std::optional<RandomScene> random_scene_from(std::string_view word);

/// Makes it, named by its word, with one view. Within the judged ranges but for what the view's image size
/// is: that is its own. Throws SceneError for an unknown kind.
Loaded generate(const RandomScene& scene);

}  // namespace zproof
