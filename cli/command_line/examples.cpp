#include "cli/command_line/examples.h"

#include <array>

namespace zproof {
namespace {

constexpr auto all = std::to_array<Example>({
    {"", "zproof run", "judge the built-in suite, write zproof-out/"},
    {"", "zproof contract-check './mine {scene} {camera} {width} {height} {out}'",
     "does your own renderer keep the contract?"},
    {"", "zproof explain model.glb 812 344", "tell the whole story of one pixel"},
    {"run", "zproof run", "the built-in suite, into zproof-out/"},
    {"run", "zproof run models/ -o out", "every model and .view.json below models/"},
    {"run", "zproof run model.glb --renderer './mine {scene} {camera} {width} {height} {out}'",
     "your own renderer"},
    {"run", "zproof run --random 1000 --seed 7", "random scenes; the first that fail are shrunk"},
    {"compare", "zproof compare frame.exr model.glb --view cam", "one stored frame, against Embree"},
    {"compare", "zproof compare id.npy+z.npy model.glb --view cam --convention pytorch3d",
     "arrays, as PyTorch3D's rasterizer gives them"},
    {"compare", "zproof compare 'frame-{sample}.exr' room --view door --sample standard:4",
     "frames of the samples of a pixel, each at its place"},
    {"compare", "zproof compare a.exr b.exr --scene model.glb",
     "one against the other, and both against the scene"},
    {"explain", "zproof explain model.glb 812 344", "column 812, row 344 of the scene's first view"},
    {"explain", "zproof explain room 812 344 --view floor --renderer opengl",
     "of that view, as OpenGL draws it"},
    {"explain", "zproof explain model.glb 812 344 --candidate frame.exr", "of a stored frame"},
    {"render", "zproof render textured_ground -o out", "VIEW.exr, id, depth and colour pictures"},
    {"render", "zproof render model.glb --filter trilinear-gl", "also VIEW-filtered.exr and .png"},
    {"render", "zproof render model.glb --attributes",
     "the EXR has barycentrics, uv, normals and positions, too"},
    {"render", "zproof render model.glb --filter nearest:uv=affine", "a filter with a setting"},
    {"measure", "zproof measure zproof", "a table: measured, declared, and whether it is kept"},
    {"measure", "zproof measure zproof --json", "the same for programs"},
    {"measure", "zproof measure opengl", "an OpenGL driver"},
    {"measure", "zproof measure zproof --emit measured.json", "what was measured, as --precision takes it"},
    {"fit", "zproof fit room --renderer opengl", "how far an OpenGL driver errs"},
    {"fit", "zproof fit model.glb --candidate frame.exr --view cam", "how far a stored frame does"},
    {"selfcheck", "zproof selfcheck --renderer './mine {scene} {camera} {width} {height} {out}'",
     "the suite in seven other words, at 480 x 270"},
    {"selfcheck", "zproof selfcheck model.glb --renderer opengl --width 960 --height 540",
     "an OpenGL driver"},
    {"contract-check", "zproof contract-check './mine {scene} {camera} {width} {height} {out}'",
     "three small scenes; what is wrong is said in words"},
    {"contract-check",
     "zproof contract-check './mine {scene} {camera} {width} {height} {out}' --precision ray",
     "judged as a ray caster"},
    {"selftest", "zproof selftest", "known faults, each injected into a good frame"},
    {"selftest", "zproof selftest --threads 1", "the same verdicts on one thread"},
    {"merge", "zproof merge shard-1 shard-2 -o zproof-out", "the files of one run of both"},
    {"report", "zproof report zproof-out -o summary.md", "any report again; the file's ending chooses"},
    {"report", "zproof report zproof-out zproof-study -o all.html", "the page with a study at its end"},
    {"report", "zproof report zproof-out --format github -o -", "annotations on stdout"},
    {"diff-results", "zproof diff-results main/zproof-out mine/zproof-out", "what became better or worse"},
    {"diff-results", "zproof diff-results old.json new.json --json", "the same for programs"},
    {"waive",
     "zproof waive add --waivers waivers.toml --from zproof-out --scene room --view door --pixel 812,344 "
     "--reason 'mended by the new clipper' --link https://example.org/12 --expires 2026-12-31",
     "a defect that was looked at may stay until that day"},
    {"waive", "zproof waive check --waivers waivers.toml", "sound, and none has run out?"},
    {"waive", "zproof waive prune --waivers waivers.toml", "remove those that have run out"},
    {"waive list", "zproof waive list --waivers waivers.toml", "each with the days it has left"},
    {"waive check", "zproof waive check --waivers waivers.toml", "sound, and none has run out?"},
    {"waive check", "zproof waive check --waivers waivers.toml --from zproof-out --strict",
     "and all needed?"},
    {"waive prune", "zproof waive prune --waivers waivers.toml", "remove those that have run out"},
    {"waive add",
     "zproof waive add --waivers waivers.toml --from zproof-out --scene room --view door --pixel 812,344 "
     "--reason 'mended by the new clipper' --link https://example.org/12 --expires 2026-12-31",
     "the pixels with that pixel's two triangles"},
    {"doctor", "zproof doctor", "every setting with its value and where it comes from"},
    {"doctor", "zproof doctor --profile ci", "as another profile has them"},
    {"list", "zproof list", "the built-in suite, each scene with its reason"},
    {"scenes", "zproof scenes generate", "the whole suite, into zproof-scenes/"},
    {"scenes", "zproof scenes generate room oblique -o scenes", "two scenes of it"},
    {"scenes generate", "zproof scenes generate", "the whole suite, into zproof-scenes/"},
    {"scenes generate", "zproof scenes generate room oblique -o scenes", "two scenes of it"},
    {"scenes random", "zproof scenes random --kind clipped --count 5 -o scenes", "five of one kind"},
    {"views", "zproof views colmap sparse/0 model.glb --near 0.1 -o model.view.json",
     "the images of a COLMAP model (text files)"},
    {"views",
     "zproof views nerf transforms.json model.glb --near 0.1 --width 800 --height 800 -o a.view.json",
     "the cameras of a NeRF"},
    {"views", "zproof views opencv cameras.json model.glb --near 0.1 --far 50 -o model.view.json",
     "K, R and t"},
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
    {"filters crow", "zproof filters crow -o crow", "the lecture's figure and its questions, answered"},
    {"study", "zproof study projection model.glb -o study", "every route from world to pixel"},
    {"study", "zproof study depth -o depth", "what each depth format can tell apart"},
    {"study", "zproof study cost -o cost", "what a frame costs, and what it should"},
    {"study projection", "zproof study projection",
     "two scenes of the suite, every route from world to pixel"},
    {"study projection", "zproof study projection model.glb -o study", "a scene of your own"},
    {"study depth", "zproof study depth -o depth", "what each depth format can tell apart"},
    {"study shading", "zproof study shading -o shading", "what interpolation does to light"},
    {"study cost", "zproof study cost -o cost", "what a frame costs, and what it should"},
    {"completion", "zproof completion bash > zproof.bash", "then: source zproof.bash"},
    {"completion", "zproof completion fish > zproof.fish", "for ~/.config/fish/completions/"},
    {"man", "zproof man > zproof.1", "then: man ./zproof.1"},
});

constexpr std::size_t column = 40;

}  // namespace

std::span<const Example> examples() { return all; }

std::string examples_in_words(std::string_view command) {
    std::string text;
    for (const Example& example : all) {
        if (example.command != command) continue;
        std::string line = "  " + std::string{example.line};
        if (line.size() + 2 > column) line += "\n";
        const std::size_t used = line.back() == '\n' ? 0 : line.size();
        text += line + std::string(column - used, ' ') + std::string{example.meaning} + "\n";
    }
    return text;
}

}  // namespace zproof
