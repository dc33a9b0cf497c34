#include "scenes/polygon_mesh.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/concave_faces.h"
#include "scenes/limits.h"
#include "scenes/obj_materials.h"
#include "scenes/refusal.h"
#include "scenes/scene_files.h"

namespace zproof {
namespace {

using Path = std::filesystem::path;

constexpr std::string_view blanks = " \t";
constexpr std::uint32_t absent = 0xFFFF'FFFF;

/// Takes the next word off the text; empty at its end.
std::string_view next_word(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    return word;
}

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// Keywords of OBJ that are read, counted, or change no triangle. Others are noted: "call" reads another
/// file.
bool is_known(std::string_view keyword) {
    static const std::set<std::string_view> words{
        "v",          "vt",        "vn",     "vp",    "f",     "l",     "p",        "o",
        "g",          "s",         "mg",     "end",   "con",   "deg",   "lod",      "mtllib",
        "usemtl",     "maplib",    "usemap", "bmat",  "step",  "curv",  "curv2",    "surf",
        "parm",       "trim",      "hole",   "scrv",  "sp",    "bevel", "c_interp", "d_interp",
        "shadow_obj", "trace_obj", "ctech",  "stech", "cstype"};
    return keyword.empty() || keyword[0] == '#' || words.contains(keyword);
}

/// A face's corner: position, uv and normal, absent where the corner names none.
using Corner = std::array<std::uint32_t, 3>;

/// A list that corners index into, and the largest index that any used, with its line: an index may go before
/// what it names.
struct Indexed {
    const char* keyword;
    std::size_t count = 0;
    std::int64_t furthest = -1;
    std::string place = {};
};

/// One vertex for each different corner of a position, in a list per position.
class CornerVertices {
  public:
    /// The vertex of the corner; a new one where it is the first such.
    std::uint32_t vertex_of(const Corner& corner) {
        if (first_.size() <= corner[0]) first_.resize(corner[0] + std::size_t{1}, absent);
        std::uint32_t* link = &first_[corner[0]];
        while (*link != absent && corners_[*link] != corner) link = &next_[*link];
        if (*link != absent) return *link;
        const auto vertex = static_cast<std::uint32_t>(corners_.size());
        *link = vertex;
        corners_.push_back(corner);
        next_.push_back(absent);
        return vertex;
    }
    const std::vector<Corner>& corners() const { return corners_; }

  private:
    std::vector<std::uint32_t> first_, next_;
    std::vector<Corner> corners_;
};

class ObjReader {
  public:
    /// A file of so many bytes has fewer lines.
    ObjReader(const Path& file, std::size_t bytes)
        : file_(file), most_lines_(std::int64_t(std::min<std::size_t>(bytes, limits::vertices))) {
        scene_.name = file.stem().string();
        scene_.materials.push_back({"default", glm::vec4(1.0f), {}});
    }

    /// A line with those that it continues on.
    void read(std::string_view line, std::size_t number) {
        place_ = "line " + std::to_string(number);
        const std::string_view keyword = next_word(line);
        if (keyword == "v") return position(line);
        if (keyword == "vt") return uv(line);
        if (keyword == "vn") return normal(line);
        if (keyword == "f") return face(line);
        if (keyword == "o" || keyword == "g") node_ = on_one_line(trimmed(line));
        if (keyword == "mtllib") read_obj_materials(file_, place_, std::string(trimmed(line)), scene_);
        if (keyword == "usemtl") material_ = on_one_line(trimmed(line));
        skipped_ += keyword == "l" || keyword == "p" || keyword == "curv" || keyword == "surf";
        if (!is_known(keyword) && unknown_lines_++ == 0)
            first_unknown_ = on_one_line(", the first \"" + std::string(keyword) + "\" in " + place_);
    }

