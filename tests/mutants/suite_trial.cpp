#include "tests/mutants/suite_trial.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <set>

#include "compare/diagnosis/diagnosis.h"
#include "image_io/image_io.h"
#include "oracle/embree.h"
#include "scenes/suite.h"
#include "tests/mutants/rivals.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// Cheap scenes first: most mutants are found by the first. What survives all of them meets the scenes of
/// thorough runs with the large pictures.
std::vector<std::string> scenes_in_order_of_cost(Resolution size) {
    std::vector<std::string> names;
    for (const SuiteEntry& entry : suite_manifest()) names.push_back(entry.name);
    const auto is_cheap = [](const std::string& name) {
        return name != "million_triangles" && name != "deep_overdraw" && name != "closed_surfaces" &&
               name != "degenerate" && name != "slivers" && name != "coplanar";
    };
    std::stable_partition(names.begin(), names.end(), is_cheap);
    if (size.width >= 1920)
        for (const SuiteEntry& entry : thorough_manifest()) names.push_back(entry.name);
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

enum class Task {
    gate,    ///< judge, and end at the first view that fails
    cause,   ///< the same, and say what the diagnosis says of it
    rivals,  ///< say what rivals say, of every view that is named
};

const std::map<std::string, Task> tasks{
    {"gate", Task::gate}, {"cause", Task::cause}, {"rivals", Task::rivals}};

class SuiteTrial {
  public:
    SuiteTrial(Resolution size, const fs::path& folder, Task task, const TriedRenderer& renderer)
        : size_(size), folder_(folder), task_(task), renderer_(renderer) {}

    /// No view named: every view.
    void run(const std::set<std::string>& named) {
        for (const std::string& name : scenes_in_order_of_cost(size_)) {
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
        const Frame candidate = renderer_.render(scene, view);
        const Frame reference = references.of(view);
        ordered_json line{{"name", scene.name + "/" + view.name}};
        bool found = false;
        if (task_ == Task::rivals) {
            add_rivals(line, candidate, reference);
        } else {
            const TriedCase tried{
                scene, view, {candidate, renderer_.precision}, {reference, oracle::embree_precision()}};
            const Verdict verdict = judge(scene, view, tried.candidate, tried.reference);
            add_gate(line, verdict);
            found = defect_count(verdict) > 0;
            if (found && task_ == Task::cause) add_cause(line, tried, verdict);
        }
        std::cout << line << std::endl;
        return found;
    }

    Resolution size_;
    fs::path folder_;
    Task task_;
    const TriedRenderer& renderer_;
};

}  // namespace

void add_gate(ordered_json& line, const Verdict& verdict) {
    line["defects"] = defect_count(verdict);
    line["counts"] = counts_of(verdict);
    line["max_error_over_bound"] = verdict.candidate_depth.max_error_over_bound;
}

void add_cause(ordered_json& line, const TriedCase& tried, const Verdict& verdict) {
    const auto diagnosis = diagnose(tried.scene, tried.view, tried.candidate, tried.reference, verdict);
    if (!diagnosis || !diagnosis->cause) return;
    line["cause"] = diagnosis->cause->name;
    line["share"] = explained_share(*diagnosis->cause);
}

void add_rivals(ordered_json& line, const Frame& candidate, const Frame& reference) {
    line["pytorch3d"] = !passes_pytorch3d(candidate, reference);
    line["fuzzy"] = !passes_fuzzy_window(candidate, reference);
    line["idiff"] = !passes_idiff({}, candidate, reference);
    line["idiff_blender"] = !passes_idiff(blenders_idiff, candidate, reference);
}

bool try_suite(const std::vector<std::string>& words, const TriedRenderer& renderer) {
    if (words.size() < 4 || !tasks.contains(words[3])) return false;
    fs::create_directories(words[2]);
    const Resolution size{.width = std::stoi(words[0]), .height = std::stoi(words[1])};
    SuiteTrial(size, words[2], tasks.at(words[3]), renderer).run({words.begin() + 4, words.end()});
    return true;
}

}  // namespace zproof
