#include "tests/reports/waived_run.h"

namespace zproof {

namespace {

Waiver waiver(const std::string& id, const std::string& expires, int line) {
    return {.id = id,
            .scene = "room",
            .view = "*",
            .classes = {PixelClass::hidden},
            .where = AtPairs{{{PrimitiveId{7}, PrimitiveId::none}}},
            .least = 1,
            .most = 2,
            .reason = "a <sliver> | of 50%, known",
            .link = "https://example.org/1",
            .created = *day_from("2026-01-10"),
            .expires = *day_from(expires),
            .scene_sha256 = std::string(64, 'a'),
            .origin = "ci/waivers.toml:" + std::to_string(line)};
}

ReportedFinding hidden_at(int x, const std::string& by) {
    return {.finding = {.x = x,
                        .y = 1,
                        .verdict = PixelClass::hidden,
                        .candidate = {PrimitiveId{7}, 1},
                        .reference = {PrimitiveId{8}, 1},
                        .eps_px = 0.5,
                        .candidate_depth = {},
                        .error_over_bound = 1},
            .explanation = "Triangle 7 is behind.",
            .command = "zproof explain room " + std::to_string(x) + " 1",
            .waiver = by};
}

ViewResult waived_room() {
    ViewResult v;
    v.scene = "room";
    v.source = "models/room.glb";
    v.view = "main";
    v.outcome = Outcome::defective;
    v.width = 8;
    v.height = 6;
    v.candidate = "zproof";
    v.reference = "embree";
    v.counts[0] = 43;
    v.counts[std::size_t(PixelClass::hidden)] = 3;
    v.counts[std::size_t(PixelClass::wrong_depth)] = 2;
    v.waived[std::size_t(PixelClass::hidden)] = 1;
    v.waived[std::size_t(PixelClass::wrong_depth)] = 2;
    v.waivers = {{"holds", WaiverEffect::holds, 1, 1},
                 {"generous", WaiverEffect::fewer, 2, 2},
                 {"exceeded", WaiverEffect::exceeded, 3, 0},
                 {"expired", WaiverEffect::expired, 3, 0},
                 {"unused", WaiverEffect::none, 0, 0}};
    v.worst = {hidden_at(2, ""), hidden_at(3, ""), hidden_at(1, "holds")};
    v.folder = "scenes/room-main";
    v.scene_sha256 = std::string(64, 'a');
    return v;
}

}  // namespace

Results waived_run() {
    Results r;
    r.version = "0.1.0";
    r.command = "zproof run room";
    r.argv = {"run", "room"};
    r.selection = {1, std::string(64, 'b'), {{".png", 9}, {"", 1}}};
    r.today = "2026-04-10";
    for (const char* id : {"holds", "generous", "exceeded"}) r.waivers.push_back(waiver(id, "2026-04-10", 3));
    r.waivers.push_back(waiver("expired", "2026-04-09", 40));
    r.waivers.push_back(waiver("unused", "2026-05-09", 52));
    r.waivers.push_back(waiver("elsewhere", "2026-05-09", 64));
    r.views = {waived_room()};
    return r;
}

}  // namespace zproof
