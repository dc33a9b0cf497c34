#include "tests/cli/outline_of_zproof.h"

#include "cli/command_line/tree.h"
#include "program/command_line/outline.h"
#include "program/companion.h"
#include "tests/cli/program.h"

namespace zproof::test {

OutlineCommand outline_of_zproof() {
    CommandTree tree;
    OutlineCommand outline = outline_of(tree.root(), value_kinds(), examples());
    const Folder folder;
    for (OutlineCommand& command : outline.commands)
        if (companion_named(command.path)) command = outline_from(run(folder, {command.path, "outline"}).out);
    return outline;
}

}  // namespace zproof::test
