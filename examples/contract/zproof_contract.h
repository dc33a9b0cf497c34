/// zproof's renderer contract for C++17 (docs/renderer-contract.md): read scene and camera, make rays, write
/// the frame. One header, no library; for little-endian machines. caster.cpp is a renderer made with it.
///
///   zproof_contract::Frame render(const std::vector<zproof_contract::Triangle>&, const
///                                 zproof_contract::Camera&);
///   int main(int argc, char** argv) { return zproof_contract::run(argc, argv, render); }
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace zproof_contract {

constexpr std::uint32_t background = 0xFFFFFFFF;  ///< the id of a pixel that sees no triangle
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Vec3 {
    double x = 0, y = 0, z = 0;
};
inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Triangle = std::array<Vec3, 3>;  ///< world space; each coordinate is a float32

/// origin + t * direction has the camera depth t; the direction is not normalized.
struct Ray {
    Vec3 origin, direction;
};

struct Camera {
    int width, height;
    bool perspective;                      ///< otherwise parallel
    Vec3 eye, right, up, back;             ///< world space
    double left, right_edge, bottom, top;  ///< exact_window
    double shear_x, shear_y;               ///< parallel: sideways step for each unit of depth
    double near, far;                      ///< camera depths between which a hit counts
    double sample_x, sample_y;             ///< where pixels are sampled, px from their centres, y down
    std::array<std::array<double, 4>, 4> camera_from_world, clip_from_camera;  ///< by rows

    /// The ray through the centre of pixel (x, y), or its sample.
    Ray ray(int x, int y) const {
        const double u = left + (right_edge - left) * (x + 0.5 + sample_x) / width;
        const double v = top - (top - bottom) * (y + 0.5 + sample_y) / height;
        if (perspective) return {eye, u * right + v * up - back};
        return {eye + u * right + v * up, shear_x * right + shear_y * up - back};
    }
};

/// What the program answers: row by row from the top, all background at first.
struct Frame {
    int width, height;
    std::vector<std::uint32_t> id;
    std::vector<float> depth;  ///< along the view axis
    std::map<std::string, std::vector<float>> attributes;

    Frame(int w, int h)
        : width(w),
          height(h),
          id(std::size_t(w) * std::size_t(h), background),
          depth(id.size(), std::numeric_limits<float>::infinity()) {}

    void set(int x, int y, std::size_t triangle, double camera_depth) {
        const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
        id[i] = std::uint32_t(triangle), depth[i] = float(camera_depth);
    }

    /// The values of a channel such as "bary.u" (docs/renderer-contract.md, "Attributes"), to be filled in.
    std::vector<float>& attribute(const std::string& name) {
        return attributes.try_emplace(name, id.size(), 0.0f).first->second;
    }
};

// --- JSON, as zproof writes it -----------------------------------------------------------------------------

/// A value: a number, a text, the items of an array, or the items of an object with their keys.
struct Json {
    double number = 0;
    std::string text;
    std::vector<Json> items;
    std::vector<std::string> keys;

    const Json* find(const std::string& key) const {
        const auto found = std::find(keys.begin(), keys.end(), key);
        return found == keys.end() ? nullptr : &items[std::size_t(found - keys.begin())];
    }
    const Json& at(const std::string& key) const {
        if (const Json* found = find(key)) return *found;
        throw std::runtime_error("key '" + key + "' is missing");
    }
    double number_at(const std::string& key, double otherwise = 0) const {
        const Json* found = find(key);
        return found == nullptr ? otherwise : found->number;
    }
    Vec3 vector() const { return {items.at(0).number, items.at(1).number, items.at(2).number}; }
};

class JsonReader {
  public:
    explicit JsonReader(const std::string& text) : at_(text.c_str()) {}

    Json value() {
        Json json;
        const char first = next();
        if (first == '{' || first == '[') {
            ++at_;
            read_items(json, first == '{' ? '}' : ']');
        } else if (first == '"') {
            json.text = string();
        } else if (first >= 'a' && first <= 'z') {  // true, false, null
            while (*at_ >= 'a' && *at_ <= 'z') json.text += *at_++;
        } else {
            char* end = nullptr;
            json.number = std::strtod(at_, &end);
            if (end == at_) throw std::runtime_error("not JSON: " + std::string(at_).substr(0, 20));
            at_ = end;
        }
        return json;
    }

  private:
    /// The next character that is no blank.
    char next() {
        while (*at_ != '\0' && std::strchr(" \t\r\n", *at_) != nullptr) ++at_;
        return *at_;
    }

    void read_items(Json& json, char end) {
        while (next() != end) {
            if (end == '}') {
                json.keys.push_back(string());
                if (next() == ':') ++at_;
            }
            json.items.push_back(value());
            if (next() == ',') ++at_;
        }
        ++at_;
    }

    std::string string() {
        std::string text;
        for (++at_; *at_ != '"'; ++at_) {
            if (*at_ == '\\') ++at_;  // no name matters that has an escape
            if (*at_ == '\0') throw std::runtime_error("not JSON: a text without an end");
            text += *at_;
        }
        ++at_;
        return text;
    }

    const char* at_;
};

// --- the scene and the camera ------------------------------------------------------------------------------

inline std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(path + ": cannot be read");
    return {std::istreambuf_iterator<char>(file), {}};
}

