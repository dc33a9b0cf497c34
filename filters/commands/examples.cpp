#include <array>

#include "filters/commands/command_line.h"

namespace zproof::filters_program {
namespace {

constexpr auto all = std::to_array<Example>({
    {"filters", "zproof filters run checker_plane --view phi-45 --methods nearest,ewa-true -o study",
     "two methods on one view, held to the truth"},
    {"filters", "zproof filters table study", "that study's figures on the terminal"},
    {"filters", "zproof filters check trilinear-gl checker_plane --view phi-45",
     "does a method compute its own definition?"},
    {"filters run", "zproof filters run checker_plane --view phi-45 --methods nearest,ewa-true -o study",
     "two methods on one view"},
    {"filters run", "zproof filters run checker_plane --view phi-45 --truth B -o study",
     "every method on one view"},
    {"filters run", "zproof filters run worked --methods all,sat-strips:n=16", "a method with a setting"},
    {"filters run", "zproof filters run worked --view phi-0 --picture mine=mine.exr",
     "your renderer's picture beside them"},
    {"filters run",
     "zproof filters run worked --view phi-0 --picture mine=mine.exr --claim mine=trilinear-gl",
     "and what the method permits it to show"},
    {"filters run", "zproof filters run model.glb --methods nearest,trilinear-gl,ewa-true",
     "three methods on a scene of your own"},
    {"filters list", "zproof filters list", "methods, metrics and scenes"},
    {"filters scenes", "zproof filters scenes -o scenes", "every filter scene as .glb and .view.json"},
    {"filters scenes", "zproof filters scenes tunnel worked -o scenes", "two of them"},
    {"filters reproduce", "zproof filters reproduce", "every published result that zproof computes again"},
    {"filters reproduce", "zproof filters reproduce hensley-2005", "one of them"},
    {"filters table", "zproof filters table study", "a study's figures on the terminal"},
    {"filters table", "zproof filters table study --region silhouette --latex",
     "another region, as a LaTeX table"},
    {"filters table", "zproof filters table study --columns psnr,flip,texels --sort psnr", "the best first"},
    {"filters table", "zproof filters table study --pooled --baseline nearest",
     "all textures together, with intervals"},
    {"filters figure", "zproof filters figure study --methods ewa-true,nearest",
     "plots that name these two in colour"},
    {"filters figure", "zproof filters figure study --crop 16,24,32,32", "crops of this part of the picture"},
    {"filters check", "zproof filters check trilinear-gl checker_plane --view phi-45",
     "one method on one view"},
    {"filters check", "zproof filters check all", "every method on every filter scene"},
    {"filters check",
     "zproof filters check trilinear-gl worked --view phi-0 --picture mine.exr --precision gpu",
     "your own picture (R, G, B, linear light) of that view"},
    {"filters explain", "zproof filters explain worked --view phi-45 --pixel 120,60 --method trilinear-gl",
     "the texels that it reads there, their weights, and the pixel's own"},
    {"filters selftest", "zproof filters selftest", "the judge of filters sees known faults"},
    {"filters normals", "zproof filters normals --view phi-45 --shininess 128",
     "Toksvig's and LEAN's highlights of bumps, held to their exact mean"},
    {"filters crow", "zproof filters crow -o crow", "the lecture's figure and its questions, answered"},
});

}  // namespace

Examples examples() { return all; }

}  // namespace zproof::filters_program
