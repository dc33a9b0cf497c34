#include "program/command_line/candidates.h"

#include <array>

#include "math/processor.h"

namespace zproof {
namespace {

Candidates instruction_set_names(const std::string&) {
    Candidates candidates;
    for (const InstructionSet set : {InstructionSet::scalar, InstructionSet::avx2, InstructionSet::avx512})
        candidates.words.emplace_back(name_of(set));
    return candidates;
}

Candidates nothing(const std::string&) { return {}; }

Candidates folders(const std::string&) { return {{}, Paths::folders}; }

constexpr std::array known_to_all{NameMeaning{"--isa", instruction_set_names}, NameMeaning{"DIR", folders},
                                  NameMeaning{"--view", nothing}, NameMeaning{"--pixel", nothing},
                                  NameMeaning{"--crop", nothing}};

}  // namespace

NameMeanings common_meanings() { return known_to_all; }

}  // namespace zproof