template <class T>
T value_at(const std::string& bytes, std::size_t at) {
    T value;
    if (at + sizeof value > bytes.size()) throw std::runtime_error("the scene ends too early");
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// The elements of one accessor, of float32 or uint32.
struct Elements {
    std::size_t first, stride, count;

    Elements(const Json& document, std::size_t binary, double accessor_index, std::size_t element_bytes) {
        const Json& accessor = document.at("accessors").items.at(std::size_t(accessor_index));
        const auto view_index = std::size_t(accessor.at("bufferView").number);
        const Json& view = document.at("bufferViews").items.at(view_index);
        first = binary + std::size_t(view.number_at("byteOffset") + accessor.number_at("byteOffset"));
        stride = std::size_t(view.number_at("byteStride", double(element_bytes)));
        count = std::size_t(accessor.at("count").number);
    }
    std::size_t operator[](std::size_t i) const { return first + i * stride; }  ///< where it begins
};

/// Every triangle of the scene; the index in this list is the id.
inline std::vector<Triangle> read_triangles(const std::string& path) {
    const std::string glb = content_of(path);
    const std::size_t json_size = value_at<std::uint32_t>(glb, 12), binary = 28 + json_size;
    const Json document = JsonReader(glb.substr(20, json_size)).value();
    std::vector<Triangle> triangles;
    const Json* meshes = document.find("meshes");
    if (meshes == nullptr) return triangles;  // a scene without triangles
    for (const Json& primitive : meshes->items.at(0).at("primitives").items) {
        const Elements points(document, binary, primitive.at("attributes").at("POSITION").number, 12);
        const Elements indices(document, binary, primitive.at("indices").number, 4);
        const auto corner = [&](std::size_t i) {
            const auto p =
                value_at<std::array<float, 3>>(glb, points[value_at<std::uint32_t>(glb, indices[i])]);
            return Vec3{p[0], p[1], p[2]};
        };
        for (std::size_t i = 0; i + 2 < indices.count; i += 3)
            triangles.push_back({corner(i), corner(i + 1), corner(i + 2)});
    }
    return triangles;
}

inline Camera read_camera(const std::string& path) {
    const Json json = JsonReader(content_of(path)).value();
    const Json &window = json.at("exact_window"), &far = json.at("far");
    const Json* shear = json.find("shear");
    const std::vector<Json>& sample = json.at("sample_px").items;
    Camera camera{int(json.at("width").number),
                  int(json.at("height").number),
                  json.at("projection").text == "perspective",
                  json.at("eye").vector(),
                  json.at("right").vector(),
                  json.at("up").vector(),
                  json.at("back").vector(),
                  window.at("left").number,
                  window.at("right").number,
                  window.at("bottom").number,
                  window.at("top").number,
                  shear == nullptr ? 0 : shear->items.at(0).number,
                  shear == nullptr ? 0 : shear->items.at(1).number,
                  json.at("near").number,
                  far.text == "infinity" ? infinity : far.number,
                  sample.at(0).number,
                  sample.at(1).number,
                  {},
                  {}};
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            const auto entry = [&](const char* key) {
                return json.at(key).items.at(row).items.at(column).number;
            };
            camera.camera_from_world[row][column] = entry("camera_from_world");
            camera.clip_from_camera[row][column] = entry("clip_from_camera");
        }
    return camera;
}

