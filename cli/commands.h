/// The commands of zproof. Results go to stdout, progress and remarks to stderr; what cannot be done is
/// thrown as UsageError, SceneError, OracleError, FrameError or ReportError.
#pragma once

#include "cli/arguments.h"
#include "cli/exit_code.h"

namespace zproof {

/// Judges every view of every selected scene and writes results.json, junit.xml, report.html and the
/// evidence. An unreadable scene is reported and the run goes on; an interrupt ends it after the stage in
/// hand.
ExitCode execute(const RunArguments& arguments);

/// Prints the story of one pixel; proven or defect is that pixel's verdict. UsageError where (x, y) lies
/// outside the view or there is no such view.
ExitCode execute(const ExplainArguments& arguments);

/// Writes the rasterizer's frame of every view, without judging it: VIEW.exr, VIEW-id.png, VIEW-depth.png.
ExitCode execute(const RenderArguments& arguments);

/// Measures a renderer and prints what it does beside what it declares; a defect where it is worse.
/// UsageError where there is no such renderer.
ExitCode execute(const MeasureArguments& arguments);

/// Prints the suite: each scene with its reason and the classes that it must show.
ExitCode execute(const ListArguments& arguments);

/// Writes suite scenes as NAME.glb and NAME.view.json.
ExitCode execute(const GenerateArguments& arguments);

/// Prints the text that was asked for.
ExitCode execute(const Answered& answered);

}  // namespace zproof
