/// A command line with every setting typed out.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace zproof {

/// The heading in the help of options that say how a run is shared out.
inline constexpr const char* plan_options = "Plan";

/// The words of a run that mean what `app`, which has been parsed and given its settings, means: all that
/// bears on the judgement, and nothing of the machine. It listens to no settings.
std::vector<std::string> explicit_run_words(const CLI::App& app);

/// With a plan nothing else may be typed. Throws UsageError.
void require_machine_words(const CLI::App& run);

}  // namespace zproof
