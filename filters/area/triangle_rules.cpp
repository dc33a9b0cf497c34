#include "filters/area/triangle_rules.h"

#include <array>
#include <cmath>
#include <vector>

namespace zproof::oracle::area {

namespace {

/// The three nodes (1 - 2 a, a, a) and those that symmetry makes of them.
void add_three(std::vector<Node>& rule, double a, double weight) {
    rule.insert(rule.end(),
                {{1 - 2 * a, a, a, weight}, {a, 1 - 2 * a, a, weight}, {a, a, 1 - 2 * a, weight}});
}

/// All six orders of (a, b, 1 - a - b).
void add_six(std::vector<Node>& rule, double a, double b, double weight) {
    const double c = 1 - a - b;
    rule.insert(rule.end(), {{a, b, c, weight},
                             {b, c, a, weight},
                             {c, a, b, weight},
                             {a, c, b, weight},
                             {c, b, a, weight},
                             {b, a, c, weight}});
}

std::vector<Node> degree_5() {
    const double root = std::sqrt(15.0);
    std::vector<Node> rule{{1.0 / 3, 1.0 / 3, 1.0 / 3, 9.0 / 40}};
    add_three(rule, (6 - root) / 21, (155 - root) / 1200);
    add_three(rule, (6 + root) / 21, (155 + root) / 1200);
    return rule;
}

std::vector<Node> degree_8() {
    std::vector<Node> rule{{1.0 / 3, 1.0 / 3, 1.0 / 3, 0.144315607677787}};
    add_three(rule, 0.459292588292723, 0.095091634267285);
    add_three(rule, 0.170569307751760, 0.103217370534718);
    add_three(rule, 0.050547228317031, 0.032458497623198);
    add_six(rule, 0.263112829634638, 0.728492392955404, 0.027230314174435);
    return rule;
}

std::vector<Node> degree_10() {
    std::vector<Node> rule{{1.0 / 3, 1.0 / 3, 1.0 / 3, 0.09081799038275358}};
    add_three(rule, 0.48557763338365738, 0.03672595775646670);
    add_three(rule, 0.10948157548503705, 0.04532105943552793);
    add_six(rule, 0.30793983876412095, 0.14170721941487995, 0.07275791684542011);
    add_six(rule, 0.24667256063990269, 0.02500353476268639, 0.02832724253105748);
    add_six(rule, 0.06680325101220027, 0.00954081540029946, 0.00942166696373282);
    return rule;
}

}  // namespace

std::span<const Node> rule_of_degree_5() {
    static const std::vector<Node> rule = degree_5();
    return rule;
}

std::span<const Node> rule_of_degree_8() {
    static const std::vector<Node> rule = degree_8();
    return rule;
}

std::span<const Node> rule_of_degree_10() {
    static const std::vector<Node> rule = degree_10();
    return rule;
}

std::span<const GaussNode> gauss_of_two() {
    static const double off = std::sqrt(1.0 / 12);
    static const std::array<GaussNode, 2> rule{{{0.5 - off, 0.5}, {0.5 + off, 0.5}}};
    return rule;
}

std::span<const GaussNode> gauss_of_three() {
    static const double off = std::sqrt(3.0 / 20);
    static const std::array<GaussNode, 3> rule{
        {{0.5 - off, 5.0 / 18}, {0.5, 4.0 / 9}, {0.5 + off, 5.0 / 18}}};
    return rule;
}

}  // namespace zproof::oracle::area
