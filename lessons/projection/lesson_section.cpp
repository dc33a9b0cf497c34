#include "lessons/projection/conformance.h"
#include "lessons/projection/sections.h"
#include "lessons/projection/worked_example.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using namespace study::projection;
using document::Table;

std::string verdict_of(const RouteFinding& f) {
    if (f.is_projection()) return "is the projection";
    return "is not the projection: first wrong stage: " + f.first_wrong_stage + " (" + f.operation +
           "), with " + f.camera;
}

Table routes_table() {
    Table table{
        .name = "lesson-routes",
        .caption = "Is the route the projection? Tried in exact arithmetic on probe cameras",
        .columns = {{"route", "", ""},
                    {"finding", "",
                     "The first stage whose result is not where the line of visibility has it."},
                    {"cameras", "", "Probe cameras that it was tried on, 60 points each."},
                    {"kept on", "", "Cameras on which it is the projection all the same."},
                    {"worst", "px", "Largest distance in x or y from the admissible raster position."},
                    {"what it is", "", ""},
                    {"source", "", ""}},
        .rows = {}};
    for (const RouteFinding& f : route_findings())
        table.rows.push_back({f.card.name, verdict_of(f), std::int64_t(f.cameras),
                              std::int64_t(f.cameras_kept), f.worst_px, f.card.words, f.card.source});
    return table;
}

Table visibility_table() {
    Table table{.name = "lesson-visibility",
                .caption = "Is the visibility test right? On a lattice over three times the canvas",
                .columns = {{"test", "", ""},
                            {"visible where", "", "P' on the image plane, canvas of width W and height H."},
                            {"places", "", ""},
                            {"shown wrongly", "", "Called visible, but not on the canvas."},
                            {"hidden wrongly", "", ""},
                            {"for instance", "", ""},
                            {"source", "", ""}},
                .rows = {}};
    for (const VisibilityFinding& f : visibility_findings())
        table.rows.push_back({f.name, f.formula, std::int64_t(f.points), std::int64_t(f.shown_wrongly),
                              std::int64_t(f.hidden_wrongly), f.example, f.source});
    return table;
}

Table worked_table() {
    Table table{.name = "lesson-worked-example",
                .caption = "The worked example: a corner of the cube, local to world space and back",
                .columns = {{"what", "", ""},
                            {"numbers", "", ""},
                            {"result", "", "To six significant digits."},
                            {"the lesson prints", "", ""},
                            {"x", "", ""},
                            {"y", "", ""},
                            {"z", "", ""}},
                .rows = {}};
    for (const WorkedStep& step : worked_example())
        table.rows.push_back({step.what, step.numbers, step.printed, step.lesson, step.result[0],
                              step.result[1], step.result[2]});
    return table;
}

}  // namespace

document::Section lesson_section() {
    return {
        "The lessons' formulas",
        {"Every route from world to raster space is run in exact arithmetic, and after each stage the point "
         "is "
         "held against the line of visibility that the camera defines. A route that is printed in a lesson "
         "and "
         "is wrong is told by the same means as one that is right.",
         "On a canvas from -1 to 1 with near at 1, screen space is NDC space: there the listing that takes "
         "one "
         "for the other goes unnoticed."},
        {routes_table(), visibility_table(), worked_table()}};
}

}  // namespace zproof
