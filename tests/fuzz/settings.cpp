// zproof.toml, and behind a 0 what every ZPROOF_ variable says.
#include "program/settings/sources.h"
#include "program/usage_error.h"
#include "reports/report_error.h"
#include "tests/fuzz/scratch_folder.h"

namespace zproof::fuzz {

void read_input(Input input) {
    static const ScratchFolder folder;
    const auto [toml, variables] = split_at_zero(input);
    const std::string value = text_of(variables);
    const Environment environment = [&](const std::string& name) {
        return name == "ZPROOF_CONFIG" || value.empty() ? nullptr : value.c_str();
    };
    const SettingsChoice choice{.file = folder.write("zproof.toml", toml).string(), .profile = ""};
    may_refuse<UsageError, ReportError>([&] { settings_here(choice, environment); });
}

}  // namespace zproof::fuzz
