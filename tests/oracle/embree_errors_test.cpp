#include "oracle/embree_errors.h"

#include <gmock/gmock.h>

#include "oracle/embree_geometry.h"
#include "oracle/oracle_error.h"

namespace zproof::oracle {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string complaint(const EmbreeErrors& errors) {
    try {
        errors.raise("was tested");
    } catch (const OracleError& error) {
        return error.what();
    }
    return {};
}

TEST(EmbreeErrors, BecomeAnOracleErrorInEmbreesWords) {
    EmbreeErrors errors;
    const DeviceHandle device = new_device();
    errors.attach_to(device.get());
    EXPECT_EQ(complaint(errors), "");
    const GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_UCHAR, &errors, 0, 3, 3);
    EXPECT_THAT(complaint(errors), AllOf(HasSubstr("Embree, while it was tested: "), HasSubstr("invalid ")));
    EXPECT_EQ(complaint(errors), "") << "a complaint is raised once";
}

TEST(EmbreeErrors, EveryCodeHasWords) {
    EXPECT_EQ(in_words(RTC_ERROR_OUT_OF_MEMORY), "out of memory");
    EXPECT_EQ(in_words(RTC_ERROR_UNSUPPORTED_CPU), "unsupported CPU");
    EXPECT_EQ(in_words(static_cast<RTCError>(7)), "error 7");
}

}  // namespace
}  // namespace zproof::oracle
