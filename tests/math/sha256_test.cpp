#include "math/sha256.h"

#include <gtest/gtest.h>

namespace zproof {
namespace {

// FIPS 180-4's own examples (NIST, "SHA Test Vectors").
TEST(Sha256, IsTheStandardsOwn) {
    EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(Sha256, IsTheSameInPieces) {
    Sha256 sum;
    sum.add("a");
    sum.add("");
    sum.add("bc");
    EXPECT_EQ(sum.hex(), sha256_of("abc"));
}

TEST(Sha256, TakesNumbersAsEightBytesTheLeastFirst) {
    Sha256 sum;
    sum.add(std::uint64_t{0x6863'6261});
    EXPECT_EQ(sum.hex(), sha256_of(std::string{"abch\0\0\0\0", 8}));
}

}  // namespace
}  // namespace zproof
