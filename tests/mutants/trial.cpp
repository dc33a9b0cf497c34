// Runs this build's rasterizer, for tests/mutants/score: a line of JSON per view, or per fault of
// the selftest's catalogue.
//
//     mutant_trial suite WIDTH HEIGHT FOLDER gate|all    every suite scene; gate: end at the first defect
//     mutant_trial faults FOLDER                         the catalogue of zproof selftest
//
// FOLDER keeps the references from one call to the next. `all` and `faults` also say what rivals say;
// `faults` writes the pictures that the program idiff is given.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/selftest/test_scene.h"
#include "compare/diagnosis/diagnosis.h"
#include "image_io/image_io.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"
#include "tests/mutants/rivals.h"

namespace {

using namespace zproof;
namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// Cheap scenes first: most mutants are found by the first.
std::vector<std::string> scenes_in_order_of_cost() {
    std::vector<std::string> names;
    for (const SuiteEntry& entry : suite_manifest()) names.push_back(entry.name);
    const auto is_cheap = [](const std::string& name) {
        return name != "million_triangles" && name != "deep_overdraw" && name != "closed_surfaces" &&
               name != "degenerate" && name != "slivers" && name != "coplanar";
    };
    std::stable_partition(names.begin(), names.end(), is_cheap);
    return names;
}

/// Embree's frames of one scene, traced once and then kept as files.
class References {
  public:
    References(const Scene& scene, const fs::path& folder) : scene_(scene), folder_(folder) {}

    Frame of(const View& view) {
        const fs::path file =
            folder_ / (scene_.name + "-" + view.name + "-" + std::to_string(view.width) + ".exr");
        if (fs::exists(file)) return read_frame(file);
        if (!embree_) embree_.emplace(scene_);
        const Frame frame = embree_->trace(view);
        write_frame(file.string() + ".part", frame);
        fs::rename(file.string() + ".part", file);
        return frame;
    }

  private:
    const Scene& scene_;
    fs::path folder_;
    std::optional<oracle::Embree> embree_;
};

ordered_json counts_of(const Verdict& verdict) {
    ordered_json counts = ordered_json::object();
    for (int c = int(PixelClass::reference_wrong); c < pixel_class_count; ++c)
        if (const auto count = verdict.counts[std::size_t(c)])
            counts[std::string(name_of(PixelClass(c)))] = count;
    return counts;
}

struct Case {
    const Scene& scene;
    const View& view;
    RenderedFrame candidate, reference;
};

void add_cause(ordered_json& line, const Case& c, const Verdict& verdict) {
    const auto diagnosis = diagnose(c.scene, c.view, c.candidate, c.reference, verdict);
    if (!diagnosis || !diagnosis->cause) return;
    line["cause"] = diagnosis->cause->name;
    line["share"] = explained_share(*diagnosis->cause);
}

void add_gate(ordered_json& line, const Verdict& verdict) {
    line["defects"] = defect_count(verdict);
    line["counts"] = counts_of(verdict);
    line["max_error_over_bound"] = verdict.candidate_depth.max_error_over_bound;
}

void add_rivals(ordered_json& line, const Frame& candidate, const Frame& reference) {
    line["pytorch3d"] = !passes_pytorch3d(candidate, reference);
    line["fuzzy"] = !passes_fuzzy_window(candidate, reference);
    line["idiff"] = !passes_idiff({}, candidate, reference);
    line["idiff_blender"] = !passes_idiff(blenders_idiff, candidate, reference);
}

enum class Task {
    gate,    ///< judge, and end at the first view that fails
    cause,   ///< the same, and say what the diagnosis says of it
    rivals,  ///< say what rivals say, of every view that is named
};

class SuiteRun {
  public:
    SuiteRun(Resolution size, const fs::path& folder, Task task)
        : size_(size), folder_(folder), task_(task) {}

    /// No view named: every view.
    void run(const std::set<std::string>& named) {
        for (const std::string& name : scenes_in_order_of_cost()) {
            const auto is_of_scene = [&](const std::string& view) { return view.starts_with(name + "/"); };
            if (!named.empty() && std::ranges::none_of(named, is_of_scene)) continue;
            const Loaded loaded = generate_suite_scene(name, size_.width, size_.height);
            References references(loaded.scene, folder_);
            for (const View& view : loaded.views) {
                if (!named.empty() && !named.contains(name + "/" + view.name)) continue;
                if (finds_defect(loaded.scene, view, references)) return;
            }
        }
    }

  private:
    bool finds_defect(const Scene& scene, const View& view, References& references) const {
        const Frame candidate = rasterizer::render(scene, view);
        const Frame reference = references.of(view);
        ordered_json line{{"name", scene.name + "/" + view.name}};
        bool found = false;
        if (task_ == Task::rivals) {
            add_rivals(line, candidate, reference);
        } else {
            const Case c{
                scene, view, {candidate, rasterizer::precision()}, {reference, oracle::embree_precision()}};
            const Verdict verdict = judge(scene, view, c.candidate, c.reference);
            add_gate(line, verdict);
            found = defect_count(verdict) > 0;
            if (found && task_ == Task::cause) add_cause(line, c, verdict);
        }
        std::cout << line << std::endl;
        return found;
    }

    Resolution size_;
    fs::path folder_;
    Task task_;
};

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

namespace {

const std::map<std::string, Task> tasks{
    {"gate", Task::gate}, {"cause", Task::cause}, {"rivals", Task::rivals}};

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() >= 5 && words[0] == "suite" && tasks.contains(words[4])) {
        fs::create_directories(words[3]);
        const Resolution size{.width = std::stoi(words[1]), .height = std::stoi(words[2])};
        SuiteRun(size, words[3], tasks.at(words[4])).run({words.begin() + 5, words.end()});
        return 0;
    }
    if (words.size() == 2 && words[0] == "faults") {
        fs::create_directories(words[1]);
        try_faults(words[1]);
        return 0;
    }
    std::cerr << "usage: see the head of tests/mutants/trial.cpp\n";
    return 2;
}
