/// Tight beyond: what needs more than was promised is a defect, but for what docs/attack.md publishes.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/attack/tightness.h"

namespace zproof::attack {
namespace {

/// Where nothing else is published, a pixel a hundredth beyond the promise fails.
constexpr double goal = 1.01;

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    for (std::size_t at = 1; at < line.size();) {
        const std::size_t end = line.find('|', at);
        if (end == std::string::npos) break;
        std::string cell = line.substr(at, end - at);
        cell.erase(0, cell.find_first_not_of(" `"));
        cell.erase(cell.find_last_not_of(" `") + 1);
        cells.push_back(cell);
        at = end + 1;
    }
    return cells;
}

/// How far beyond its promise a pixel passes, by the page's table: wrong, promise, passes up to, reason.
std::map<Row, double> published() {
    std::ifstream page(ZPROOF_SOURCE_DIR "/docs/attack.md");
    std::map<Row, double> limits;
    bool is_in_table = false;
    for (std::string line; std::getline(page, line);) {
        const std::vector<std::string> cells = cells_of(line);
        if (line.starts_with("| wrong | promise |")) is_in_table = true;
        if (!line.starts_with("|")) is_in_table = false;
        if (is_in_table && cells.size() >= 4 && std::isdigit(static_cast<unsigned char>(cells[2].front())))
            limits[{cells[0], cells[1]}] = std::stod(cells[2]);
    }
    return limits;
}

void expect_published(const Tightness& tightness) {
    const std::map<Row, double> limits = published();
    EXPECT_FALSE(limits.empty());
    for (const auto& [row, tally] : tightness.rows()) {
        EXPECT_TRUE(limits.contains(row)) << row.wrong << ", " << row.promise << " is not on the page";
        const double limit = limits.contains(row) ? limits.at(row) : goal;
        EXPECT_TRUE(tally.passed == 0 || (limit > goal && tally.farthest <= limit))
            << row.wrong << ", " << row.promise << ": " << tally.passed << " of " << tally.planted
            << " pass, up to " << tally.farthest << " times the promise: " << tally.where;
    }
}

constexpr std::size_t slices = 4;

class TightBeyond : public testing::TestWithParam<std::size_t> {};

TEST_P(TightBeyond, FailsInHandMadeScenes) {
    Tightness tightness;
    const std::vector<AttackScene> scenes = hand_made_scenes();
    for (std::size_t i = GetParam(); i < scenes.size(); i += 2 * slices) tightness.plant_in(scenes[i]);
    EXPECT_GT(tightness.planted(), 10'000u);
    expect_published(tightness);
}

TEST_P(TightBeyond, FailsInRandomScenes) {
    Tightness tightness;
    for (std::uint64_t n = GetParam(); tightness.planted() < 20'000; n += slices) {
        const AttackScene scene = random_attack_scene(62, n);
        if (scene.scene.triangles.size() <= most_planted_triangles) tightness.plant_in(scene);
    }
    expect_published(tightness);
}

INSTANTIATE_TEST_SUITE_P(Sample, TightBeyond, testing::Range<std::size_t>(0, slices));

/// A quarter of a million pixels and more in each.
class TightBeyondAtScale : public testing::TestWithParam<std::size_t> {};

TEST_P(TightBeyondAtScale, FailsEverywhere) {
    Tightness tightness;
    for (std::uint64_t n = 0; tightness.planted() < 250'000; ++n) {
        const AttackScene scene = random_attack_scene(63 + GetParam(), n);
        if (scene.scene.triangles.size() <= most_planted_triangles) tightness.plant_in(scene);
    }
    const std::vector<AttackScene> scenes = hand_made_scenes();
    for (std::size_t i = GetParam(); i < scenes.size(); i += slices) tightness.plant_in(scenes[i]);
    expect_published(tightness);
}

INSTANTIATE_TEST_SUITE_P(Slow, TightBeyondAtScale, testing::Range<std::size_t>(0, slices));

}  // namespace
}  // namespace zproof::attack
