/// Ctrl-C as a question that the run asks between two stages of work.
#pragma once

namespace zproof {

/// From now on the first SIGINT or SIGTERM is only noted; a second one ends the program at once.
void note_interrupts();

/// Has one been noted?
bool interrupted();

}  // namespace zproof
