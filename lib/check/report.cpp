#include "check/report.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "check/check.hpp"
#include "check/csv.hpp"
#include "check/figures.hpp"
#include "check/report_sections.hpp"

namespace ifedem {
namespace {

std::string worse_text(const std::vector<Outcome>& outcomes) {
    std::size_t worse = 0;
    for (const auto& o : outcomes) worse += o.is_worse_than_expected() ? 1U : 0U;
    return worse == 0 ? "none worse than expected" : fmt::format("{} worse than expected", worse);
}

std::string report_title(const ReportRequest& request, const std::vector<Outcome>& outcomes) {
    if (!request.title.empty()) return request.title;
    return outcomes.empty() ? "Report" : fmt::format("Chapter {}", outcomes.front().ledger.chapter);
}

Document compose(const ReportRequest& request, const CheckResult& result, const ReportPaths& paths,
                 const std::vector<Figure>& figures) {
    const auto& outcomes = result.outcomes;
    const auto& campaign = result.campaign;
    Document d;
    d.title = report_title(request, outcomes);
    // Some chapters hand over measurements instead of runs.
    const std::string runs = campaign.runs.empty() ? "" : fmt::format("{} runs, ", campaign.runs.size());
    d.subtitle =
        fmt::format("A reproduction with ifedem: {}{} checks of the dissertation’s statements, judged by rule.", runs,
                    outcomes.size());
    d.first_line = fmt::format("Verdicts: {} — {}.", verdict_line(outcomes), worse_text(outcomes));
    const auto counts = count_verdicts(outcomes);
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const std::string name(to_text(static_cast<Verdict>(k)));
        d.tallies.push_back({name, name, counts[k]});
    }
    d.sections = {summary_section(outcomes),
                  numbers_section(outcomes, figures),
                  figures_section(figures),
                  slips_section(campaign),
                  verdicts_section(outcomes),
                  effects_section(outcomes, campaign),
                  doubts_section(campaign),
                  measurements_section(campaign),
                  choices_section(paths.chapter + "/choices.csv", campaign),
                  balances_section(campaign),
                  provenance_section(campaign, request.command),
                  reading_section()};
    std::erase_if(d.sections, [](const Section& s) { return s.blocks.empty(); });
    return d;
}

}  // namespace

void write_report(const ReportRequest& request) {
    const CheckResult result = check_claims(request.claims_path, request.run_dirs);
    const ReportPaths paths{std::filesystem::path(request.claims_path).parent_path().string(),
                            result.root + "/reports/style.gp", result.root + "/reports/templates", request.out_dir};
    // First what pictures may not cost: gnuplot can be missing.
    write_text(request.out_dir + "/checks.csv", checks_to_csv(result.outcomes));
    write_text(request.out_dir + "/runs.csv", runs_to_csv(result.campaign));
    const auto figures = draw_figures(paths, result.campaign, result.outcomes);
    const Document document = compose(request, result, paths, figures);
    write_text(request.out_dir + "/report.md", to_markdown(document));
    write_html(document, request.out_dir, paths.templates);
}

}  // namespace ifedem
