/// Every planted filter defect is caught by the filter reference of the method that it pretends to be.
#include <gtest/gtest.h>

#include <iostream>
#include <set>

#include "filters/methods/catalogue.h"
#include "filters/selftest/filter_fault.h"

namespace zproof::selftest {

void PrintTo(const FilterFault& fault, std::ostream* out) { *out << fault.sentence; }

namespace {

class PlantedFilterDefect : public testing::TestWithParam<FilterFault> {};

TEST_P(PlantedFilterDefect, IsCaught) {
    const ConformanceResult result = try_filter_fault(GetParam(), filter_fixture(GetParam().ground));
    EXPECT_TRUE(result.is_caught());
    std::cout << GetParam().name << ": " << in_words(result) << "\n";
}

INSTANTIATE_TEST_SUITE_P(Filters, PlantedFilterDefect, testing::ValuesIn(filter_faults()),
                         [](const auto& fault) { return fault.param.name; });

TEST(FilterFaults, AreManyAndHaveNamesOfTheirOwn) {
    std::set<std::string> names;
    for (const FilterFault& fault : filter_faults())
        EXPECT_TRUE(names.insert(fault.name).second) << fault.name;
    EXPECT_GE(names.size(), 25u);
}

TEST(FilterFaults, EveryMethodHasAReference) {
    for (const texture::Method& method : texture::methods())
        EXPECT_NE(oracle::find_filter_definition(method.name), nullptr) << method.name;
}

}  // namespace
}  // namespace zproof::selftest
