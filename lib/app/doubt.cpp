#include "app/doubt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/children.hpp"
#include "app/variants.hpp"
#include "check/csv.hpp"
#include "check/differences.hpp"
#include "core/error.hpp"
#include "model/case_changes.hpp"
#include "record/directory_lock.hpp"
#include "record/files.hpp"
#include "step/limits.hpp"
#include "step/stages.hpp"

namespace ifedem {
namespace {

/// A finer mesh may need a smaller step.
Case make_stable(Case c) {
    while (find_certain_excess(c)) c = with_time_step(c, 0.5);
    return c;
}

/// Something there may be more of.
struct Increase {
    std::string_view name;
    Case (*apply)(const Case& c);
    bool (*is_possible)(const Case& c);
};

bool always(const Case&) { return true; }

constexpr Increase all_increases[] = {
    {"depth", [](const Case& c) { return with_depth(c, 2); }, has_discs_only},
    {"length", [](const Case& c) { return with_length(c, 2); }, has_discs_only},
    {"discs", [](const Case& c) { return with_time_step(with_disc_radii(c, 0.5), 0.5); }, has_discs_only},
    {"region", [](const Case& c) { return with_region(c, 2); }, has_region},
    {"mesh", [](const Case& c) { return make_stable(with_mesh(c, 2)); }, can_refine_mesh},
    {"step", [](const Case& c) { return with_time_step(c, 0.5); }, always}};

/// The case itself first, then what there can be more of.
std::vector<Variant> list_variants(const Case& c, const std::string& only) {
    const std::vector<std::string> wanted = split(only, ',');
    for (const std::string& name : wanted) (void)find_named(all_increases, name, only, "more");
    std::vector<Variant> variants = {{"default", c}};
    for (const Increase& more : all_increases)
        if (more.is_possible(c) && std::ranges::find(wanted, more.name) != wanted.end())
            variants.push_back({std::string(more.name), more.apply(c)});
    return variants;
}

std::string describe_cost(const Case& c, const Case& default_case) {
    return fmt::format("{:.3g}", count_disc_steps(c) / count_disc_steps(default_case));
}

struct Table {
    std::string csv =
        "variation,changes,quantity,unit,n,default,variant,difference,half_width,tolerance,verdict,n_needed,"
        "relative_cost,note\n";
    std::string text = fmt::format("{:<8} {:<10} {:>10} {:>10} {:>21}  {:<15} {}\n", "what", "quantity", "default",
                                   "variant", "difference", "verdict", "cost");
    int intervals = 0;
};

void add_variant(Table& table, const std::vector<Variant>& variants, const std::vector<MeasuredVariant>& measured,
                 std::size_t v, const std::vector<ComparedMetric>& quantities, double tolerance) {
    const std::string changes = describe_settings(variants[0].c, variants[v].c);
    const std::string cost = describe_cost(variants[v].c, variants[0].c);
    for (const ComparedMetric& q : quantities) {
        std::vector<std::string> cells = {variants[v].name, changes, q.name, std::string(q.metric->unit)};
        if (measured[v].metrics.empty()) {
            cells.insert(cells.end(), {"0", "", "", "", "", "", "not run", "", cost, measured[v].note});
            table.text += fmt::format("{:<8} {:<10} {}\n", variants[v].name, q.name, measured[v].note);
        } else {
            const Difference d = find_difference(measured[0].metrics, measured[v].metrics, q, tolerance);
            const std::string verdict(to_text(judge_movement(d)));
            ++table.intervals;
            cells.insert(cells.end(),
                         {std::to_string(d.paired.n), format_number(d.before), format_number(d.after),
                          format_number(d.paired.mean), format_number(d.paired.half_width), format_number(d.tolerance),
                          verdict, format_number(realisations_needed(d)), cost, ""});
            table.text +=
                fmt::format("{:<8} {:<10} {:>10.4g} {:>10.4g} {:>10.3g} ± {:<8.3g}  {:<15} {}\n", variants[v].name,
                            q.name, d.before, d.after, d.paired.mean, d.paired.half_width, verdict, cost);
        }
        table.csv += csv_line(cells);
    }
}

}  // namespace

int run_doubt(const DoubtRequest& request) {
    const std::vector<ComparedMetric> quantities = parse_quantities(request.quantities);
    const double tolerance = parse_tolerance(request.tolerance);
    const Case original = read_case(request.case_path, request.overrides);
    const std::vector<Variant> variants = list_variants(original, request.increases);
    const VariantRequest runs{request.case_path, request.directory, original, request.realisations, request.options};
    (void)plan_variants(runs, variants);  // says what is wrong before anything is written
    std::filesystem::create_directories(request.directory);
    const DirectoryLock lock(request.directory, Busy::refuse);
    const std::vector<MeasuredVariant> measured = measure_variants(runs, variants);
    if (signal_of_children() != 0) return report_signal();
    if (measured[0].status != 0)
        throw Error(static_cast<ExitCode>(measured[0].status),
                    fmt::format("the case itself does not run ({}; nothing can be compared with it). Run it alone?",
                                measured[0].note));
    Table table;
    int worst = 0;
    for (std::size_t v = 1; v < variants.size(); ++v) {
        add_variant(table, variants, measured, v, quantities, tolerance);
        worst = std::max(worst, measured[v].status);
    }
    write_file_atomically(request.directory + "/doubt.csv", table.csv);
    fmt::print(
        "{}{} realisations, 95 % half-widths, cost in disc-steps of the default's; table: {}/doubt.csv\n"
        "By chance alone {:.1f} of {} intervals leave out 0, and all share the default's realisations: look at what "
        "moves with more.\n",
        table.text, request.realisations, request.directory, 0.05 * table.intervals, table.intervals);
    return worst;
}

}  // namespace ifedem
