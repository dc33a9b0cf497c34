#include "oracle/reference_cache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <set>
#include <thread>

#include "oracle/oracle_error.h"
#include "oracle/scratch_folder.h"

namespace zproof::oracle {
namespace {

namespace fs = std::filesystem;

/// A frame that no other number gives.
Frame frame_of(std::uint32_t number, Resolution size = {31, 17}) {
    Frame frame(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            frame.primitive.at(x, y) = PrimitiveId(number * 1000 + std::uint32_t(y * size.width + x));
            frame.camera_depth.at(x, y) = float(number) + float(x) / 7 + float(y);
        }
    return frame;
}

bool are_the_same(const Frame& a, const Frame& b) {
    return std::ranges::equal(a.primitive.pixels(), b.primitive.pixels()) &&
           std::ranges::equal(a.camera_depth.pixels(), b.camera_depth.pixels());
}

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    return files;
}

TEST(ReferenceCache, GivesBackWhatItKept) {
    const ScratchFolder folder;
    ReferenceCache cache({.folder = folder.path() / "a" / "b"});
    EXPECT_FALSE(cache.find("one", {31, 17}));
    cache.keep("one", frame_of(1));
    cache.keep("two", frame_of(2));
    const auto found = ReferenceCache({.folder = folder.path() / "a" / "b"}).find("one", {31, 17});
    ASSERT_TRUE(found);
    EXPECT_TRUE(are_the_same(*found, frame_of(1)));
    EXPECT_FALSE(cache.find("three", {31, 17}));
    EXPECT_FALSE(cache.find("two", {17, 31}));
}

TEST(ReferenceCache, TakesNoFileThatIsNotAsItWasWritten) {
    const ScratchFolder folder;
    ReferenceCache cache({.folder = folder.path()});
    cache.keep("one", frame_of(1));
    const fs::path file = files_in(folder.path()).front();
    const auto bytes = fs::file_size(file);
    for (const std::uintmax_t place : {std::uintmax_t{0}, bytes / 40, bytes / 2, bytes - 1}) {
        cache.keep("one", frame_of(1));
        ASSERT_TRUE(cache.find("one", {31, 17}));
        std::fstream changed{file, std::ios::in | std::ios::out | std::ios::binary};
        changed.seekg(std::streamoff(place));
        const char byte = char(changed.get());
        changed.seekp(std::streamoff(place));
        changed.put(char(byte ^ 1));
        changed.close();
        EXPECT_FALSE(cache.find("one", {31, 17})) << place;
        EXPECT_FALSE(fs::exists(file)) << place;
    }
    cache.keep("one", frame_of(1));
    fs::resize_file(file, bytes - 4);
    EXPECT_FALSE(cache.find("one", {31, 17}));
}

TEST(ReferenceCache, TakesNoFileOfAnotherKey) {
    const ScratchFolder folder;
    ReferenceCache cache({.folder = folder.path()});
    cache.keep("one", frame_of(1));
    const fs::path one = files_in(folder.path()).front();
    cache.keep("two", frame_of(2));
    for (const fs::path& file : files_in(folder.path()))
        if (file != one) fs::copy_file(file, one, fs::copy_options::overwrite_existing);
    EXPECT_FALSE(cache.find("one", {31, 17}));
}

TEST(ReferenceCache, LetsGoWhatWasNotAskedForTheLongest) {
    const ScratchFolder folder;
    const std::uint64_t frame_bytes = 31 * 17 * 8;
    ReferenceCache cache({.folder = folder.path(), .most_bytes = 4 * (frame_bytes + 200)});
    const auto key = [](int number) { return "frame " + std::to_string(number); };
    for (int number = 0; number < 12; ++number) {
        cache.keep(key(number), frame_of(std::uint32_t(number)));
        EXPECT_TRUE(cache.find(key(0), {31, 17})) << number;  // asked for again and again
        EXPECT_LE(files_in(folder.path()).size(), 5u);
    }
    EXPECT_TRUE(cache.find(key(11), {31, 17}));
    EXPECT_FALSE(cache.find(key(3), {31, 17}));
}

TEST(ReferenceCache, IsSharedByManyWhoWriteTheSame) {
    const ScratchFolder folder;
    std::vector<std::thread> writers;
    for (int writer = 0; writer < 6; ++writer)
        writers.emplace_back([&] {
            ReferenceCache cache({.folder = folder.path(), .most_bytes = 40'000});
            for (std::uint32_t round = 0; round < 60; ++round) {
                const std::string key = std::to_string(round % 7);
                cache.keep(key, frame_of(round % 7));
                const auto found = cache.find(key, {31, 17});
                EXPECT_TRUE(!found || are_the_same(*found, frame_of(round % 7)));
            }
        });
    for (std::thread& writer : writers) writer.join();
}

TEST(ReferenceCache, AFolderThatCannotBeMadeIsSaid) {
    EXPECT_THROW(ReferenceCache({.folder = "/dev/null/frames"}), OracleError);
}

TEST(ReferenceKeys, TellApartWhatAFrameDependsOn) {
    std::set<std::string> keys;
    int count = 0;
    const auto note = [&](const View& view, const std::string& scene = "s", const std::string& tracer = "t") {
        keys.insert(reference_key(scene, view, tracer));
        ++count;
    };
    const View plain;
    note(plain);
    note(plain, "s2");
    note(plain, "s", "t2");
    const auto changed = [&](const auto& change) {
        View view = plain;
        change(view);
        note(view);
    };
    changed([](View& v) { v.width += 1; });
    changed([](View& v) { v.height += 1; });
    changed([](View& v) { v.sample.offset_px.x = 0.25; });
    changed([](View& v) { v.sample.offset_px.y = 0.25; });
    changed([](View& v) { v.camera.projection = Projection::parallel; });
    changed([](View& v) { v.camera.eye_world.y = 1e-30F; });
    changed([](View& v) { v.camera.right.z = 5e-324; });
    changed([](View& v) { v.camera.up.x = 5e-324; });
    changed([](View& v) { v.camera.back.x = 5e-324; });
    changed([](View& v) { v.camera.window.left -= 1e-15; });
    changed([](View& v) { v.camera.window.right += 1e-15; });
    changed([](View& v) { v.camera.window.bottom -= 1e-15; });
    changed([](View& v) { v.camera.window.top += 1e-15; });
    changed([](View& v) { v.camera.shear.x = 1; });
    changed([](View& v) { v.camera.near_depth = 0.1000000001; });
    changed([](View& v) { v.camera.far_depth = 1001; });
    EXPECT_EQ(keys.size(), std::size_t(count));
    View renamed = plain;
    renamed.name = "other";  // a name changes no pixel
    EXPECT_EQ(reference_key("s", renamed, "t"), reference_key("s", plain, "t"));
}

}  // namespace
}  // namespace zproof::oracle
