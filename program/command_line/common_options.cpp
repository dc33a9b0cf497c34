#include "program/command_line/common_options.h"

#include "math/processor.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

const std::map<std::string, ColourMode> colour_modes{
    {"auto", ColourMode::automatic}, {"always", ColourMode::always}, {"never", ColourMode::never}};
const std::map<std::string, ProgressStyle> progress_styles{{"auto", ProgressStyle::automatic},
                                                           {"bar", ProgressStyle::bar},
                                                           {"lines", ProgressStyle::lines},
                                                           {"never", ProgressStyle::none},
                                                           {"none", ProgressStyle::none}};

void add_out(CLI::App& app, CommonArguments& common, const std::string& made) {
    CLI::Option* out =
        app.add_option("-o,--out", common.out, made.empty() ? "file for what is printed; -: stdout" : made)
            ->type_name(common.output == Output::folder ? "FOLDER" : "FILE")
            ->group(machine_options);
    if (made.empty())
        out->default_str("-");
    else if (!common.out.empty())
        out->capture_default_str();
}

}  // namespace

void add_common(CLI::App& app, CommonArguments& common, const std::string& made) {
    app.add_option("-j,--threads", common.threads, "at most so many; no result depends on their number")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str()
        ->group(machine_options);
    add_choice(app, "--color", common.colour, colour_modes)
        ->description("of what is printed; auto: on a terminal, unless NO_COLOR is set")
        ->group(machine_options);
    app.add_flag_callback(
           "-q,--quiet", [&common] { common.detail = Detail::verdict; },
           "print nothing but the result and errors")
        ->group(machine_options);
    add_out(app, common, made);
}

void add_progress(CLI::App& app, CommonArguments& common) {
    add_choice(app, "--progress", common.progress, progress_styles)
        ->description("how it is told on stderr; auto: a bar on a terminal, else lines")
        ->group(machine_options);
}

void add_isa(CLI::App& app) {
    std::vector<std::string> names;
    for (const InstructionSet set : {InstructionSet::scalar, InstructionSet::avx2, InstructionSet::avx512})
        names.emplace_back(name_of(set));
    app.add_option_function<std::string>(
           "--isa",
           [](const std::string& word) {
               try {
                   allow_at_most(instruction_set_from(word));
               } catch (const InstructionSetError& e) {
                   throw UsageError{std::string{"--isa: "} + e.what()};
               }
           },
           "the widest instruction set of zproof's own code; no bit depends on it")
        ->type_name("TEXT:" + CLI::detail::generate_set(names))
        ->default_str("all that the processor has")
        ->group(machine_options);
}

}  // namespace zproof
