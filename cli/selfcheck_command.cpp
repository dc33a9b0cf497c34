#include <iostream>

#include "cli/commands.h"
#include "cli/memory.h"
#include "frame/printable.h"
#include "measure/selfcheck/selfcheck.h"
#include "oracle/oracle_error.h"
#include "program/common_arguments.h"
#include "program/interrupt.h"
#include "program/scene_selection.h"
#include "program/work_progress.h"
#include "renderers/registry.h"
#include "reports/notes.h"
#include "reports/wording.h"
#include "scenes/judged_ranges.h"
#include "scenes/scene_error.h"

namespace zproof {
namespace {

/// What came of all variants so far.
struct SelfcheckTally {
    Share views{0, 0};
    std::uint64_t pairs = 0;    ///< of a view and a variant
    std::uint64_t defects = 0;  ///< of these, with a frame that is wrong
    int missing = 0;            ///< scenes, views and variants that cannot be read or drawn
    NoteKinds notes{};
};

std::uint64_t pixels_that_differ(const ClassCounts& counts) {
    std::uint64_t sum = 0;
    for (std::size_t c = 0; c < counts.size(); ++c) sum += PixelClass(c) == PixelClass::agree ? 0 : counts[c];
    return sum;
}

std::string in_words(const measure::VariantResult& result) {
    if (!result.was_drawn) return "not drawn: the picture is too small, or would be too large";
    const std::uint64_t differ = pixels_that_differ(result.counts),
                        wrong = result.defects + result.original_defects;
    if (wrong == 0 && differ == 0) return "the same";
    if (wrong == 0) return counted(differ, "pixel") + " admissibly different";
    std::string text = counted(result.defects, "pixel") + " wrong";
    if (result.original_defects > 0)
        text += ", and " + counted(result.original_defects, "pixel") + " of the original";
    return text + "\n    first: " + result.first_defect;
}

class Selfcheck {
  public:
    Selfcheck(const SelfcheckArguments& arguments, WorkProgress& progress)
        : arguments_(arguments), progress_(progress), renderer_(measured_renderer(arguments.renderer)) {}

    void check(const SceneSource& source) {
        try {
            const Loaded loaded = load(source, arguments_.settings.resolution);
            tally_.notes.add(source.name, loaded.scene.notes);
            tally_.views.all += loaded.views.size();
            progress_.expect_more(double(loaded.views.size()) - 1);
            for (const View& view : loaded.views)
                if (!interrupted()) check_guarded(loaded.scene, view);
        } catch (const SceneError& e) {
            tell_missing(source.name, e.what());
        }
    }

    SelfcheckTally& tally() { return tally_; }

  private:
    void check_guarded(const Scene& scene, const View& view) {
        const std::string name = scene.name + "/" + view.name;
        progress_.begin(name);
        try {
            require_judged(view);
            require_memory({3 * view.width, 3 * view.height});
            check(scene, view, name);
        } catch (const OracleError& e) {
            tell_missing(name, e.what());
        } catch (const SceneError& e) {
            tell_missing(name, e.what());
        }
        ++tally_.views.done;
    }

    void check(const Scene& scene, const View& view, const std::string& name) {
        const Frame original = renderer_.render(scene, view);
        for (const measure::Variant& variant : measure::variants()) {
            if (interrupted()) return;
            const std::string pair = name + ", " + variant.name;
            try {
                tell(pair, measure::check_variant(renderer_, scene, view, original, variant));
            } catch (const OracleError& e) {
                tell_missing(pair, e.what());
            }
        }
    }

    void tell(const std::string& pair, const measure::VariantResult& result) {
        tally_.pairs += result.was_drawn;
        tally_.defects += result.defects + result.original_defects > 0;
        if (!arguments_.common.is_quiet()) progress_.say(std::cout, pair + ": " + in_words(result) + "\n");
    }

    void tell_missing(const std::string& name, const std::string& why) {
        ++tally_.missing;
        progress_.say(std::cerr, shortened("zproof: " + name + ": " + why, longest_line_bytes) + "\n");
    }

    const SelfcheckArguments& arguments_;
    WorkProgress& progress_;
    measure::Renderer renderer_;
    SelfcheckTally tally_;
};

SelfcheckTally check_all(const SelfcheckArguments& arguments, const std::vector<SceneSource>& sources) {
    WorkProgress progress{std::cerr, progress_beside_lines(arguments.common), double(sources.size())};
    Selfcheck selfcheck(arguments, progress);
    on_threads(arguments.common.threads, [&] {
        for (std::size_t i = 0; i < sources.size(); ++i) {
            if (interrupted()) selfcheck.tally().views.scenes_left = sources.size() - i;
            if (interrupted()) return;
            selfcheck.check(sources[i]);
        }
    });
    return selfcheck.tally();
}

ExitCode conclusion(const SelfcheckTally& tally) {
    std::cout << counted(tally.views.done, "view") << ", " << counted(tally.pairs, "variant") << ": "
              << (tally.defects == 0 ? "no frame contradicts another"
                                     : counted(tally.defects, "variant") + " with wrong pixels")
              << (tally.missing == 0 ? "" : "; " + std::to_string(tally.missing) + " could not be drawn")
              << "\n"
              << std::flush;
    if (tally.views.done < tally.views.all || tally.views.scenes_left > 0)
        return say_interrupted(tally.views, "view", "checked");
    if (tally.missing > 0) return ExitCode::cannot_judge;
    if (tally.pairs == 0) return ExitCode::nothing;
    return tally.defects == 0 ? ExitCode::proven : ExitCode::defect;
}

}  // namespace

ExitCode execute(const SelfcheckArguments& arguments) {
    const std::vector<SceneSource> sources = select_scenes(arguments.scenes);
    note_interrupts();
    const SelfcheckTally tally = check_all(arguments, sources);
    if (!arguments.common.is_quiet()) std::cerr << tally.notes.lines();
    return conclusion(tally);
}

}  // namespace zproof
