#include "scenes/polygon_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/concave_faces.h"
#include "scenes/limits.h"
#include "scenes/ply_header.h"
#include "scenes/refusal.h"
#include "scenes/scene_files.h"

namespace zproof {
namespace {

using Path = std::filesystem::path;

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view white = " \t\r\n";

/// Hands out the values behind the header, one after another.
class PlyValues {
  public:
    PlyValues(const Path& file, std::string_view values, PlyHeader::Format format)
        : file_(file), left_(values), format_(format) {}

    void begin(const std::string& element, std::uint64_t index) {
        element_ = &element;
        index_ = index;
    }

    [[noreturn]] void refuse_here(const std::string& text) const {
        refuse(file_, on_one_line(*element_) + " " + std::to_string(index_), text);
    }

    double next(PlyType type) {
        return format_ == PlyHeader::Format::ascii ? next_word(type) : next_binary(type);
    }

    /// A whole number from 0 to `most`.
    std::uint64_t next_whole(PlyType type, std::uint64_t most, const std::string& what) {
        return whole(next(type), most, what);
    }

    std::uint64_t whole(double value, std::uint64_t most, const std::string& what) const {
        if (!(value >= 0 && value <= static_cast<double>(most)) || value != std::floor(value))
            refuse_here("expected " + what + " from 0 to " + std::to_string(most) +
                        "; export the file again");
        return static_cast<std::uint64_t>(value);
    }

    /// What no element holds; of text without the blanks before it.
    std::string_view left() const {
        std::string_view rest = left_;
        if (format_ == PlyHeader::Format::ascii)
            rest.remove_prefix(std::min(rest.find_first_not_of(white), rest.size()));
        return rest;
    }

    /// The length of a list whose values take a byte at least.
    std::uint64_t next_length(PlyType type) { return next_whole(type, left_.size(), "a list's length"); }

  private:
    template <typename T>
    double number(const char* from) const {
        std::array<char, sizeof(T)> bytes;
        std::memcpy(bytes.data(), from, sizeof(T));
        if (format_ == PlyHeader::Format::big_endian) std::ranges::reverse(bytes);
        return static_cast<double>(std::bit_cast<T>(bytes));
    }

    double next_binary(PlyType type) {
        const std::size_t size = bytes_of(type);
        if (left_.size() < size) refuse_here("the file ends within it; export the file again");
        const char* from = left_.data();
        left_.remove_prefix(size);
        switch (type) {
            case PlyType::int8:
                return number<std::int8_t>(from);
            case PlyType::uint8:
                return number<std::uint8_t>(from);
            case PlyType::int16:
                return number<std::int16_t>(from);
            case PlyType::uint16:
                return number<std::uint16_t>(from);
            case PlyType::int32:
                return number<std::int32_t>(from);
            case PlyType::uint32:
                return number<std::uint32_t>(from);
            case PlyType::float32:
                return number<float>(from);
            case PlyType::float64:
                return number<double>(from);
        }
        return 0;
    }

    /// Text of float32 is rounded once, to float32. What is no finite number is NaN, which its user refuses.
    double next_word(PlyType type) {
        left_.remove_prefix(std::min(left_.find_first_not_of(white), left_.size()));
        const std::string_view word = left_.substr(0, left_.find_first_of(white));
        if (word.empty()) refuse_here("the file ends within it; export the file again");
        left_.remove_prefix(word.size());
        if (type == PlyType::float32) {
            const std::optional<float> value = finite_float(word);
            return value ? double{*value} : std::numeric_limits<double>::quiet_NaN();
        }
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        const bool is_number = error == std::errc{} && end == word.data() + word.size();
        return is_number ? value : std::numeric_limits<double>::quiet_NaN();
    }

    const Path& file_;
    std::string_view left_;
    PlyHeader::Format format_;
    const std::string* element_ = nullptr;
    std::uint64_t index_ = 0;
};

/// Where a value of a vertex goes.
enum class Slot : std::size_t { x, y, z, nx, ny, nz, u, v, none };
constexpr std::size_t slots = static_cast<std::size_t>(Slot::none);

Slot slot_of(const PlyProperty& property) {
    constexpr std::array<std::array<std::string_view, 3>, slots> names{
        {{"x"}, {"y"}, {"z"}, {"nx"}, {"ny"}, {"nz"}, {"u", "s", "texture_u"}, {"v", "t", "texture_v"}}};
    for (std::size_t i = 0; i < slots && !property.count_type; ++i)
        if (std::ranges::find(names[i], property.name) != names[i].end()) return static_cast<Slot>(i);
    return Slot::none;
}

bool is_list_of_corners(const PlyProperty& property) {
    return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
}

class PlyReader {
  public:
    PlyReader(const Path& file, const PlyHeader& header, std::string_view values)
        : file_(file), header_(header), values_(file, values, header.format) {
        scene_.name = file.stem().string();
        scene_.materials.push_back({"default", glm::vec4(1.0f), {}});
    }

    Scene scene() {
        for (const PlyElement& element : header_.elements)
            if (element.name == "vertex")
                vertices(element);
            else if (element.name == "face" || element.name == "tristrips")
                faces(element);
            else
                others(element);
        if (const std::string_view left = values_.left(); !left.empty()) {
            if (header_.format == PlyHeader::Format::ascii)
                refuse(
                    file_, "file",
                    "values stand behind the last element, or a line has more than its element; expected as "
                    "many as the header says: export the file again");
            note_count(scene_, left.size(), "bytes behind the last element ignored");
        }
        if (!scene_.triangles.empty())
            scene_.parts.push_back(
                {scene_.name, scene_.name, 0, 0, std::uint32_t(scene_.triangles.size()), 0, 0});
        cut_concave_faces(polygons_, scene_);
        note_count(scene_, too_short_, "faces of fewer than three corners skipped");
        note_count(scene_, bad_normals_, "vertices whose normal is not finite, read as without one");
        note_triangles(scene_);
        return std::move(scene_);
    }

