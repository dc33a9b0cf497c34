#include "oracle/reference_cache.h"

#include <algorithm>
#include <bit>
#include <fstream>
#include <system_error>
#include <vector>

#include "frame/frame_error.h"
#include "frame/number_text.h"
#include "frame/whole_file.h"
#include "math/sha256.h"
#include "oracle/oracle_error.h"

namespace zproof::oracle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view first_line = "zproof reference frame 1\n";
constexpr std::size_t sum_digits = 64;
/// The folder is added up again after this share of its limit was written.
constexpr std::uint64_t share_uncounted = 16;

std::string bits_of(double number) { return std::to_string(std::bit_cast<std::uint64_t>(number)) + " "; }

template <class Vector>
std::string bits_of_all(const Vector& v) {
    std::string text;
    for (int axis = 0; axis < Vector::length(); ++axis) text += bits_of(double(v[axis]));
    return text;
}

template <class T>
std::string_view bytes_of(const Plane<T>& plane) {
    return {reinterpret_cast<const char*>(plane.pixels().data()), plane.pixels().size() * sizeof(T)};
}

/// Ids, then depths, row by row; little-endian, as the machines are that zproof runs on.
static_assert(std::endian::native == std::endian::little);

std::string sum_of(const std::string& key, std::string_view ids, std::string_view depths) {
    Sha256 sum;
    sum.add(key);
    sum.add(ids);
    sum.add(depths);
    return sum.hex();
}

/// What a file says before the planes.
std::string header_of(const std::string& key, Resolution size, const std::string& sum) {
    return std::string{first_line} + key + "\n" + size_text(size.width, size.height) + "\n" + sum + "\n";
}

bool read_into(std::ifstream& in, void* at, std::size_t bytes) {
    in.read(static_cast<char*>(at), std::streamsize(bytes));
    return std::size_t(in.gcount()) == bytes;
}

/// The frame in this file; nothing where it is not what was kept under this key.
std::optional<Frame> frame_in(std::ifstream& in, const std::string& key, Resolution size) {
    std::string header(header_of(key, size, std::string(sum_digits, '0')).size(), '\0');
    Frame frame = Frame::unwritten(size);
    const std::string_view ids = bytes_of(frame.primitive), depths = bytes_of(frame.camera_depth);
    const bool is_whole = read_into(in, header.data(), header.size()) &&
                          read_into(in, frame.primitive.pixels().data(), ids.size()) &&
                          read_into(in, frame.camera_depth.pixels().data(), depths.size()) &&
                          in.peek() == std::ifstream::traits_type::eof();
    if (!is_whole || header != header_of(key, size, sum_of(key, ids, depths))) return std::nullopt;
    return frame;
}

struct KeptFile {
    fs::path path;
    std::uint64_t bytes;
    fs::file_time_type asked_for;
};

/// Those that are there; others may come and go meanwhile.
std::vector<KeptFile> files_in(const fs::path& folder) {
    std::vector<KeptFile> files;
    std::error_code failure;
    for (auto i = fs::directory_iterator(folder, failure); !failure && i != end(i); i.increment(failure)) {
        std::error_code gone;
        const KeptFile file{i->path(), i->file_size(gone), i->last_write_time(gone)};
        if (!gone && file.path.extension() == ".frame") files.push_back(file);
    }
    return files;
}

}  // namespace

std::string reference_key(const std::string& scene_sha256, const View& view, const std::string& tracer) {
    const Camera& camera = view.camera;
    const Window& window = camera.window;
    return scene_sha256 + " " + size_text(view.width, view.height) + " " +
           std::to_string(int(camera.projection)) + " " + bits_of_all(camera.eye_world) +
           bits_of_all(camera.right) + bits_of_all(camera.up) + bits_of_all(camera.back) +
           bits_of(window.left) + bits_of(window.right) + bits_of(window.bottom) + bits_of(window.top) +
           bits_of_all(camera.shear) + bits_of(camera.near_depth) + bits_of(camera.far_depth) +
           bits_of_all(view.sample.offset_px) + tracer;
}

ReferenceCache::ReferenceCache(ReferenceCacheChoice choice)
    : choice_(std::move(choice)), uncounted_bytes_(choice_.most_bytes) {
    std::error_code failure;
    fs::create_directories(choice_.folder, failure);
    if (failure)
        throw OracleError{choice_.folder.string() +
                          ": reference frames cannot be kept there: " + failure.message()};
}

fs::path ReferenceCache::file_of(const std::string& key) const {
    return choice_.folder / (sha256_of(key) + ".frame");
}

std::optional<Frame> ReferenceCache::find(const std::string& key, Resolution size) const {
    const fs::path file = file_of(key);
    std::ifstream in{file, std::ios::binary};
    if (!in) return std::nullopt;
    std::optional<Frame> frame = frame_in(in, key, size);
    std::error_code ignored;
    if (frame)
        fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
    else
        fs::remove(file, ignored);
    return frame;
}

void ReferenceCache::keep(const std::string& key, const Frame& frame) {
    const std::string_view ids = bytes_of(frame.primitive), depths = bytes_of(frame.camera_depth);
    const std::string header = header_of(key, frame.size(), sum_of(key, ids, depths));
    const std::scoped_lock lock(keeping_);
    try {
        WholeFile file(file_of(key));
        for (const std::string_view part : {std::string_view{header}, ids, depths}) file.append(part);
        file.finish();
    } catch (const FrameError&) {
        return;
    }
    uncounted_bytes_ += header.size() + ids.size() + depths.size();
    if (uncounted_bytes_ > choice_.most_bytes / share_uncounted) make_room();
}

void ReferenceCache::make_room() {
    std::vector<KeptFile> files = files_in(choice_.folder);
    std::ranges::sort(files, {}, &KeptFile::asked_for);
    std::uint64_t bytes = 0;
    for (const KeptFile& file : files) bytes += file.bytes;
    for (const KeptFile& file : files) {
        if (bytes <= choice_.most_bytes) break;
        std::error_code ignored;
        fs::remove(file.path, ignored);
        bytes -= file.bytes;
    }
    uncounted_bytes_ = 0;
}

}  // namespace zproof::oracle
