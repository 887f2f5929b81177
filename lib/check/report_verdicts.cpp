#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "check/check.hpp"
#include "check/csv.hpp"
#include "check/report_sections.hpp"

namespace ifedem {
namespace {

std::string units_after(const Outcome& o) { return o.units == "-" || o.units.empty() ? "" : " " + o.units; }

/// Digits that the uncertainty leaves meaningful: two of U, at most four in all.
std::string with_uncertainty(double value, double uncertainty) {
    if (!std::isfinite(uncertainty) || uncertainty <= 0) return fmt::format("{:.4g}", value);
    const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(uncertainty))), 0, 4);
    return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, uncertainty, decimals);
}

std::string reference_text(const Outcome& o) {
    switch (o.claim.comparison) {
        case Comparison::above:
            return fmt::format("> {}{}", o.reference_text, units_after(o));
        case Comparison::below:
            return fmt::format("< {}{}", o.reference_text, units_after(o));
        case Comparison::at_most:
            return fmt::format("≤ {}{}", o.reference_text, units_after(o));
        case Comparison::equal:
            return o.reference_text + units_after(o);
        default:
            return o.reference_text;
    }
}

}  // namespace

std::string computed_text(const Outcome& o) {
    if (!o.computed) return "–";
    if (o.claim.comparison == Comparison::linear)
        return fmt::format("off its chord by {:.1f} ± {:.1f} %", 100 * *o.computed, 100 * o.uncertainty);
    if (o.claim.comparison == Comparison::increasing || o.claim.comparison == Comparison::decreasing)
        return fmt::format("τ = {:.2f}", *o.computed);
    if (o.claim.comparison == Comparison::cross || o.claim.comparison == Comparison::not_cross)
        return fmt::format("spread {:.0f} % of slip", *o.computed);
    if (is_about_curves(o.claim.comparison))
        return "difference " + with_uncertainty(*o.computed, o.uncertainty) + units_after(o);
    return with_uncertainty(*o.computed, o.uncertainty) + units_after(o);
}

std::string statement_text(const Outcome& o) {
    const bool is_number = o.claim.comparison != Comparison::none && !is_about_curves(o.claim.comparison);
    const std::string what = is_number && o.ledger.kind == "qualitative"
                                 ? fmt::format("“{}”, taken as {}", o.ledger.value, reference_text(o))
                                 : reference_text(o);
    return fmt::format("{} ({})", what, source_text(o.ledger));
}

Cell verdict_cell(const Outcome& o) {
    std::string text(to_text(o.verdict));
    if (o.is_worse_than_expected()) text += fmt::format(" (expected {})", to_text(o.claim.expected));
    return {text, std::string(to_text(o.verdict))};
}

