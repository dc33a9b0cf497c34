/// What one process of the program tells another: messages, one after the other, through a pipe.
#pragma once

#include <optional>
#include <string>

namespace zproof {

struct Message {
    enum class Kind : char { facts, stage, scene, usage_error, error, internal_error };
    Kind kind;
    std::string text;
};

/// Writes all of it. False where nobody reads it any more.
bool send(int to, const Message& message);

/// Waits for the next one. Nothing where the pipe has ended, be it in the midst of a message.
std::optional<Message> receive(int from);

}  // namespace zproof
