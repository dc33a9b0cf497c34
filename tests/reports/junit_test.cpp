#include "reports/formats.h"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <sstream>

#include "tests/reports/sample.h"

namespace zproof {

namespace {

using Tree = boost::property_tree::ptree;

Tree parsed(const std::string& xml) {
    std::istringstream in(xml);
    Tree tree;
    boost::property_tree::read_xml(in, tree);
    return tree.get_child("testsuites");
}

std::vector<Tree> children(const Tree& parent, const std::string& name) {
    std::vector<Tree> found;
    for (const auto& [key, child] : parent)
        if (key == name) found.push_back(child);
    return found;
}

Tree suite_named(const Tree& suites, const std::string& name) {
    for (const Tree& suite : children(suites, "testsuite"))
        if (suite.get<std::string>("<xmlattr>.name") == name) return suite;
    return {};
}

std::string attribute(const Tree& tree, const std::string& name) {
    return tree.get<std::string>("<xmlattr>." + name, "(absent)");
}

}  // namespace

TEST(JUnit, HasASuitePerReferenceAndACasePerView) {
    const Tree suites = parsed(to_junit(sample_results()));
    EXPECT_EQ(children(suites, "testsuite").size(), 2u);
    const Tree embree = suite_named(suites, "embree");
    EXPECT_EQ(children(embree, "testcase").size(), 3u);
    EXPECT_EQ(attribute(embree, "tests"), "3");
    EXPECT_EQ(attribute(embree, "failures"), "2");
    EXPECT_EQ(attribute(embree, "errors"), "0");
    EXPECT_EQ(attribute(suites, "errors"), "1");
    EXPECT_EQ(attribute(suites, "tests"), "4");
}

TEST(JUnit, ADefectIsAFailureOfItsClass) {
    const std::vector<Tree> cases =
        children(suite_named(parsed(to_junit(sample_results())), "embree"), "testcase");
    EXPECT_EQ(attribute(cases[0], "classname"), "meadow");
    EXPECT_EQ(cases[0].count("failure"), 0u);
    const Tree failure = cases[1].get_child("failure");
    EXPECT_EQ(attribute(failure, "type"), "hole");
    EXPECT_EQ(attribute(failure, "message"), "2 defective pixels, 2 hole");
    EXPECT_NE(failure.data().find("zproof explain room 812 344"), std::string::npos);
    EXPECT_NE(failure.data().find("likely cause: a row is <lost> (explains 100% of 2 defects)"),
              std::string::npos);
    EXPECT_EQ(cases[1].get<std::string>("system-out"), "[[ATTACHMENT|scenes/room-corner/view.webp]]");
}

TEST(JUnit, EverySuiteTellsTheCauseOfTheRun) {
    const Tree suites = parsed(to_junit(sample_results()));
    for (const Tree& suite : children(suites, "testsuite")) {
        const Tree property = suite.get_child("properties.property");
        EXPECT_EQ(attribute(property, "name"), "cause");
        EXPECT_EQ(attribute(property, "value"), "Likely cause: a row is <lost>. Look at <rows>.");
    }
    Results proven = sample_results();
    proven.views.resize(1);
    EXPECT_EQ(to_junit(proven).find("<propert"), std::string::npos);
}

TEST(JUnit, NothingJudgedIsAFailureAndUnreadableAnError) {
    const Tree suites = parsed(to_junit(sample_results()));
    const Tree empty = children(suite_named(suites, "embree"), "testcase")[2];
    EXPECT_EQ(attribute(empty.get_child("failure"), "type"), "not_judged");
    const Tree refused = children(suite_named(suites, "none"), "testcase")[0];
    EXPECT_EQ(attribute(refused.get_child("error"), "message"),
              "a.glb: accessor 3 ends beyond its buffer; export the file again");
    EXPECT_EQ(to_junit(sample_results()).find("<skipped"), std::string::npos);
}

TEST(JUnit, AnUnmetExpectationIsAFailureOfItsOwn) {
    Results results = sample_results();
    results.views = {results.views[0]};
    results.views[0].outcome = Outcome::defective;
    results.views[0].message = "class clip did\nnot occur";
    const Tree failure = parsed(to_junit(results)).get_child("testsuite.testcase.failure");
    EXPECT_EQ(attribute(failure, "type"), "expectation");
    EXPECT_EQ(attribute(failure, "message"), "class clip did not occur");
}

TEST(JUnit, NamesComeThroughWhole) {
    Results results = sample_results();
    results.views[2].view = "a&b \"c\" \x01";
    const Tree refused = children(suite_named(parsed(to_junit(results)), "none"), "testcase")[0];
    EXPECT_EQ(attribute(refused, "classname"), hostile_name);
    EXPECT_EQ(attribute(refused, "name"), "a&b \"c\" \\x01");
}

}  // namespace zproof
