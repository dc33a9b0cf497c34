#include "frame/id_agreement.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace zproof {
namespace {

Frame frame_of(std::array<std::uint32_t, 6> ids) {
    Frame frame({3, 2});
    for (std::size_t i = 0; i < ids.size(); ++i) frame.primitive.pixels()[i] = PrimitiveId{ids[i]};
    return frame;
}

TEST(IdAgreement, CountsPairsAndUnanimity) {
    const Frame a = frame_of({1, 2, 3, 4, 5, 6}), b = frame_of({1, 2, 3, 4, 9, 9}),
                c = frame_of({1, 9, 3, 7, 5, 9});
    const std::array frames{&a, &b, &c};
    const IdAgreement id_agreement = count_id_agreement(frames);
    using Counts = std::vector<std::vector<std::uint64_t>>;
    EXPECT_EQ(id_agreement.same, (Counts{{6, 4, 3}, {4, 6, 3}, {3, 3, 6}}));
    EXPECT_EQ(id_agreement.unanimous, 2u);
}

TEST(IdAgreement, TellsIdsApartThatAFloatWouldNot) {
    Frame a({1, 1}), b({1, 1});
    a.primitive.at(0, 0) = PrimitiveId{(1u << 24) + 1};
    b.primitive.at(0, 0) = PrimitiveId{1u << 24};
    const std::array frames{&a, &b};
    EXPECT_EQ(count_id_agreement(frames).unanimous, 0u);
}

TEST(IdAgreement, AgreesWithItselfEverywhereAndRefusesAnotherSize) {
    const Frame a({640, 480}), b({480, 640});
    const std::array alone{&a};
    EXPECT_EQ(count_id_agreement(alone).unanimous, 640u * 480u);
    const std::array unequal{&a, &b};
    EXPECT_THROW(count_id_agreement(unequal), std::invalid_argument);
}

}  // namespace
}  // namespace zproof