    Scene scene() {
        for (const Indexed& list : lists_)
            if (list.furthest >= static_cast<std::int64_t>(list.count))
                refuse(file_, list.place,
                       "index " + std::to_string(list.furthest + 1) + "; the file has " +
                           std::to_string(list.count) + " lines " + list.keyword + ": export the file again");
        bake_vertices();
        cut_concave_faces(polygons_, scene_);
        drop_textures_without_uv(scene_);
        note_count(scene_, unknown_lines_, "lines of an unknown keyword skipped", first_unknown_);
        note_count(scene_, unknown_materials_.size(), "unknown materials, white", first_unknown_material_);
        note_count(scene_, skipped_, "points, lines and curves skipped");
        note_count(scene_, too_short_, "faces of fewer than three corners skipped");
        note_count(scene_, bad_normals_, "vn that are not finite, read as without one");
        note_triangles(scene_);
        return std::move(scene_);
    }

  private:
    float number(std::string_view word) const {
        const std::optional<float> value = finite_float(word);
        if (!value)
            refuse(
                file_, place_,
                "expected a finite number of float32, found \"" + std::string(word) + "\"; mend the model");
        return *value;
    }

    void position(std::string_view text) {
        glm::vec3 p;
        for (int axis = 0; axis < 3; ++axis) p[axis] = number(next_word(text));
        positions_.push_back(p);
        ++lists_[0].count;
    }

    void uv(std::string_view text) {
        const float u = number(next_word(text));
        const std::string_view v = next_word(text);
        uv_.push_back(uv_of_v_up(u, v.empty() ? 0 : number(v)));
        ++lists_[1].count;
    }

    void normal(std::string_view text) {
        glm::dvec3 normal(0);
        bool is_finite = true;
        for (int axis = 0; axis < 3; ++axis) {
            const std::optional<float> value = finite_float(next_word(text));
            is_finite &= value.has_value();
            normal[axis] = double{value.value_or(0)};
        }
        bad_normals_ += !is_finite;
        normals_.push_back(is_finite ? unit_normal(normal) : glm::vec3(0));
        ++lists_[2].count;
    }

    /// What the text counts to, from 1 on or back from the last one read.
    std::uint32_t index(std::string_view text, Indexed& list) const {
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc{} || end != text.data() + text.size() || value == 0 ||
            value < -static_cast<std::int64_t>(list.count) || value > most_lines_)
            refuse(file_, place_,
                   "expected an index of a line " + std::string(list.keyword) +
                       ", from 1 or from -1, found \"" + std::string(text) + "\"; export the file again");
        const std::int64_t from_0 = value > 0 ? value - 1 : value + static_cast<std::int64_t>(list.count);
        if (from_0 > list.furthest) {
            list.furthest = from_0;
            list.place = place_;
        }
        return static_cast<std::uint32_t>(from_0);
    }

    /// "7", "7/1", "7//3" or "7/1/3".
    std::uint32_t vertex(std::string_view word) {
        Corner corner{absent, absent, absent};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string_view text = word.substr(0, word.find('/'));
            if (i == 0 || !text.empty()) corner[i] = index(text, lists_[i]);
            if (text.size() == word.size()) return vertices_.vertex_of(corner);
            word.remove_prefix(text.size() + 1);
        }
        refuse(file_, place_, "expected at most three indices of a corner; export the file again");
    }

    void face(std::string_view text) {
        polygon_.clear();
        for (std::string_view word = next_word(text); !word.empty() && word[0] != '#'; word = next_word(text))
            polygon_.push_back(vertex(word));
        too_short_ += polygon_.size() < 3;
        if (polygon_.size() < 3) return;
        Part& of_face = part();
        const TriangleRun fan = append_fan(file_, place_, polygon_, scene_);
        of_face.triangle_count += fan.count;
        if (fan.count > 1) polygons_.push_back(fan);
    }

    int material_index() {
        if (material_.empty()) return 0;
        for (std::size_t i = scene_.materials.size(); i-- > 1;)
            if (scene_.materials[i].name == material_) return static_cast<int>(i);
        if (unknown_materials_.empty()) first_unknown_material_ = ", the first \"" + material_ + "\"";
        unknown_materials_.insert(material_);
        return 0;
    }

