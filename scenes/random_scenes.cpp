#include "scenes/random_scenes.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "scenes/random/kinds.h"
#include "scenes/random/views.h"
#include "scenes/scene_error.h"

namespace zproof {
namespace {

using suite::Random;

constexpr std::array kinds_of_chance{
    RandomKind{"soup", "triangles of all sizes that share nothing"},
    RandomKind{"surface", "a surface whose triangles share edges"},
    RandomKind{"slivers", "needles down to 2^-12 px wide"},
    RandomKind{"degenerate", "triangles without area, alone or before a wall"},
    RandomKind{"coplanar", "triangles in one plane exactly"},
    RandomKind{"crossing", "triangles that cross at angles down to 2^-22"},
    RandomKind{"clipped", "triangles cut by one to six planes, and with corners on near and far"},
    RandomKind{"aligned", "corners at pixel centres and edges through them, exactly"},
    RandomKind{"stacked", "copies of one triangle, at one place or steps of float32 apart"},
    RandomKind{"primitives", "a part for every one to three triangles"},
    RandomKind{"tiny", "triangles smaller than a pixel, at pixel centres and beside them"},
    RandomKind{"mixed", "several of these in one scene"},
};

using AddKind = void (*)(random::Stage&, int most);
constexpr std::array<AddKind, kinds_of_chance.size() - 1> adders{
    random::add_soup,     random::add_surface,    random::add_slivers, random::add_degenerate,
    random::add_coplanar, random::add_crossing,   random::add_clipped, random::add_aligned,
    random::add_stacked,  random::add_primitives, random::add_tiny};

std::size_t index_of(std::string_view kind) {
    const auto found = std::ranges::find(kinds_of_chance, kind, &RandomKind::name);
    if (found == kinds_of_chance.end())
        throw SceneError("random scenes have no kind '" + std::string(kind) + "'");
    return std::size_t(found - kinds_of_chance.begin());
}

/// As many one-triangle scenes as crowded ones.
int triangle_count(Random& dice) { return std::min(dice.integer(1, 2) << dice.integer(0, 8), 500); }

View view_for(Random& dice, int triangles) {
    constexpr int most_unresolved = 8;
    for (;;) {
        const View view = random::any_view(dice);
        if (triangles <= most_unresolved || random::is_resolved(view)) return view;
    }
}

void add_mixture(random::Stage& stage, int most) {
    const int groups = std::clamp(stage.dice().integer(2, 5), 1, most);
    for (int i = 0; i < groups; ++i)
        adders[std::size_t(stage.dice().integer(0, int(adders.size()) - 1))](stage, most / groups);
}

/// Independent dice for each: seeds and numbers that follow one another have nothing in common.
Random dice_of(const RandomScene& scene, std::size_t kind) {
    Random of_seed(scene.seed);
    Random of_kind(of_seed.bits() ^ kind);
    return Random(of_kind.bits() ^ scene.number);
}

std::optional<std::uint64_t> number_in(std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// The text up to the next colon, which is taken away with it.
std::string_view next_part(std::string_view& text) {
    const std::string_view part = text.substr(0, text.find(':'));
    text.remove_prefix(std::min(part.size() + 1, text.size()));
    return part;
}

bool is_kind(std::string_view word) {
    return word == any_random_kind ||
           std::ranges::find(kinds_of_chance, word, &RandomKind::name) != kinds_of_chance.end();
}

std::string names_of_kinds() {
    std::string names;
    for (const RandomKind& kind : kinds_of_chance) names += std::string(kind.name) + ", ";
    return names + std::string(any_random_kind);
}

}  // namespace

std::span<const RandomKind> random_kinds() { return kinds_of_chance; }

RandomScene random_scene(std::string_view kind, std::uint64_t seed, std::uint64_t number) {
    const std::string_view own =
        kind == any_random_kind ? kinds_of_chance[number % kinds_of_chance.size()].name : kind;
    return {std::string(own), seed, number};
}

std::string word_of(const RandomScene& scene) {
    return "random:" + scene.kind + ":" + std::to_string(scene.seed) + ":" + std::to_string(scene.number);
}

std::optional<RandomScene> random_scene_from(std::string_view word) {
    std::string_view rest = word;
    if (!rest.starts_with("random:")) return std::nullopt;
    next_part(rest);
    const std::string_view kind = next_part(rest);
    const auto seed = number_in(next_part(rest)), number = number_in(rest);
    if (!is_kind(kind) || !seed || !number)
        throw SceneError(std::string(word) + ": expected random:KIND:SEED:NUMBER with a kind of " +
                         names_of_kinds() + " and two whole numbers, such as random:soup:1:0");
    return random_scene(kind, *seed, *number);
}

Loaded generate(const RandomScene& scene) {
    const std::size_t kind = index_of(scene.kind);
    Random dice = dice_of(scene, kind);
    const int most = triangle_count(dice);
    const View view = scene.kind == "aligned" ? random::aligned_view(dice) : view_for(dice, most);
    suite::MeshBuilder mesh(word_of(scene));
    random::Stage stage(view, dice, mesh);
    kind < adders.size() ? adders[kind](stage, most) : add_mixture(stage, most);
    return mesh.finish({view});
}

}  // namespace zproof