namespace {

std::string error_text(const Outcome& o) {
    return o.error_over_tolerance ? fmt::format("{:+.2f}", *o.error_over_tolerance) : std::string("–");
}

/// "Net traction ratio < 0.378 (D113-b)".
std::string name_of(const Outcome& o) {
    const bool is_side = o.claim.comparison == Comparison::above || o.claim.comparison == Comparison::below;
    return is_side ? fmt::format("{} {} ({})", o.ledger.quantity, reference_text(o), o.claim.id)
                   : fmt::format("{} ({})", o.ledger.quantity, o.claim.id);
}

/// One sentence for the summary. Statistics of many curves are left to the table of all verdicts.
std::string sentence(const Outcome& o) {
    constexpr std::size_t longest_detail = 120;
    if (is_about_curves(o.claim.comparison))
        return fmt::format("{}: the text says “{}”{}.", name_of(o), o.reference_text,
                           o.detail.size() > longest_detail ? "" : "; " + o.detail);
    switch (o.claim.comparison) {
        case Comparison::above:
        case Comparison::below:
            return fmt::format("{}: computed {}.", name_of(o), computed_text(o));
        default:
            if (o.ledger.kind == "qualitative")
                return fmt::format("{}: {}; “{}” was taken as {}.", name_of(o), computed_text(o), o.ledger.value,
                                   reference_text(o));
            return fmt::format("{}: {} where the text has {}.", name_of(o), computed_text(o), reference_text(o));
    }
}

void add_list(Section& section, const std::vector<Outcome>& outcomes, Verdict verdict, const std::string& heading) {
    BulletList list;
    for (const auto& o : outcomes)
        if (o.verdict == verdict) list.items.push_back(sentence(o));
    if (list.items.empty()) return;
    section.blocks.emplace_back(Paragraph{heading, "lead " + std::string(to_text(verdict))});
    section.blocks.emplace_back(std::move(list));
}

/// A value that checks the program itself (external.csv), not a statement of the text.
bool is_external(const Outcome& o) { return o.ledger.kind == "exact" || o.ledger.kind == "published"; }

/// What agrees needs its name only: its numbers stand in the tables. Closed forms and other publications can be many,
/// so they are counted.
void add_matches(Section& section, const std::vector<Outcome>& outcomes) {
    std::vector<std::string> names;
    std::size_t external = 0;
    for (const auto& o : outcomes) {
        if (o.verdict != Verdict::match) continue;
        if (is_external(o))
            ++external;
        else
            names.push_back(name_of(o));
    }
    if (external > 0)
        names.push_back(fmt::format("{} closed forms and values of other publications (table below)", external));
    if (names.empty()) return;
    section.blocks.emplace_back(Paragraph{"Reproduced", "lead match"});
    section.blocks.emplace_back(Paragraph{fmt::format("{}.", fmt::join(names, "; ")), ""});
}

/// Reasons for rows without a number, most frequent first, so that many rows need few words.
std::string count_reasons(const std::vector<Outcome>& outcomes) {
    std::map<std::string, std::size_t> counts;
    for (const auto& o : outcomes)
        if (o.verdict == Verdict::not_computable) ++counts[o.detail];
    std::vector<std::pair<std::string, std::size_t>> sorted(counts.begin(), counts.end());
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    std::vector<std::string> parts;
    for (const auto& [reason, n] : sorted) parts.push_back(fmt::format("{} × {}", n, reason));
    return fmt::format("{}.", fmt::join(parts, "; "));
}

/// The same metric at one slip on both planets: the reader's first question, in four lines.
Table planets_table(const std::vector<Outcome>& outcomes) {
    Table t;
    t.style = "compact key";
    std::map<std::string, std::map<std::string, const Outcome*>> by_metric;
    std::vector<std::string> order;
    for (const auto& o : outcomes) {
        const auto* info = find_metric(o.claim.metric);
        if (!info || o.claim.comparison != Comparison::equal || o.claim.selection.sides.size() != 1) continue;
        if (std::find(order.begin(), order.end(), o.claim.metric) == order.end()) order.push_back(o.claim.metric);
        by_metric[o.claim.metric].emplace(o.claim.first_gravity(), &o);
    }
    t.header = {"", "Earth: text", "Earth: computed ± U", "", "Mars: text", "Mars: computed ± U", ""};
    for (const auto& metric : order) {
        std::vector<Cell> row{{std::string(find_metric(metric)->symbol), "symbol"}};
        for (const char* planet : {"earth", "mars"}) {
            const auto found = by_metric[metric].find(planet);
            if (found == by_metric[metric].end()) {
                row.insert(row.end(), 3, Cell{"–", "num"});
                continue;
            }
            const Outcome& o = *found->second;
            row.push_back({reference_text(o), "num"});
            row.push_back({computed_text(o), "num strong"});
            row.push_back({std::string(to_text(o.verdict)), std::string(to_text(o.verdict))});
        }
        t.rows.push_back(std::move(row));
    }
    return t;
}

Table verdict_table(const std::vector<Outcome>& outcomes) {
    Table t;
    t.style = "cards";
    t.header = {"Id", "Statement", "Text", "Computed ± U", "n", "Error / tolerance", "Verdict", "Evidence or detail"};
    t.data_file = "checks.csv";
    for (const auto& o : outcomes) {
        if (o.verdict == Verdict::not_computable) continue;
        std::vector<std::string> evidence;
        for (const auto& part : {o.claim.evidence, o.detail, o.claim.note, "tolerance: " + o.claim.tolerance_origin})
            if (!part.empty()) evidence.push_back(part);
        t.rows.push_back(
            {{o.claim.id, "id"},
             {o.condition.empty() ? o.ledger.quantity : fmt::format("{}; {}", o.ledger.quantity, o.condition), ""},
             {statement_text(o), ""},
             {computed_text(o), "num"},
             {o.n > 0 ? std::to_string(o.n) : "–", "num"},
             {error_text(o), "num"},
             verdict_cell(o),
             {fmt::format("{}", fmt::join(evidence, "; ")), "small"}});
    }
    return t;
}

Table not_computed_table(const std::vector<Outcome>& outcomes) {
    Table t;
    t.caption = "Statements that this campaign cannot judge";
    t.style = "cards";
    t.header = {"Id", "Statement", "Text", "Reason", "Source"};
    for (const auto& o : outcomes) {
        if (o.verdict != Verdict::not_computable) continue;
        t.rows.push_back({{o.claim.id, "id"},
                          {o.ledger.quantity, ""},
                          {o.reference_text + (o.ledger.units == "-" ? "" : " " + o.ledger.units), ""},
                          {o.is_worse_than_expected() ? o.detail + " (a verdict was expected)" : o.detail,
                           o.is_worse_than_expected() ? "small not-reproduced" : "small"},
                          {source_text(o.ledger), "small"}});
    }
    return t;
}

}  // namespace

