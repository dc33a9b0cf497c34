#include "reports/planes/deflate.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <random>
#include <span>

namespace zproof {
namespace {

/// By zlib, which knows nothing of how it was packed.
std::string inflated(const std::string& packed, std::size_t size) {
    std::string plain(size + 1, '\0');
    uLongf length = plain.size();
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(plain.data()), &length,
                         reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
              Z_OK);
    plain.resize(length);
    return plain;
}

std::string noise(std::size_t size) {
    std::mt19937 random(1);
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    return bytes;
}

TEST(Deflate, ZlibReadsBackEveryByte) {
    for (const std::string& bytes : {std::string(), std::string("a"), std::string(1 << 20, 'z'), noise(1),
                                     noise(5000), noise(1 << 20), noise(70'000) + noise(70'000)})
        EXPECT_EQ(inflated(deflated(bytes), bytes.size()), bytes) << bytes.size();
}

TEST(Deflate, RepetitionsCostNextToNothing) {
    EXPECT_LT(deflated(std::string(1 << 20, 'z')).size(), 10'000u);
    EXPECT_LT(deflated(noise(3000) + noise(3000)).size(), 4000u);
}

TEST(Deflate, DeflaterThatWasUsedBeforeGivesTheSameStream) {
    Deflater deflater;
    deflater.deflated(noise(100'000));
    EXPECT_EQ(deflater.deflated("twice twice twice"), deflated("twice twice twice"));
}

/// Bytes with repetitions.
std::string prose(std::mt19937& random, std::size_t size) {
    const std::size_t letters = 1 + random() % 81;
    std::string bytes;
    while (bytes.size() < size) {
        const std::size_t length = bytes.size() > 50 && random() % 3 == 0 ? 3 + random() % 20 : 1;
        const std::size_t back =
            1 + random() % std::max<std::size_t>(1, std::min<std::size_t>(bytes.size(), 3000));
        for (std::size_t i = 0; i < length; ++i)
            bytes += length > 1 ? bytes[bytes.size() - back] : static_cast<char>(random() % letters);
    }
    bytes.resize(size);
    return bytes;
}

/// igzip has levels at which one text of a thousand is packed in another way now and then.
TEST(Deflate, SameBytesGiveTheSameStreamWhereverTheyStandAndWhateverWasPackedBefore) {
    std::mt19937 random(1);
    Deflater used;
    int others = 0;
    for (int i = 0; i < 20'000; ++i) {
        const std::size_t size = i % 100 == 0 ? 20'000 + random() % 150'000 : 1 + random() % 400;
        const std::string bytes = prose(random, size);
        const std::string among_others = std::string(random() % 40, 'a') + bytes + bytes;
        const std::string_view same =
            std::string_view(among_others).substr(among_others.size() - 2 * size, size);
        const DeflatedPiece piece = used.piece(bytes);
        others += piece.bits != Deflater().piece(same).bits;
        EXPECT_EQ(inflated(stream_of({&piece, 1}), size), bytes);
    }
    EXPECT_EQ(others, 0);
}

TEST(Deflate, PiecesAreOneStream) {
    Deflater deflater;
    for (const std::vector<std::string>& parts :
         {std::vector<std::string>{},
          {""},
          {"a"},
          {noise(200'000), "", std::string(100'000, '\xFF'), noise(7)}}) {
        std::string all;
        std::vector<DeflatedPiece> pieces;
        for (const std::string& part : parts) pieces.push_back(deflater.piece(part)), all += part;
        EXPECT_EQ(inflated(stream_of(pieces), all.size()), all) << parts.size();
    }
}

TEST(Deflate, PiecesMadeSideBySideStandInTheirOrder) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1} << 17, std::size_t{3'000'000}})
        EXPECT_EQ(inflated(deflated_side_by_side(noise(size)), size), noise(size)) << size;
}

TEST(Deflate, ChecksumIsThatOfZlib) { EXPECT_EQ(crc32_of("123456789"), 0xCBF43926u); }

}  // namespace
}  // namespace zproof
