/// The command line of a program beside zproof: "zproof filters", as if it were zproof's own command.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "program/command.h"
#include "program/command_line/outline.h"

namespace zproof {

class CompanionTree {
  public:
    /// `command` is a companion's (program/companion.h).
    CompanionTree(const std::string& command, Examples examples, ValueKinds kinds);
    ~CompanionTree();
    CompanionTree(const CompanionTree&) = delete;
    CompanionTree& operator=(const CompanionTree&) = delete;

    CLI::App& root() { return *root_; }  ///< commands are added below it

    /// Reads the words. --help and --version are answered here, and `outline`, which zproof asks. Throws
    /// UsageError.
    std::optional<Command> answer(int argc, const char* const* argv);

  private:
    std::unique_ptr<CLI::App> root_;
    CLI::App* outline_ = nullptr;
    Examples examples_;
    ValueKinds kinds_;
};

}  // namespace zproof
