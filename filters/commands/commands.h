/// The commands of zproof filters. Results go to stdout, progress and remarks to stderr; what cannot be done
/// is thrown as UsageError, SceneError, OracleError, FrameError or ReportError.
#pragma once

#include "filters/commands/arguments.h"
#include "program/exit_code.h"

namespace zproof {

/// Holds texture filters to the truth, scene by scene, and writes a study (docs/filters.md). SceneError for a
/// scene that there is not. An interrupt ends it after the method in hand; what was done is written.
ExitCode execute(const FiltersRunArguments& arguments);

/// Prints the filter methods with their definitions, the metrics and the filter scenes.
ExitCode execute(const FiltersListArguments& arguments);

/// Writes filter scenes as NAME.glb and NAME.view.json. SceneError for one that there is not, before anything
/// is written.
ExitCode execute(const FiltersScenesArguments& arguments);

/// Prints a study's table.
ExitCode execute(const FiltersTableArguments& arguments);

/// Prints published figures beside those that zproof computes; a defect where one is not confirmed.
ExitCode execute(const FiltersReproduceArguments& arguments);

/// Makes a study's figures and page again, as chosen.
ExitCode execute(const FiltersFigureArguments& arguments);

/// Holds pictures of filters against the filter reference of their method and prints what is outside, by how
/// much and which rule is at fault; a defect where anything is. UsageError where a method has no filter
/// reference.
ExitCode execute(const FiltersCheckArguments& arguments);

/// Prints what methods read at one pixel of a view, beside what the pixel covers. UsageError for a pixel
/// outside the view.
ExitCode execute(const FiltersExplainArguments& arguments);

/// Writes the page that answers the lecture's questions about Crow 1984.
ExitCode execute(const FiltersCrowArguments& arguments);

/// Prints how far highlights of filtered normals are from their exact mean.
ExitCode execute(const FiltersNormalsArguments& arguments);

/// Writes VIEW-filtered.exr and .png beside each VIEW.exr of a folder, or checks the words alone.
ExitCode execute(const FiltersFilteredArguments& arguments);

/// Plants every known fault in filters and prints what their judge says of each: proven where it catches all
/// of them and passes the good ones.
ExitCode execute(const FiltersSelftestArguments& arguments);

}  // namespace zproof
