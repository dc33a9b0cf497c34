#include "cli/message_pipe.h"

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace zproof {
namespace {

/// What stands before the text.
struct Head {
    std::uint64_t size;
    Message::Kind kind;
};

bool write_all(int to, const char* from, std::size_t size) {
    while (size > 0) {
        const ssize_t count = ::write(to, from, size);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        from += count, size -= std::size_t(count);
    }
    return true;
}

bool read_all(int from, char* to, std::size_t size) {
    while (size > 0) {
        const ssize_t count = ::read(from, to, size);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        to += count, size -= std::size_t(count);
    }
    return true;
}

}  // namespace

bool send(int to, const Message& message) {
    const Head head{message.text.size(), message.kind};
    return write_all(to, reinterpret_cast<const char*>(&head), sizeof head) &&
           write_all(to, message.text.data(), message.text.size());
}

std::optional<Message> receive(int from) {
    Head head{};
    if (!read_all(from, reinterpret_cast<char*>(&head), sizeof head)) return std::nullopt;
    Message message{head.kind, std::string(head.size, '\0')};
    if (!read_all(from, message.text.data(), head.size)) return std::nullopt;
    return message;
}

}  // namespace zproof
