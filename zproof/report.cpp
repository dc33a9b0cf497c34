#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "frame/precision_text.h"
#include "frame/whole_file.h"
#include "image_io/image_io.h"
#include "oracle/subprocess.h"
#include "reports/output_folder.h"
#include "scenes/glb_writer.h"
#include "zproof/data.h"
#include "zproof/errors.h"
#include "zproof/names.h"

namespace zproof::api {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* input_suffix = "-input";
constexpr std::chrono::hours longest_run{1};
constexpr int proven = 0, defective = 1, undecided = 3;  // docs/cli.md

/// By its whole path, where it is not looked for on PATH.
std::string program() {
    const char* named = std::getenv("ZPROOF_PROGRAM");
    const std::string word = named && *named ? named : "zproof";
    return word.find('/') == std::string::npos ? word : fs::absolute(word).string();
}

/// Settings for the program that this process has in its environment are meant for other runs; a verdict has
/// no waivers. Where the program's own parts lie is left.
Words without_settings() {
    Words words{"env"};
    for (char** entry = environ; *entry; ++entry) {
        const std::string name = std::string(*entry).substr(0, std::string_view(*entry).find('='));
        if (!name.starts_with("ZPROOF_") || name == "ZPROOF_IMAGE_IO" || name == "ZPROOF_ISA") continue;
        words.insert(words.end(), {"-u", name});
    }
    return words;
}

/// Run in the folder, so that the report's commands name its files as they lie beside it.
void run_program(const fs::path& folder, const Words& words, int expected_status) {
    Words command = without_settings();
    command.push_back(program());
    command.insert(command.end(), words.begin(), words.end());
    const oracle::Outcome outcome =
        oracle::run({.arguments = command, .folder = folder, .time_limit = longest_run});
    if (outcome.ending == oracle::Ending::exited && outcome.code == expected_status) return;
    throw std::runtime_error{program() + " " + words.front() + ": " + oracle::in_words(outcome, longest_run) +
                             ": " + oracle::last_output(outcome)};
}

constexpr const char* labels_file = "labels.json";
constexpr const char* precision_file = "precision.json";

/// The frame with labels in the places of triangles, as the candidate gave it. What means background to
/// Cryptomatte is written as everywhere else.
zproof::Frame written_frame(const Verdict::Data& data) {
    const auto& [word, ids, precision, labels, has_depth] = data.declared;
    if (!labels) return data.judged;
    zproof::Frame frame = data.given;
    if (labels->are_absent)
        frame.primitive = Plane<PrimitiveId>(frame.camera_depth.size(), PrimitiveId::none);
    for (PrimitiveId& id : frame.primitive.pixels())
        if (std::ranges::count(labels->background, std::uint32_t(id)) > 0) id = PrimitiveId::none;
    return frame;
}

/// What --ids is given. The written scene is one mesh at one node: labels are listed triangle by triangle in
/// a file.
std::string write_ids(const Declared& declared, const fs::path& folder, const fs::path& published) {
    if (!declared.labels || declared.labels->are_absent) return declared.ids;
    std::string list;
    for (const std::uint32_t label : declared.labels->of_triangle)
        list += (list.empty() ? "[" : ",") + std::to_string(label);
    write_whole_file(folder / labels_file, list + "]");
    return (published / labels_file).string();
}

/// What --precision is given: words, or a copy of the file; of ids alone, what they are judged by.
std::string write_precision(const Declared& declared, const fs::path& folder, const fs::path& published) {
    const std::string& word = declared.precision_word;
    if (!declared.has_depth)
        write_whole_file(folder / precision_file, precision_to_json(declared.precision));
    else if (is_promise_in_words(word))
        return word;
    else
        fs::copy_file(word, folder / precision_file);
    return (published / precision_file).string();
}

/// The name of a file in the working folder, as no option.
std::string as_word(const std::string& name) { return name.starts_with('-') ? "./" + name : name; }

/// Writes what the program is given of a verdict into home/NAME-input. Gives the words that name it from
/// home. The folder appears whole or not at all, and replaces only what this function wrote.
Words write_input(const std::string& name, const Verdict::Data& data, const fs::path& home,
                  const std::string& folder) {
    OutputFolder out{home / folder};
    Loaded loaded{data.scene.data().scene, {data.view.data().view}};
    loaded.scene.name = name;
    write_glb(out.working(), loaded);
    write_frame(out.working() / (name + ".exr"), written_frame(data));
    Words words{
        (fs::path(folder) / (name + ".exr")).string(),
        (fs::path(folder) / (name + ".view.json")).string(),
        "--precision",
        write_precision(data.declared, out.working(), folder),
        "--ids",
        write_ids(data.declared, out.working(), folder),
    };
    [[maybe_unused]] const auto kept = out.publish();
    return words;
}

fs::path without_slash(const std::string& folder) {
    require_no_nul("save", folder);
    if (folder.empty()) throw InputError{"save: the folder's name is empty"};
    const fs::path path = fs::absolute(folder);
    return path.has_filename() ? path : path.parent_path();
}

/// That of `zproof compare`, which judges the same.
int expected_status(const Verdict& verdict) {
    if (verdict.is_proven()) return proven;
    return verdict.defect_count() > 0 ? defective : undecided;
}

/// A further oracle would judge itself, not the candidate.
void save_as(const std::string& name, const Verdict& verdict, const fs::path& folder) {
    const fs::path home = folder.parent_path();
    const std::string base = as_word(folder.filename().string());
    Words words = write_input(name, verdict.data(), home, base + input_suffix);
    words.insert(words.begin(), "compare");
    words.insert(words.end(), {"--oracle", "none", "--config", "none", "-o", base, "--quiet"});
    run_program(home, words, expected_status(verdict));
    if (!fs::exists(folder / "results.json"))
        throw std::runtime_error{folder.string() + ": no report was written"};
}

/// Each becomes a folder's, with the input of its report beside it.
void require_names(std::span<const NamedVerdict> verdicts) {
    if (verdicts.empty()) throw InputError{"save: no verdict; expected at least one"};
    std::set<std::string> seen;
    for (const auto& [name, verdict] : verdicts) {
        require_name("save", name);
        if (name.ends_with(input_suffix)) throw InputError{"save: the name '" + name + "' ends in '-input'"};
        if (!seen.insert(name).second) throw InputError{"save: two verdicts are named '" + name + "'"};
    }
}

}  // namespace

void save(const Verdict& verdict, const std::string& folder, const std::string& name) {
    if (!name.empty()) require_name("save", name);
    told_as_input_error(
        [&] { save_as(name.empty() ? verdict.scene().name() : name, verdict, without_slash(folder)); });
}

void save(std::span<const NamedVerdict> verdicts, const std::string& folder) {
    require_names(verdicts);
    told_as_input_error([&] {
        const fs::path home = without_slash(folder);
        for (const auto& [name, verdict] : verdicts) save_as(name, verdict, home / name);
        for (const char* file : {"report.html", "results.json", "junit.xml"}) {
            Words words{"report"};
            for (const auto& [name, verdict] : verdicts) words.push_back(as_word(name));
            words.insert(words.end(), {"-o", file, "--quiet"});
            run_program(home, words, proven);
        }
    });
}

}  // namespace zproof::api
