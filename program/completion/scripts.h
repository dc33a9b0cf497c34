/// Completion for the shells, written from the command line's own tree. Each is a whole script for its shell;
/// commands, options, and the words for values stand in it, so that completing does not start zproof.
#pragma once

#include <string>

#include "program/command_line/outline.h"

namespace zproof {

/// A script for `source`, or to be installed as bash-completion's completions/zproof. It needs only bash 3.2.
std::string bash_completion(const OutlineCommand& root);

/// A script to be installed as _zproof in a folder of $fpath.
std::string zsh_completion(const OutlineCommand& root);

/// A script to be installed as zproof.fish in a folder of $fish_complete_path.
std::string fish_completion(const OutlineCommand& root);

}  // namespace zproof
