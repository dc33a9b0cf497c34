#include "reports/planes/view_planes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <string_view>

#include "reports/planes/deflate.h"
#include "reports/planes/error_code.h"
#include "tests/reports/plane_decoder.h"
#include "tests/reports/sample.h"

namespace zproof::planes {
namespace {

using Numbers = std::vector<std::uint32_t>;

constexpr std::uint32_t background = 0xFFFF'FFFF;

/// Ids that a float, a signed or a 24-bit number would lose, and depths that are no numbers.
Numbers hard_words() {
    constexpr std::uint32_t two24 = 1u << 24;
    return {0,
            1,
            two24 - 1,
            two24,
            two24 + 1,
            0x7FFF'FFFF,
            0x8000'0000,
            background - 1,
            background,
            0,
            std::bit_cast<std::uint32_t>(std::numeric_limits<float>::quiet_NaN()),
            std::bit_cast<std::uint32_t>(-std::numeric_limits<float>::infinity()),
            std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity()),
            std::bit_cast<std::uint32_t>(-0.0f),
            std::bit_cast<std::uint32_t>(std::numeric_limits<float>::denorm_min()),
            0xFF80'0001};
}

Numbers random_words(std::size_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    Numbers words(count);
    for (std::uint32_t& word : words) word = std::uint32_t(random() >> (random() % 32));
    return words;
}

TEST(PlaneCoding, GivesBackEveryBitWhateverTheWidth) {
    for (const Prediction prediction : {Prediction::left, Prediction::planar})
        for (const std::size_t width : {1u, 2u, 4u, 8u, 16u})
            for (const Numbers& words :
                 {hard_words(), random_words(64, 7), Numbers(16, background), Numbers(16, 0)}) {
                const std::string bytes = encode(words, width, prediction);
                EXPECT_EQ(decode(bytes, words.size(), width, prediction), words) << width;
            }
}

TEST(PlaneCoding, GivesBackEveryBitBesideAGuess) {
    const Numbers words = hard_words(), guess = random_words(words.size(), 3);
    EXPECT_EQ(decode(encode(words, guess), guess), words);
    EXPECT_EQ(decode(encode(words, words), words), words);
    EXPECT_EQ(missed_by(words, guess), words.size());
    EXPECT_EQ(decode_sparse(encode_sparse(words, guess), words.size(), guess), words);
    Numbers nearly = guess;
    nearly[5] = background - 1;
    EXPECT_EQ(missed_by(nearly, guess), 1u);
    EXPECT_EQ(decode_sparse(encode_sparse(nearly, guess), 1, guess), nearly);
    EXPECT_EQ(decode_sparse(encode_sparse(guess, guess), 0, guess), guess);
    EXPECT_THROW(decode_sparse(encode_sparse(nearly, guess), 1, std::span(guess).first(5)), ReportError);
}

/// Most pieces hold small numbers, some between them large ones.
TEST(PlaneCoding, GivesBackEveryBitOfWhatIsPackedInPieces) {
    constexpr std::size_t width = 1777, height = 400;
    Numbers words(width * height), guess = random_words(words.size(), 5);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = std::uint32_t(i / 300);
    words[words.size() / 2] = 0xFEDC'BA98;
    for (const Prediction prediction : {Prediction::left, Prediction::planar}) {
        EXPECT_EQ(decode(encode(words, width, prediction), words.size(), width, prediction), words);
        EXPECT_EQ(decode(encode(guess, width, prediction), guess.size(), width, prediction), guess);
    }
    EXPECT_EQ(decode(encode(words, guess), guess), words);
    Numbers nearly = guess;
    for (const std::size_t i : {std::size_t{0}, std::size_t{1023}, std::size_t{1024}, guess.size() - 1})
        ++nearly[i];
    EXPECT_EQ(missed_by(nearly, guess), 4u);
    EXPECT_EQ(decode_sparse(encode_sparse(nearly, guess), 4, guess), nearly);
    EXPECT_EQ(decode(encode(nearly, guess), guess), nearly);
}

TEST(Planes, RunsComeBackAndDamageIsRefused) {
    std::string values(100'000, '\0');
    for (const std::size_t at : {0u, 1u, 127u, 128u, 16'384u, 50'000u, 99'999u})
        values[at] = char(at % 251 + 1);
    for (const std::string& some : {values, std::string(), std::string("a"), std::string(127, 'b'),
                                    std::string(128, 'c'), std::string("abab")}) {
        EXPECT_EQ(decode_runs(encode_runs(some), some.size()), some);
        EXPECT_THROW(decode_runs(encode_runs(some), some.size() + 1), ReportError);
        if (some.empty()) continue;
        EXPECT_THROW(decode_runs(encode_runs(some), some.size() - 1), ReportError);
    }
}

TEST(PlaneCoding, GivesBackDoublesThatAreNoNumbers) {
    const std::vector<double> values{0, -0.0, 1.0 / 3, NAN, INFINITY, -INFINITY, 5e-324};
    const std::vector<double> back = decode_doubles(encode(values), values.size());
    ASSERT_EQ(back.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(back[i]), std::bit_cast<std::uint64_t>(values[i])) << i;
    EXPECT_TRUE(decode_doubles(encode(std::vector<double>{}), 0).empty());
}

TEST(PlaneCoding, RefusesWhatIsDamaged) {
    std::string bytes = deflated("four");
    EXPECT_EQ(inflated(bytes, 4), "four");
    EXPECT_THROW(inflated(bytes, 3), ReportError);
    bytes.back() ^= 1;
    EXPECT_THROW(inflated(bytes, 4), ReportError) << "zlib's own checksum";
    EXPECT_THROW(decode(deflated("four"), 3, 1, Prediction::left), ReportError);
}

TEST(PlaneContainer, GivesBackHeaderAndBlocks) {
    const std::string nul(1, '\0');
    const Container container{
        {{"width", 8}},
        {{"a", {{"coding", "bytes"}}, "12" + nul + "3"}, {"b", nlohmann::json::object(), ""}}};
    const Container back = unpacked(packed(container), "here");
    EXPECT_EQ(back.header, container.header);
    ASSERT_EQ(back.blocks.size(), 2u);
    EXPECT_EQ(back.blocks[0].name, "a");
    EXPECT_EQ(back.blocks[0].facts, container.blocks[0].facts);
    EXPECT_EQ(back.blocks[0].content, container.blocks[0].content);
    EXPECT_EQ(back.blocks[1].content, "");
}

TEST(PlaneContainer, SaysWhereBlocksStandInAFile) {
    const TestFolder folder;
    const Container container{{{"width", 8}}, {{"a", {{"coding", "bytes"}}, "1234"}, {"b", {}, "56"}}};
    const std::string bytes = packed(container);
    write_whole_file(folder.path() / "planes.zvp", bytes);
    const Directory directory = directory_of(folder.path() / "planes.zvp");
    EXPECT_EQ(directory.header, container.header);
    ASSERT_EQ(directory.blocks.size(), 2u);
    EXPECT_EQ(directory.blocks[0].facts, container.blocks[0].facts);
    EXPECT_EQ(bytes.substr(directory.blocks[0].first, directory.blocks[0].size), "1234");
    EXPECT_EQ(bytes.substr(directory.blocks[1].first, directory.blocks[1].size), "56");
    EXPECT_EQ(packed_front(directory), bytes.substr(0, directory.blocks[0].first));
}

TEST(PlaneContainer, RefusesWhatIsNoneAndNamesThePlace) {
    const std::string good = packed({{{"width", 8}}, {{"a", {{"coding", "bytes"}}, "1234"}}});
    for (const std::string& bad :
         {std::string(), std::string("PNG"), "ZVP2" + good.substr(4), good.substr(0, 20),
          good.substr(0, good.size() - 1), good.substr(0, 8) + "[" + good.substr(9)}) {
        try {
            unpacked(bad, "run/planes.zvp");
            ADD_FAILURE() << bad.size() << " bytes were taken";
        } catch (const ReportError& e) {
            EXPECT_EQ(std::string(e.what()).rfind("run/planes.zvp: no planes of a view: ", 0), 0u)
                << e.what();
        }
        const TestFolder folder;
        const std::filesystem::path file = folder.path() / "planes.zvp";
        write_whole_file(file, bad);
        try {
            directory_of(file);
            ADD_FAILURE() << bad.size() << " bytes of a file were taken";
        } catch (const ReportError& e) {
            EXPECT_EQ(std::string(e.what()).rfind(file.string() + ": no planes of a view: ", 0), 0u)
                << e.what();
        }
    }
}

TEST(ErrorCode, NeverPutsBothSidesOfTheBoundIntoOneCode) {
    EXPECT_EQ(error_code(NAN), 0);
    EXPECT_EQ(error_code(0), 1);
    EXPECT_EQ(error_code(std::nextafter(1.0f, 0.0f)), 200);
    EXPECT_EQ(error_code(1), 201);
    EXPECT_EQ(error_code(1.1892f), 201);
    EXPECT_EQ(error_code(1.1893f), 202);
    EXPECT_EQ(error_code(2), 205);
    EXPECT_EQ(error_code(0.5f), 197);
    EXPECT_EQ(error_code(1e-30f), 1);
    EXPECT_EQ(error_code(INFINITY), 255);
    EXPECT_EQ(error_code(1e30f), 255);
    EXPECT_EQ(error_code(1e30f), 255);
    EXPECT_EQ(error_code(INFINITY), 255);
    int last = 0;
    for (float ratio = 1e-17f; ratio < 1e6f; ratio *= 1.05f) {
        EXPECT_GE(error_code(ratio), last) << ratio;
        last = error_code(ratio);
    }
}

/// Planes over sample_view(), with a story and an oracle.
struct SamplePlanes {
    SampleView sample = sample_view();
    ViewPlanes planes{.facts = {.scene = "room",
                                .view = "corner",
                                .explain_before = "zproof explain room ",
                                .explain_after = " --view corner"},
                      .candidate = {"zproof", sample.candidate, {}},
                      .reference = {"embree", sample.reference, {}},
                      .oracles = {},
                      .verdict = sample.verdict,
                      .candidate_error = Plane<float>({8, 4}, 0.5f),
                      .reference_error = Plane<float>({8, 4}, NAN),
                      .ranges = {{0, 2, "Wheel", "Spokes", 1}},
                      .stories = {}};
};

const Block& block_named(const Container& container, std::string_view name) {
    for (const Block& block : container.blocks)
        if (block.name == name) return block;
    throw std::runtime_error("no block " + std::string{name});
}

TEST(ViewPlanes, HoldBothFramesBitForBit) {
    SamplePlanes s;
    s.sample.candidate.camera_depth.at(1, 1) = NAN;
    s.sample.candidate.primitive.at(2, 2) = PrimitiveId((1u << 24) + 1);
    s.sample.reference.primitive.at(2, 2) = PrimitiveId(background - 1);
    const Container container = container_of(s.planes);
    const Numbers ids = decode(block_named(container, "candidate.id").content, 32, 8, Prediction::left);
    const Numbers depths =
        decode(block_named(container, "candidate.depth").content, 32, 8, Prediction::planar);
    const Block &their_ids = block_named(container, "reference.id"),
                &their_depths = block_named(container, "reference.depth");
    ASSERT_EQ(their_ids.facts.at("beside"), "candidate.id");
    const Numbers theirs = their_ids.facts.at("coding") == "sparse"
                               ? decode_sparse(their_ids.content, their_ids.facts.at("count"), ids)
                               : decode(their_ids.content, ids);
    const Numbers their_bits =
        their_depths.facts.at("coding") == "sparse"
            ? decode_sparse(their_depths.content, their_depths.facts.at("count"), depths)
            : decode(their_depths.content, depths);
    for (std::size_t i = 0; i < 32; ++i) {
        EXPECT_EQ(ids[i], std::uint32_t(s.sample.candidate.primitive.pixels()[i]));
        EXPECT_EQ(theirs[i], std::uint32_t(s.sample.reference.primitive.pixels()[i]));
        EXPECT_EQ(depths[i], std::bit_cast<std::uint32_t>(s.sample.candidate.camera_depth.pixels()[i]));
        EXPECT_EQ(their_bits[i], std::bit_cast<std::uint32_t>(s.sample.reference.camera_depth.pixels()[i]));
    }
    EXPECT_EQ(block_named(container, "candidate.id").facts.at("crc32"),
              crc32_of(bytes_in(std::span<const std::uint32_t>(ids))));
}

TEST(ViewPlanes, HoldClassesErrorsAndFindings) {
    SamplePlanes s;
    const Container container = container_of(s.planes);
    const std::string classes = decode_runs(block_named(container, "class").content, 32);
    EXPECT_EQ(classes[1 * 8 + 6], char(PixelClass::hole));
    EXPECT_EQ(classes[3 * 8 + 2], char(PixelClass::edge));
    EXPECT_EQ(inflated(block_named(container, "candidate.error").content, 32), std::string(32, char(197)));
    EXPECT_EQ(inflated(block_named(container, "reference.error").content, 32), std::string(32, '\0'));
    const Block& findings = block_named(container, "findings");
    ASSERT_EQ(findings.facts.at("count"), 2);
    const std::size_t split = findings.facts.at("words");
    const Numbers words = decode(findings.content.substr(0, split), 10, 2, Prediction::left);
    EXPECT_EQ(words[0], 1u * 8 + 6);
    EXPECT_EQ(words[2], background) << "the candidate saw a hole";
    EXPECT_EQ(words[3], (1u << 24) + 1);
    const std::vector<double> doubles = decode_doubles(findings.content.substr(split), 10);
    EXPECT_EQ(doubles[1], 0.002) << "eps of the edge";
    EXPECT_EQ(doubles[5], 2.2) << "its true depth";
    EXPECT_TRUE(std::isnan(doubles[8]));
    EXPECT_EQ(doubles[9], 0.5);
}

TEST(ViewPlanes, ListDefectsFirstWhereThereAreTooManyFindings) {
    SamplePlanes s;
    const Finding edge = s.sample.verdict.findings[1], hole = s.sample.verdict.findings[0];
    s.sample.verdict.findings.assign(most_findings, edge);
    s.sample.verdict.findings.push_back(hole);
    const Container container = container_of(s.planes);
    const Block& findings = block_named(container, "findings");
    EXPECT_EQ(findings.facts.at("count"), most_findings);
    EXPECT_EQ(findings.facts.at("all"), most_findings + 1);
    const Numbers words = decode(findings.content.substr(0, findings.facts.at("words")), 5 * most_findings,
                                 most_findings, Prediction::left);
    EXPECT_EQ(words[0], 1u * 8 + 6);
}

TEST(ViewPlanes, HoldOraclesColoursNamesAndStories) {
    SamplePlanes s;
    s.planes.oracles.push_back({"povray", s.sample.reference, Picture({8, 4}, {1, 0, 0})});
    Story story{.story = {}, .text = "pixel (6, 1): hole, FAIL\n  </script>\n", .images = {}};
    story.story.finding = s.sample.verdict.findings[0];
    story.images.push_back({PrimitiveId(1), {}, {0, 0, 0.25}});
    s.planes.stories.push_back(story);
    const Container container = container_of(s.planes);
    EXPECT_EQ(container.header.at("oracles"), nlohmann::json({"povray"}));
    const std::string colours = inflated(block_named(container, "oracle.povray.colour").content, 96);
    EXPECT_EQ(colours.substr(0, 3), std::string("\xFF\0\0", 3)) << "red, each less its left neighbour";
    EXPECT_NO_THROW(block_named(container, "oracle.povray.id"));
    const auto content = [&](const std::string& name) {
        return nlohmann::json::parse(inflated(block_named(container, name).content, 10'000));
    };
    EXPECT_EQ(content("ranges"), nlohmann::json::parse(R"([[0, 2, "Wheel", "Spokes", 1]])"));
    const nlohmann::json told = content("stories").at(0);
    EXPECT_EQ(told.at("x"), 6);
    EXPECT_EQ(told.at("text"), story.text);
    EXPECT_EQ(told.at("depth").at(1), "nan");
    EXPECT_EQ(told.at("images").at(0).at(2).at(2), 0.25);
}

TEST(ViewPlanes, AreTheSameBytesEveryTime) {
    SamplePlanes s;
    EXPECT_EQ(packed(container_of(s.planes)), packed(container_of(s.planes)));
}

}  // namespace
}  // namespace zproof::planes
