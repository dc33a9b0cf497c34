/// zproof filters on the command line.
#pragma once

#include <variant>

#include "cli/filters/arguments.h"

namespace zproof {

/// Adds run, list, scenes, table, figure, check, explain and crow below "filters". Both must outlive the
/// parsing.
void add_filters(CLI::App& app, FiltersWords& words);

using FiltersCommand = std::variant<FiltersRunArguments, FiltersListArguments, FiltersScenesArguments,
                                    FiltersTableArguments, FiltersReproduceArguments, FiltersFigureArguments,
                                    FiltersCrowArguments, FiltersCheckArguments, FiltersExplainArguments>;

/// The one that was typed, its words understood. Throws UsageError where none was, or a word means nothing.
FiltersCommand chosen_filters_command(const CLI::App& app, FiltersWords& words);

}  // namespace zproof
