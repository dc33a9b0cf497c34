/// The whole command line as one tree of CLI11: every command, every option, every help text. It is made in
/// one place, so whatever is derived from it (parsing, completion, the manual page) cannot drift apart.
#pragma once

#include <memory>
#include <vector>

#include "cli/command_line/words.h"
#include "program/command_line/outline.h"

namespace zproof {

class CommandTree {
  public:
    CommandTree();
    ~CommandTree();
    CommandTree(const CommandTree&) = delete;
    CommandTree& operator=(const CommandTree&) = delete;

    CLI::App& root() { return *root_; }       ///< "zproof"; its subcommands are the commands
    CommandWords& words() { return words_; }  ///< with the defaults, until root() has parsed something

    /// The command that root() has parsed. Throws UsageError where there was none or its words mean nothing.
    Command chosen() const;

  private:
    CommandWords words_;
    std::unique_ptr<CLI::App> root_;
    std::vector<Branch> branches_;
};

/// The worked examples of zproof's commands.
Examples examples();

/// What names of options stand for, for completion.
ValueKinds value_kinds();

/// Everything that zproof can parse, with the commands of the programs beside it.
OutlineCommand whole_outline(const CLI::App& root);

}  // namespace zproof
