// What the reference of a texture filter says of zproof's own picture, by its own promise and by that of a
// graphics card: a line where the picture fails.
//
//     filter_trial FILTER[:key=value...] [odd_sizes]
#include <iostream>

#include "filters/commands/claim.h"
#include "filters/commands/joint_check.h"
#include "tests/filters/limited_sampler.h"

using namespace zproof;

namespace {

/// Empty where it keeps its promise, by pixels and as a whole.
std::string failure_of(const Picture& picture, const selftest::FilterFixture& fixture,
                       const selftest::FilterClaim& claim) {
    const selftest::ConformanceResult result = selftest::conformance_of(picture, fixture, claim);
    if (result.is_caught()) return selftest::in_words(result);
    return joint_conformance_of(picture, fixture, claim).leaves_promise() ? "the picture as a whole" : "";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    const FilterChoice choice = filter_choice(argv[1]);
    const selftest::FilterFixture fixture =
        selftest::filter_fixture(argc > 2 ? selftest::Ground::odd_sizes : selftest::Ground::noise);
    const Picture picture =
        rasterizer::filtered(fixture.scene, fixture.view, fixture.frame, choice.texturing);
    const std::string exact = failure_of(picture, fixture, claim_of(choice, {})),
                      card = failure_of(picture, fixture, claim_of(choice, gpu_with_exact_lod()));
    if (!exact.empty()) std::cout << "exact: " << exact << "\n";
    if (!card.empty()) std::cout << "card: " << card << "\n";
}
