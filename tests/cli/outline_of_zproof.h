/// The command line of zproof and of the programs beside it.
#pragma once

#include "program/command_line/outline.h"

namespace zproof::test {

OutlineCommand outline_of_zproof();

}  // namespace zproof::test