    /// The part that the face belongs to: a new one behind another node or material.
    Part& part() {
        if (!scene_.parts.empty() && part_node_ == node_ && part_material_ == material_)
            return scene_.parts.back();
        part_node_ = node_;
        part_material_ = material_;
        const int node_index = nodes_.try_emplace(node_, static_cast<int>(nodes_.size())).first->second;
        const auto first = static_cast<std::uint32_t>(scene_.triangles.size());
        scene_.parts.push_back(
            {node_, node_, parts_of_node_[node_index]++, first, 0, material_index(), node_index});
        return scene_.parts.back();
    }

    /// Where corners name positions only, vertices are the lines v; else one for each different corner, in
    /// the order in which faces first name them.
    void bake_vertices() {
        Vertices& baked = scene_.vertices;
        const std::vector<Corner>& corners = vertices_.corners();
        if (lists_[1].furthest < 0 && lists_[2].furthest < 0) {
            for (glm::uvec3& triangle : scene_.triangles)
                triangle = {corners[triangle.x][0], corners[triangle.y][0], corners[triangle.z][0]};
            baked.position_world = std::move(positions_);
            return;
        }
        baked.position_world.reserve(corners.size());
        for (const Corner& each : corners) baked.position_world.push_back(positions_[each[0]]);
        if (lists_[1].furthest >= 0) {
            baked.uv.emplace_back().reserve(corners.size());
            for (const Corner& each : corners)
                baked.uv[0].push_back(each[1] == absent ? glm::vec2(0) : uv_[each[1]]);
        }
        if (lists_[2].furthest < 0) return;
        baked.normal_world.reserve(corners.size());
        for (const Corner& each : corners)
            baked.normal_world.push_back(each[2] == absent ? glm::vec3(0) : normals_[each[2]]);
    }

    const Path& file_;
    std::int64_t most_lines_;
    Scene scene_;
    std::string place_, node_, material_, part_node_, part_material_;
    Positions positions_;
    std::vector<glm::vec2> uv_;
    std::vector<glm::vec3> normals_;
    std::array<Indexed, 3> lists_{Indexed{"v"}, Indexed{"vt"}, Indexed{"vn"}};
    CornerVertices vertices_;
    std::vector<std::uint32_t> polygon_;  ///< the face that is read, kept for its memory
    std::vector<TriangleRun> polygons_;   ///< faces of more than three corners
    std::map<std::string, int> nodes_;
    std::map<int, int> parts_of_node_;
    std::set<std::string> unknown_materials_;
    std::string first_unknown_, first_unknown_material_;
    std::uint64_t skipped_ = 0, too_short_ = 0, bad_normals_ = 0, unknown_lines_ = 0;
};

/// Does a line that ends in a backslash go on in the next? A comment does not, nor a name: it may be a path.
/// `begin` is the first of the lines that were joined.
bool goes_on(std::string_view begin, std::string_view line) {
    static const std::set<std::string_view> of_names{"o", "g", "s", "usemtl", "mtllib"};
    return line.ends_with('\\') && line.find('#') == std::string_view::npos &&
           !of_names.contains(next_word(begin));
}

/// Calls read(line, number) for every line; one that ends in a backslash goes on in the next.
template <typename Read>
void for_each_line(std::string_view text, const Read& read) {
    std::string joined;
    std::size_t number = 1, lines = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + (text.substr(end).starts_with("\r\n") ? 2 : 1), text.size()));
        ++lines;
        if (goes_on(joined.empty() ? line : joined, line)) {
            line.remove_suffix(1);
            (joined += line) += ' ';
            continue;
        }
        if (joined.empty())
            read(line, number);
        else
            read(joined += line, number);
        joined.clear();
        number = lines + 1;
    }
    if (!joined.empty()) read(joined, number);
}

}  // namespace

Scene load_obj_scene(const Path& file) {
    const Bytes bytes = read_file(file, limits::file_bytes);
    if (bytes.empty()) refuse(file, "file", "is empty; expected a Wavefront OBJ");
    ObjReader reader(file, bytes.size());
    for_each_line(text_in(file, bytes),
                  [&](std::string_view line, std::size_t number) { reader.read(line, number); });
    return reader.scene();
}

}  // namespace zproof