Section summary_section(const std::vector<Outcome>& outcomes) {
    Section s{"summary", "In plain words", {}};
    const auto counts = count_verdicts(outcomes);
    const std::size_t open = counts[static_cast<std::size_t>(Verdict::not_computable)];
    const auto external = static_cast<std::size_t>(std::count_if(outcomes.begin(), outcomes.end(), is_external));
    const std::string others =
        external == 0 ? "" : fmt::format(", {} of them against closed forms and other publications", external);
    s.blocks.emplace_back(Paragraph{
        fmt::format(
            "The dissertation makes statements here that can be right or wrong; {} checks judge them{}. {} could be "
            "computed: "
            "{} agree, {} are too uncertain to tell, {} differ and the cause is shown, {} differ and it is not.",
            outcomes.size(), others, outcomes.size() - open, counts[0], counts[1], counts[2], counts[3]),
        ""});
    Table key = planets_table(outcomes);
    if (!key.rows.empty()) s.blocks.emplace_back(std::move(key));
    add_matches(s, outcomes);
    add_list(s, outcomes, Verdict::unresolved, "Near, but too uncertain to tell");
    add_list(s, outcomes, Verdict::differs_explained, "Different, and the cause is shown");
    add_list(s, outcomes, Verdict::not_reproduced, "Not reproduced");
    if (open > 0) {
        s.blocks.emplace_back(Paragraph{"Not computed", "lead not-computable"});
        s.blocks.emplace_back(Paragraph{count_reasons(outcomes), "muted"});
    }
    return s;
}

Section numbers_section(const std::vector<Outcome>& outcomes, const std::vector<Figure>& figures) {
    Section s{"numbers", "The text’s numbers", {}};
    Table t;
    t.style = "compact cards";
    t.header = {"Quantity", "Text", "Computed ± U", "n", "Error / tolerance", "Verdict"};
    for (const auto& o : outcomes) {
        if (o.claim.comparison != Comparison::equal) continue;
        t.rows.push_back({{fmt::format("{} ({})", o.ledger.quantity, o.claim.id), ""},
                          {reference_text(o), "num"},
                          {computed_text(o), "num"},
                          {o.n > 0 ? std::to_string(o.n) : "–", "num"},
                          {error_text(o), "num"},
                          verdict_cell(o)});
    }
    if (!t.rows.empty()) s.blocks.emplace_back(std::move(t));
    for (const auto& f : figures)
        if (f.name == "agreement") s.blocks.emplace_back(FigureGroup{{f}});
    return s;
}

Section figures_section(const std::vector<Figure>& figures) {
    Section s{"figures", "Figures", {}};
    FigureGroup group;
    for (const auto& f : figures)
        if (f.name != "agreement") group.figures.push_back(f);
    if (!group.figures.empty()) s.blocks.emplace_back(std::move(group));
    return s;
}

Section verdicts_section(const std::vector<Outcome>& outcomes) {
    Section s{"verdicts", "All verdicts", {}};
    s.blocks.emplace_back(verdict_table(outcomes));
    Table rest = not_computed_table(outcomes);
    if (!rest.rows.empty()) s.blocks.emplace_back(std::move(rest));
    return s;
}

}  // namespace ifedem