  private:
    void skip(const PlyProperty& property) {
        std::uint64_t count = property.count_type ? values_.next_length(*property.count_type) : 1;
        while (count-- > 0) values_.next(property.type);
    }

    void others(const PlyElement& element) {
        scene_.notes.push_back(on_one_line("elements skipped: " + element.name));
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            values_.begin(element.name, i);
            for (const PlyProperty& property : element.properties) skip(property);
        }
    }

    /// Rounded to float32, where the property is a double.
    float finite(double value, const char* what) const {
        const float rounded = static_cast<float>(value);
        if (!std::isfinite(rounded))
            values_.refuse_here(std::string(what) + " is no finite number of float32; mend the model");
        return rounded;
    }

    void vertices(const PlyElement& element) {
        std::vector<Slot> order;
        std::array<bool, slots + 1> has{};
        for (const PlyProperty& property : element.properties) {
            order.push_back(slot_of(property));
            has[static_cast<std::size_t>(order.back())] = true;
        }
        if (!has[0] || !has[1] || !has[2])
            refuse(file_, "element vertex", "expected the properties x, y and z; export the file again");
        if (!scene_.vertices.position_world.empty() || element.count > limits::vertices)
            refuse(file_, "element vertex",
                   "expected it once, with at most " + std::to_string(limits::vertices) + " vertices");
        scene_.vertices.position_world.reserve(element.count);
        if (has[6] && has[7]) scene_.vertices.uv.emplace_back().reserve(element.count);
        has_normals_ = has[3] && has[4] && has[5];
        if (has_normals_) scene_.vertices.normal_world.reserve(element.count);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            values_.begin(element.name, i);
            std::array<double, slots + 1> value{};
            for (std::size_t p = 0; p < order.size(); ++p)
                if (order[p] == Slot::none)
                    skip(element.properties[p]);
                else
                    value[static_cast<std::size_t>(order[p])] = values_.next(element.properties[p].type);
            vertex(value);
        }
    }

    void vertex(const std::array<double, slots + 1>& value) {
        Vertices& baked = scene_.vertices;
        baked.position_world.emplace_back(finite(value[0], "x"), finite(value[1], "y"),
                                          finite(value[2], "z"));
        if (!baked.uv.empty())
            baked.uv[0].push_back(uv_of_v_up(finite(value[6], "u"), finite(value[7], "v")));
        if (!has_normals_) return;
        const glm::dvec3 normal(value[3], value[4], value[5]);
        bad_normals_ += !std::isfinite(normal.x + normal.y + normal.z);
        baked.normal_world.push_back(unit_normal(normal));
    }

    void faces(const PlyElement& element) {
        const auto lists = std::ranges::count_if(element.properties, is_list_of_corners);
        if (lists != 1)
            refuse(file_, "element " + element.name,
                   "expected one list vertex_indices or vertex_index; export the file again");
        if (scene_.vertices.position_world.empty() && element.count > 0)
            refuse(file_, "element " + element.name,
                   "expected the vertices before it; export the file again");
        for (std::uint64_t i = 0; i < element.count; ++i) {
            values_.begin(element.name, i);
            for (const PlyProperty& property : element.properties)
                if (!is_list_of_corners(property))
                    skip(property);
                else if (element.name == "face")
                    face(property, "face " + std::to_string(i));
                else
                    strips(property, "tristrips " + std::to_string(i));
        }
    }

    std::uint32_t corner(double value) const {
        return static_cast<std::uint32_t>(
            values_.whole(value, scene_.vertices.position_world.size() - 1, "an index of a vertex"));
    }

    void face(const PlyProperty& property, const std::string& place) {
        corners_.resize(values_.next_length(*property.count_type));
        for (std::uint32_t& each : corners_) each = corner(values_.next(property.type));
        too_short_ += corners_.size() < 3;
        if (const TriangleRun fan = append_fan(file_, place, corners_, scene_); fan.count > 1)
            polygons_.push_back(fan);
    }

    /// Strips one behind the other, between which stands -1.
    void strips(const PlyProperty& property, const std::string& place) {
        corners_.clear();
        for (std::uint64_t left = values_.next_length(*property.count_type); left > 0; --left) {
            const double value = values_.next(property.type);
            if (value != -1) corners_.push_back(corner(value));
            if (value == -1 || left == 1) end_strip(place);
        }
    }

    void end_strip(const std::string& place) {
        check_triangles(file_, place, scene_.triangles.size() + corners_.size());
        for (std::uint32_t i = 0; i + 2 < corners_.size(); ++i) {
            const glm::uvec3 at = corners_in_strip(i);
            scene_.triangles.emplace_back(corners_[at.x], corners_[at.y], corners_[at.z]);
        }
        corners_.clear();
    }

    const Path& file_;
    const PlyHeader& header_;
    PlyValues values_;
    Scene scene_;
    bool has_normals_ = false;
    std::vector<std::uint32_t> corners_;  ///< of the face or strip that is read, kept for its memory
    std::vector<TriangleRun> polygons_;   ///< faces of more than three corners
    std::uint64_t too_short_ = 0, bad_normals_ = 0;
};

}  // namespace

Scene load_ply_scene(const Path& file) {
    const Bytes bytes = read_file(file, limits::file_bytes);
    const std::string_view content = text_in(file, bytes);
    const PlyHeader header = ply_header(file, content);
    return PlyReader(file, header, content.substr(header.bytes)).scene();
}

}  // namespace zproof