// --- the answer: OpenEXR, scan lines, not compressed -------------------------------------------------------

template <class T>
std::string bytes_of(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

inline std::string exr_attribute(const std::string& name, const std::string& type, const std::string& value) {
    return name + '\0' + type + '\0' + bytes_of(std::int32_t(value.size())) + value;
}

inline std::string exr_channel(const std::string& name, std::int32_t type) {
    return name + '\0' + bytes_of(std::array<std::int32_t, 4>{type, 0, 1, 1});
}

/// Channels in alphabetical order, as the format has it: Z (float32), id (uint32), attributes (float32).
inline void write_exr(const std::string& path, const Frame& frame) {
    std::map<std::string, const void*> planes{{"Z", frame.depth.data()}, {"id", frame.id.data()}};
    for (const auto& [name, values] : frame.attributes) planes[name] = values.data();
    std::string channels;
    for (const auto& [name, values] : planes) channels += exr_channel(name, name == "id" ? 0 : 2);
    const std::string window = bytes_of(std::array<std::int32_t, 4>{0, 0, frame.width - 1, frame.height - 1});
    const std::string header =
        bytes_of(std::array<std::int32_t, 2>{20000630, 2}) +
        exr_attribute("channels", "chlist", channels + '\0') +
        exr_attribute("compression", "compression", std::string(1, '\0')) +
        exr_attribute("dataWindow", "box2i", window) + exr_attribute("displayWindow", "box2i", window) +
        exr_attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
        exr_attribute("pixelAspectRatio", "float", bytes_of(1.0f)) +
        exr_attribute("screenWindowCenter", "v2f", bytes_of(std::array<float, 2>{0, 0})) +
        exr_attribute("screenWindowWidth", "float", bytes_of(1.0f)) + '\0';
    const std::size_t width = std::size_t(frame.width), height = std::size_t(frame.height);
    const std::size_t row_bytes = 4 * width, line_bytes = planes.size() * row_bytes;
    std::ofstream file(path, std::ios::binary);
    file << header;
    for (std::size_t y = 0; y < height; ++y)
        file << bytes_of(std::uint64_t(header.size() + 8 * height + y * (8 + line_bytes)));
    for (std::size_t y = 0; y < height; ++y) {
        file << bytes_of(std::array<std::int32_t, 2>{std::int32_t(y), std::int32_t(line_bytes)});
        for (const auto& [name, values] : planes)
            file.write(static_cast<const char*>(values) + y * row_bytes, std::streamsize(row_bytes));
    }
    if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

/// The whole program: reads the files that the command line names, calls render(triangles, camera), and
/// writes its frame. Returns the exit status.
template <class Render>
int run(int argc, char** argv, Render render) {
    try {
        if (argc != 4 && argc != 6)  // the camera file tells the size, too
            throw std::runtime_error("expected SCENE.glb CAMERA.json [WIDTH HEIGHT] OUT.exr");
        write_exr(argv[argc - 1], render(read_triangles(argv[1]), read_camera(argv[2])));
        return 0;
    } catch (const std::exception& e) {
        std::cerr << argv[0] << ": " << e.what() << "\n";
        return 1;
    }
}

}  // namespace zproof_contract
