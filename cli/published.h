/// The end of every command that leaves a folder.
#pragma once

#include "reports/output_folder.h"

namespace zproof {

/// Puts the folder in its place. Says on stderr what it keeps there though zproof did not write it.
void publish(OutputFolder& folder);

}  // namespace zproof
