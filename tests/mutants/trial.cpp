// Runs this build's rasterizer, for tests/mutants/score: a line of JSON per view, or per fault of
// the selftest's catalogue.
//
//     mutant_trial suite ...         as try_suite says
//     mutant_trial faults FOLDER     the catalogue of zproof selftest; writes the pictures that the program
//     idiff is given
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "rasterizer/rasterizer.h"
#include "selftest/test_scene.h"
#include "tests/mutants/rivals.h"
#include "tests/mutants/suite_trial.h"

namespace {

using namespace zproof;
namespace fs = std::filesystem;
using nlohmann::ordered_json;

void try_fault(const selftest::Fault& fault, const selftest::Fixture& fixture, const fs::path& folder) {
    const selftest::FaultResult trial = selftest::try_fault(fault, fixture);
    ordered_json line{
        {"name", fault.name},          {"sentence", fault.sentence},       {"control", is_control(fault)},
        {"width", fixture.view.width}, {"as_expected", trial.as_expected}, {"said", in_words(trial)}};
    const Frame faulty = fault.inject(fixture);
    const bool of_reference = fault.target == selftest::Target::reference;
    const Frame& candidate = of_reference ? fixture.good : faulty;
    const Frame& reference = of_reference ? faulty : fixture.reference;
    if (trial.verdict) {
        add_gate(line, *trial.verdict);
        add_cause(line,
                  {fixture.scene,
                   fixture.view,
                   {candidate, fixture.precision},
                   {reference, fixture.reference_precision}},
                  *trial.verdict);
    }
    add_rivals(line, candidate, reference);
    write_for_idiff(folder / fault.name, faulty);
    const std::string size = std::to_string(fixture.view.width);
    write_for_idiff(folder / ("good-" + size), fixture.good);
    write_for_idiff(folder / ("reference-" + size), fixture.reference);
    line["candidate"] = (folder / (of_reference ? "good-" + size : fault.name)).string();
    line["reference"] = (folder / (of_reference ? fault.name : "reference-" + size)).string();
    std::cout << line << std::endl;
}

void try_faults(const fs::path& folder) {
    const selftest::TestScene large(selftest::FixtureSize::large), small(selftest::FixtureSize::small);
    for (const selftest::Fault& fault : selftest::catalogue())
        try_fault(fault, (fault.fixture_size == selftest::FixtureSize::large ? large : small).fixture(),
                  folder);
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() > 1 && words[0] == "suite" &&
        try_suite({words.begin() + 1, words.end()}, {rasterizer::render, rasterizer::precision()}))
        return 0;
    if (words.size() == 2 && words[0] == "faults") {
        fs::create_directories(words[1]);
        try_faults(words[1]);
        return 0;
    }
    std::cerr << "usage: see the head of tests/mutants/trial.cpp\n";
    return 2;
}
