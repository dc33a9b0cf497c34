#include "frame/input_file.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "frame/frame_error.h"
#include "tests/frame/scratch_folder.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

class InputFile : public ScratchFolder {
  protected:
    static std::string refusal(const fs::path& path, std::uint64_t most = 100) {
        return complaint<FrameError>([&] { read_input(path, {.words = "a JSON file", .most_bytes = most}); });
    }
};

TEST_F(InputFile, IsReadWhole) {
    std::ofstream{file("file")} << std::string(100, 'x');
    EXPECT_EQ(read_input(file("file"), {.words = "text", .most_bytes = 100}), std::string(100, 'x'));
    EXPECT_EQ(fault_of_input(file("file")), "");
    fs::create_symlink("file", file("link"));
    EXPECT_EQ(read_input(file("link"), {.words = "text"}).size(), 100u);
}

TEST_F(InputFile, IsReadWholeWhateverItsSize) {
    for (const std::size_t size : {0u, 1u, 4095u, 4096u, 4097u, (1u << 20) - 1, 1u << 20, (3u << 20) + 1}) {
        std::string bytes(size, ' ');
        for (std::size_t i = 0; i < size; ++i) bytes[i] = char(i * 2654435761u >> 24);
        std::ofstream{file("file"), std::ios::binary} << bytes;
        EXPECT_TRUE(read_input(file("file"), {.words = "text"}) == bytes) << size;
    }
}

TEST_F(InputFile, WhoseSizeTheSystemDoesNotTellIsReadWhole) {
    ASSERT_EQ(fs::file_size("/proc/self/maps"), 0u);
    EXPECT_NE(read_input("/proc/self/maps", {.words = "text"}).find("[stack]"), std::string::npos);
}

TEST_F(InputFile, OfMoreBytesThanExpectedIsRefused) {
    std::ofstream{file("file")} << std::string(101, 'x');
    EXPECT_EQ(refusal(file("file")), file("file").string() + ": more than 100 bytes; expected a JSON file");
}

TEST_F(InputFile, ThatIsNoRegularFileIsRefusedAtOnce) {
    mkfifo(file("pipe").c_str(), 0600);
    fs::create_symlink("loop", file("loop"));
    sockaddr_un address{.sun_family = AF_UNIX, .sun_path = ""};
    std::strncpy(address.sun_path, file("socket").c_str(), sizeof address.sun_path - 1);
    const int socket_here = socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_EQ(bind(socket_here, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    close(socket_here);
    for (const auto& [path, what] :
         {std::pair{file("pipe"), "is a pipe"}, std::pair{file("socket"), "is a socket"},
          std::pair{fs::path{"/dev/zero"}, "is a device"}, std::pair{file("."), "is a folder"},
          std::pair{file("loop"), "is a loop of links"}, std::pair{file("gone"), "no such file"},
          std::pair{file("gone/file"), "no such file"}}) {
        EXPECT_EQ(fault_of_input(path), what);
        EXPECT_EQ(refusal(path), path.string() + ": " + what + "; expected a JSON file");
    }
}

}  // namespace
}  // namespace zproof
