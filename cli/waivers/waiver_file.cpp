#include "cli/waivers/waiver_file.h"

#include <algorithm>
#include <limits>
#include <map>

#include "frame/joined.h"
#include "program/nearest_word.h"
#include "program/toml/reader.h"

namespace zproof {
namespace {

constexpr std::int64_t format = 1, largest_pixel = 32767, largest_id = 0xFFFF'FFFE;
constexpr std::int64_t largest_count = std::numeric_limits<std::int32_t>::max();

const std::vector<std::string> keys{"id",    "scene",  "view", "class",   "where",   "allow_all",
                                    "count", "reason", "link", "created", "expires", "scene_sha256"};
const std::vector<std::string> place_keys{"triangles", "pairs", "rectangles", "pixels", "size"};

std::vector<std::string> waivable_names() {
    std::vector<std::string> names;
    for (int i = 0; i < pixel_class_count; ++i)
        if (is_waivable(PixelClass(i))) names.emplace_back(name_of(PixelClass(i)));
    return names;
}

PixelClass waivable_class(const TomlReader& entry, const TomlValue& value) {
    const std::string name = entry.text_of(value, "class");
    for (int i = 0; i < pixel_class_count; ++i)
        if (name_of(PixelClass(i)) == name && is_waivable(PixelClass(i))) return PixelClass(i);
    if (name == name_of(PixelClass::invalid))
        entry.refuse(value,
                     "class: 'invalid' cannot be waived: the renderer breaks its contract there and has "
                     "said nothing that could be let pass");
    const std::vector<std::string> known = waivable_names();
    entry.refuse(value, "class: '" + name + "' is no class that fails the gate" + did_you_mean(name, known) +
                            " (expected: " + joined(known) + ")");
}

std::vector<PixelClass> classes_of(const TomlReader& entry) {
    const TomlValue& value = entry.at("class");
    if (std::holds_alternative<std::string>(value.is)) return {waivable_class(entry, value)};
    std::vector<PixelClass> classes;
    for (const TomlValue& one : entry.items_of(value, "class")) classes.push_back(waivable_class(entry, one));
    return classes;
}

/// The item's numbers, so many as are expected.
std::vector<int> numbers_of(const TomlReader& where, const TomlValue& item, const std::string& key,
                            const std::string& expected) {
    const auto* list = std::get_if<TomlArray>(&item.is);
    if (list == nullptr || list->size() != std::size_t(1 + std::ranges::count(expected, ',')))
        where.refuse(item, key + ": expected " + expected + ", found " + kind_of(item));
    std::vector<int> numbers;
    for (const TomlValue& one : *list) numbers.push_back(int(where.whole_of(one, key, largest_pixel)));
    return numbers;
}

PrimitiveId id_of(const TomlReader& where, const TomlValue& value, const std::string& key) {
    const auto* word = std::get_if<std::string>(&value.is);
    if (word != nullptr && *word == "background") return PrimitiveId::none;
    return PrimitiveId(std::uint32_t(where.whole_of(value, key, largest_id)));
}

AtTriangles triangles_of(const TomlReader& where, const TomlValue& value) {
    AtTriangles at;
    for (const TomlValue& one : where.items_of(value, "triangles"))
        at.triangles.push_back(PrimitiveId(std::uint32_t(where.whole_of(one, "triangles", largest_id))));
    return at;
}

AtPairs pairs_of(const TomlReader& where, const TomlValue& value) {
    AtPairs at;
    for (const TomlValue& one : where.items_of(value, "pairs")) {
        const auto* pair = std::get_if<TomlArray>(&one.is);
        if (pair == nullptr || pair->size() != 2)
            where.refuse(
                one, "pairs: expected [candidate's triangle, reference's triangle], found " + kind_of(one));
        at.pairs.emplace_back(id_of(where, pair->at(0), "pairs"), id_of(where, pair->at(1), "pairs"));
    }
    return at;
}

AtPixels pixels_of(const TomlReader& where) {
    const std::vector<int> size = numbers_of(where, where.at("size"), "size", "[width, height] of the image");
    AtPixels at{.size = {size[0], size[1]}, .rectangles = {}};
    if (const TomlValue* rectangles = where.find("rectangles"))
        for (const TomlValue& one : where.items_of(*rectangles, "rectangles")) {
            const auto r = numbers_of(where, one, "rectangles", "[x, y, width, height]");
            at.rectangles.push_back({r[0], r[1], r[2], r[3]});
        }
    if (const TomlValue* pixels = where.find("pixels"))
        for (const TomlValue& one : where.items_of(*pixels, "pixels")) {
            const auto p = numbers_of(where, one, "pixels", "[x, y]");
            at.rectangles.push_back({p[0], p[1], 1, 1});
        }
    return at;
}

decltype(Waiver::where) place_of(const TomlReader& entry) {
    const TomlValue* all = entry.find("allow_all");
    const TomlValue* place = entry.find("where");
    if (place == nullptr) {
        if (all != nullptr && std::get_if<bool>(&all->is) != nullptr && std::get<bool>(all->is))
            return Anywhere{};
        entry.refuse(
            "the key 'where' is missing: triangles, pairs, rectangles or pixels; for every pixel of "
            "the view say allow_all = true");
    }
    if (all != nullptr) entry.refuse(*all, "allow_all: has no meaning beside 'where'; remove one of them");
    const TomlReader where{entry.file(), *place};
    where.allow_only(place_keys);
    const TomlValue *triangles = where.find("triangles"), *pairs = where.find("pairs");
    const bool pixels = where.find("rectangles") != nullptr || where.find("pixels") != nullptr;
    if ((triangles != nullptr) + (pairs != nullptr) + pixels != 1)
        where.refuse("where: expected one kind of place: triangles, pairs, or rectangles and pixels");
    if (triangles != nullptr) return triangles_of(where, *triangles);
    if (pairs != nullptr) return pairs_of(where, *pairs);
    return pixels_of(where);
}

void read_count(const TomlReader& entry, Waiver& waiver) {
    const TomlReader count{entry.file(), entry.at("count")};
    const std::vector<std::string> ends{"min", "max"};
    count.allow_only(ends);
    waiver.least = std::uint64_t(count.whole_of(count.at("min"), "count.min", largest_count));
    waiver.most = std::uint64_t(count.whole_of(count.at("max"), "count.max", largest_count));
    if (waiver.least > waiver.most || waiver.most == 0)
        count.refuse("count: expected min <= max, and max at least 1");
}

void read_days(const TomlReader& entry, Waiver& waiver) {
    waiver.created = entry.day("created");
    waiver.expires = entry.day("expires");
    const auto life = std::chrono::sys_days{waiver.expires} - std::chrono::sys_days{waiver.created};
    if (life.count() < 0)
        entry.refuse(entry.at("expires"), "expires: lies before created, " + in_words(waiver.created));
    if (life > Waiver::longest_life)
        entry.refuse(entry.at("expires"),
                     "expires: " + std::to_string(life.count()) + " days after created; at most " +
                         std::to_string(Waiver::longest_life.count()) + " are allowed: choose " +
                         in_words(Day{std::chrono::sys_days{waiver.created} + Waiver::longest_life}) +
                         " or sooner, and look again then");
}

std::string hash_of(const TomlReader& entry) {
    const std::string hash = entry.text_or("scene_sha256", "");
    if (!hash.empty() &&
        (hash.size() != 64 || hash.find_first_not_of("0123456789abcdef") != std::string::npos))
        entry.refuse(entry.at("scene_sha256"),
                     "scene_sha256: expected the 64 hexadecimal digits that results.json has for the scene");
    return hash;
}

Waiver waiver_of(const TomlReader& entry) {
    entry.allow_only(keys);
    Waiver waiver{.id = entry.text("id"),
                  .scene = entry.text("scene"),
                  .view = entry.text_or("view", "*"),
                  .classes = classes_of(entry),
                  .where = place_of(entry),
                  .least = 1,
                  .most = 1,
                  .reason = entry.text("reason"),
                  .link = entry.text("link"),
                  .created = {},
                  .expires = {},
                  .scene_sha256 = hash_of(entry),
                  .origin = entry.file() + ":" + std::to_string(entry.line())};
    read_count(entry, waiver);
    read_days(entry, waiver);
    return waiver;
}

std::vector<Waiver> waivers_in(const TomlValue& document, const std::string& name) {
    const TomlReader root{name, document};
    const std::vector<std::string> top{"format", "waiver"};
    root.allow_only(top);
    if (const TomlValue& version = root.at("format"); root.whole_of(version, "format", format) != format)
        root.refuse(version, "format: this zproof reads format 1");
    std::vector<Waiver> waivers;
    std::map<std::string, int> lines;
    if (const TomlValue* list = root.find("waiver"))
        for (const TomlValue& one : root.items_of(*list, "waiver")) {
            const TomlReader entry{name, one};
            waivers.push_back(waiver_of(entry));
            const auto [first, is_new] = lines.try_emplace(waivers.back().id, entry.line());
            if (!is_new)
                entry.refuse(entry.at("id"), "id: '" + first->first + "' is taken by the waiver in line " +
                                                 std::to_string(first->second) + "; choose another");
        }
    return waivers;
}

}  // namespace

std::vector<Waiver> read_waivers(const std::filesystem::path& file) {
    return waivers_in(read_toml(file), file.string());
}

std::vector<Waiver> parse_waivers(const std::string& text, const std::string& name) {
    return waivers_in(parse_toml(text, name), name);
}

}  // namespace zproof
