/// The commands, each with its options: one function adds one command to the tree. Words must outlive it.
#pragma once

#include "cli/command_line/words.h"

namespace zproof {

Branch add_run(CLI::App& parent, CommandWords& words);
Branch add_compare(CLI::App& parent, CommandWords& words);
Branch add_explain(CLI::App& parent, CommandWords& words);
Branch add_render(CLI::App& parent, CommandWords& words);
Branch add_measure(CLI::App& parent, CommandWords& words);
Branch add_fit(CLI::App& parent, CommandWords& words);
Branch add_selfcheck(CLI::App& parent, CommandWords& words);
Branch add_conformance(CLI::App& parent, CommandWords& words);
Branch add_contract_check(CLI::App& parent, CommandWords& words);
Branch add_selftest(CLI::App& parent, CommandWords& words);
Branch add_merge(CLI::App& parent, CommandWords& words);
Branch add_plan(CLI::App& parent, CommandWords& words);
Branch add_report_again(CLI::App& parent, CommandWords& words);
Branch add_diff_results(CLI::App& parent, CommandWords& words);
Branch add_waive(CLI::App& parent, CommandWords& words);
Branch add_doctor(CLI::App& parent, CommandWords& words);
Branch add_list(CLI::App& parent, CommandWords& words);
Branch add_scenes(CLI::App& parent, CommandWords& words);
Branch add_views(CLI::App& parent, CommandWords& words);
Branch add_init(CLI::App& parent, CommandWords& words);
Branch add_completion(CLI::App& parent, CommandWords& words);
Branch add_man(CLI::App& parent, CommandWords& words);

}  // namespace zproof
