#include "cli/refusal.h"

namespace zproof {
namespace {

/// A command that is missing here does not compile.
struct Refusal {
    std::string_view operator()(const RunArguments&) const { return "cannot judge"; }
    std::string_view operator()(const CompareArguments&) const { return "cannot judge"; }
    std::string_view operator()(const ExplainArguments&) const { return "cannot judge"; }
    std::string_view operator()(const RenderArguments&) const { return "cannot render"; }
    std::string_view operator()(const MeasureArguments&) const { return "cannot measure"; }
    std::string_view operator()(const FitArguments&) const { return "cannot fit"; }
    std::string_view operator()(const SelfcheckArguments&) const { return "cannot check the renderer"; }
    std::string_view operator()(const ContractCheckArguments&) const { return "cannot check the contract"; }
    std::string_view operator()(const SelftestArguments&) const { return "cannot test the gate"; }
    std::string_view operator()(const PlanArguments&) const { return "cannot plan"; }
    std::string_view operator()(const MergeArguments&) const { return "cannot merge"; }
    std::string_view operator()(const ReportAgainArguments&) const { return "cannot report"; }
    std::string_view operator()(const DiffResultsArguments&) const { return "cannot compare the results"; }
    std::string_view operator()(const WaiveListArguments&) const { return "cannot list the waivers"; }
    std::string_view operator()(const WaiveCheckArguments&) const { return "cannot check the waivers"; }
    std::string_view operator()(const WaivePruneArguments&) const { return "cannot prune the waivers"; }
    std::string_view operator()(const WaiveAddArguments&) const { return "cannot add a waiver"; }
    std::string_view operator()(const DoctorArguments&) const { return "cannot examine"; }
    std::string_view operator()(const ListArguments&) const { return "cannot list the suite"; }
    std::string_view operator()(const GenerateArguments&) const { return "cannot generate"; }
    std::string_view operator()(const RandomScenesArguments&) const { return "cannot write the scenes"; }
    std::string_view operator()(const ViewsArguments&) const { return "cannot import the views"; }
    std::string_view operator()(const FiltersRunArguments&) const { return "cannot study the filters"; }
    std::string_view operator()(const FiltersListArguments&) const { return "cannot list the filters"; }
    std::string_view operator()(const FiltersScenesArguments&) const { return "cannot write the scenes"; }
    std::string_view operator()(const FiltersReproduceArguments&) const { return "cannot reproduce"; }
    std::string_view operator()(const FiltersTableArguments&) const { return "cannot show the table"; }
    std::string_view operator()(const FiltersFigureArguments&) const { return "cannot draw the figures"; }
    std::string_view operator()(const FiltersCrowArguments&) const { return "cannot make the page"; }
    std::string_view operator()(const FiltersCheckArguments&) const { return "cannot judge"; }
    std::string_view operator()(const FiltersExplainArguments&) const { return "cannot explain"; }
    std::string_view operator()(const StudyArguments&) const { return "cannot study"; }
    std::string_view operator()(const Answered&) const { return "cannot answer"; }
};

}  // namespace

std::string_view refusal_of(const Command& command) { return std::visit(Refusal{}, command); }

}  // namespace zproof
