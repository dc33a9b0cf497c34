/// Completion for the shells, written from the command line's own tree. Each is a whole script for its shell;
/// commands, options, and the words for values stand in it, so that completing does not start zproof.
#pragma once

#include <string>

#include "cli/command_line/outline.h"

namespace zproof {

/// For `source`, or as bash-completion's completions/zproof. Needs bash 3.2 and nothing else.
std::string bash_completion(const OutlineCommand& root);

/// For a folder in $fpath, as _zproof.
std::string zsh_completion(const OutlineCommand& root);

/// For a folder in $fish_complete_path, as zproof.fish.
std::string fish_completion(const OutlineCommand& root);

}  // namespace zproof
