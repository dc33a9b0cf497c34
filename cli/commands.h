/// The commands of zproof. Results go to stdout, progress and remarks to stderr; what cannot be done is
/// thrown as UsageError, SceneError, OracleError, FrameError or ReportError.
#pragma once

#include "cli/arguments.h"
#include "program/exit_code.h"

namespace zproof {

/// Judges every view of every selected scene and writes results.json, junit.xml, report.html and the
/// evidence. An unreadable scene is reported and the run goes on; an interrupt ends it after the stage in
/// hand.
ExitCode execute(const RunArguments& arguments);

/// Judges a stored frame, or one against another, and writes what a run writes. UsageError where it is not
/// clear which view the frame is of.
ExitCode execute(const CompareArguments& arguments);

/// Prints the story of one pixel; proven or defect is that pixel's verdict. UsageError where (x, y) lies
/// outside the view or there is no such view.
ExitCode execute(const ExplainArguments& arguments);

/// Writes a renderer's frame of every view, without judging it: VIEW.exr, VIEW-id.png, VIEW-depth.png.
ExitCode execute(const RenderArguments& arguments);

/// Measures a renderer and prints what it does beside what it declares; a defect where it is worse.
ExitCode execute(const MeasureArguments& arguments);

/// Finds the least promise that explains a renderer's frames or a stored one, prints it and writes a folder;
/// a defect where a pixel is left out. UsageError where it is not clear which view a frame is of.
ExitCode execute(const FitArguments& arguments);

/// Has a renderer draw each picture once more, told in other ways, and prints where its frames contradict one
/// another; a defect where one of them is inadmissible.
ExitCode execute(const SelfcheckArguments& arguments);

/// Judges a renderer on the suite and on random scenes, measures it, and writes one page of promises, figures
/// and verdicts, with what a run writes.
ExitCode execute(const ConformanceArguments& arguments);

/// Has a program draw three small scenes and says in words what is wrong with them.
ExitCode execute(const ContractCheckArguments& arguments);

/// Injects every known fault into good frames and prints what the gate says of each: proven where it catches
/// all of them and passes the good frames.
ExitCode execute(const SelftestArguments& arguments);

/// Gives each view of one or more runs to a shard, writes the plan, and prints each shard's command.
ExitCode execute(const PlanArguments& arguments);

/// Puts the shards of one run together: the files of one run of them all, and its verdict. ReportError where
/// they are not the shards of one run.
ExitCode execute(const MergeArguments& arguments);

/// Writes a report of results that are already there.
ExitCode execute(const ReportAgainArguments& arguments);

/// Prints what differs between two runs; a defect where the newer is worse.
ExitCode execute(const DiffResultsArguments& arguments);

/// Prints the waivers.
ExitCode execute(const WaiveListArguments& arguments);

/// Prints which waivers need a hand; a defect where one has run out, or is not needed and --strict.
ExitCode execute(const WaiveCheckArguments& arguments);

/// Removes waivers that have run out or let nothing pass.
ExitCode execute(const WaivePruneArguments& arguments);

/// Adds a waiver for the defects around a pixel; UsageError where there is no defect.
ExitCode execute(const WaiveAddArguments& arguments);

/// Prints what is installed and which settings hold; cannot_judge where what they need is not here.
ExitCode execute(const DoctorArguments& arguments);

/// Prints the suite: each scene with its reason and the classes that it must show.
ExitCode execute(const ListArguments& arguments);

/// Writes suite scenes as NAME.glb and NAME.view.json. SceneError for a scene that there is not, before
/// anything is written.
ExitCode execute(const GenerateArguments& arguments);

/// Writes random scenes as files of the same kinds, named by their words with "-" for ":".
ExitCode execute(const RandomScenesArguments& arguments);

/// Writes a renderer to begin with, its settings and a gate, and prints the next command. UsageError, before
/// anything is written, where one of its files is there and says something else.
ExitCode execute(const InitArguments& arguments);

/// Writes a view file of a model from another program's cameras, and prints by how much they had to be
/// changed. SceneError where they are no pinholes or no rotations.
ExitCode execute(const ViewsArguments& arguments);

}  // namespace zproof
