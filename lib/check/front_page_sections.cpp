#include <fmt/format.h>

#include <algorithm>

#include "check/check.hpp"
#include "check/csv.hpp"
#include "check/front_page.hpp"
#include "check/report_sections.hpp"

namespace ifedem {
namespace {

std::string lead_to(const ChapterReport* report, PageKind kind) {
    if (report == nullptr || report->directory.empty()) return "";
    return report->directory + (kind == PageKind::html ? "index.html" : "report.md");
}

Cell count_cell(std::size_t n) { return {n == 0 ? "–" : std::to_string(n), "num"}; }

/// Closed forms and values of other publications that a chapter checks the program with.
Standing count_external(const ChapterReport* report) {
    Standing s;
    if (report == nullptr) return s;
    for (const Outcome& o : report->outcomes)
        if (!o.ledger.needs_verdict()) ++s.checks[static_cast<std::size_t>(o.verdict)];
    return s;
}

std::size_t sum(const Standing& s) {
    std::size_t all = 0;
    for (const std::size_t n : s.checks) all += n;
    return all;
}

Section chapters_section(const FrontPage& page, PageKind kind) {
    Table t;
    t.style = "cards";
    t.header = {"Chapter"};
    for (int v = 0; v < verdict_count; ++v) t.header.emplace_back(to_text(static_cast<Verdict>(v)));
    t.header.insert(t.header.end(), {"no check yet", "Other sources"});
    std::size_t external = 0, external_match = 0;
    const auto add = [&](Cell name, const Standing& s, const std::string& others) {
        std::vector<Cell> row{std::move(name)};
        for (const std::size_t n : s.checks) row.push_back(count_cell(n));
        row.push_back(count_cell(s.unchecked));
        row.push_back({others, "num"});
        t.rows.push_back(std::move(row));
    };
    for (const int chapter : list_chapters(page)) {
        const auto found = std::find_if(page.reports.begin(), page.reports.end(),
                                        [&](const ChapterReport& r) { return r.chapter == chapter; });
        const ChapterReport* report = found == page.reports.end() ? nullptr : &*found;
        const Standing others = count_external(report);
        external += sum(others);
        external_match += others.checks[0];
        add({report != nullptr ? report->title : fmt::format("Chapter {} (no report yet)", chapter), "",
             lead_to(report, kind)},
            count_standing(page, list_statements(page.ledger, chapter)),
            sum(others) == 0 ? "–" : fmt::format("{} of {} match", others.checks[0], sum(others)));
    }
    add({"All", "strong"}, count_standing(page, list_statements(page.ledger, 0)),
        fmt::format("{} of {} match", external_match, external));
    return {"chapters", "Chapter by chapter", {std::move(t)}};
}

/// "4 of 6 checks match: D107, …; 2 not-reproduced: D111, D114."
std::string standing_text(const FrontPage& page, const Conclusion& conclusion) {
    std::array<std::vector<std::string>, verdict_count> ids;
    std::vector<std::string> unchecked;
    for (const std::string& id : conclusion.rests_on) {
        const std::vector<Found> checks = find_checks(page, id);
        for (const Found& c : checks) ids[static_cast<std::size_t>(c.outcome->verdict)].push_back(c.outcome->claim.id);
        if (checks.empty()) unchecked.push_back(id);
    }
    const Standing s = count_standing(page, conclusion.rests_on);
    if (sum(s) == 0) return fmt::format("No check yet: {}.", fmt::join(unchecked, ", "));
    std::string text = fmt::format("{} of {} checks match", s.checks[0], sum(s));
    for (std::size_t v = 0; v < ids.size(); ++v) {
        if (ids[v].empty()) continue;
        text += v == 0 ? fmt::format(": {}", fmt::join(ids[v], ", "))
                       : fmt::format("; {} {}: {}", ids[v].size(), to_text(static_cast<Verdict>(v)),
                                     fmt::join(ids[v], ", "));
    }
    if (!unchecked.empty()) text += fmt::format("; no check yet: {}", fmt::join(unchecked, ", "));
    return text + ".";
}

Section conclusions_section(const FrontPage& page) {
    Table t;
    t.style = "cards";
    t.header = {"Point", "The text concludes", "Rests on", "Checks", "Source"};
    for (const Conclusion& c : page.conclusions)
        t.rows.push_back({{c.point, "id"},
                          {c.statement, "strong"},
                          {fmt::format("{}: {} statements", c.reason, c.rests_on.size())},
                          {standing_text(page, c)},
                          {c.source, "small"}});
    return {"conclusions", "The three conclusions", {std::move(t)}};
}

/// What was compared, or what stands in the place of a number.
std::string remark(const Outcome& o) { return o.computed ? o.claim.note : o.detail; }

/// The text's own words and where they stand.
std::string printed_text(const LedgerRow& row) {
    const std::string units = row.units.empty() || row.units == "-" ? "" : " " + row.units;
    return fmt::format("{}{} ({})", row.value, units, source_text(row));
}

std::vector<Cell> unchecked_row(const LedgerRow& row) {
    return {{row.id, "id"},
            {row.condition.empty() ? row.quantity : fmt::format("{}; {}", row.quantity, row.condition)},
            {printed_text(row)},
            {"–", "num"},
            {"no check yet", "not-computable"},
            {"", "small"}};
}

std::vector<Cell> checked_row(const Found& c, PageKind kind) {
    const Outcome& o = *c.outcome;
    Cell verdict = verdict_cell(o);
    verdict.link = lead_to(c.report, kind);
    if (!verdict.link.empty()) verdict.link += kind == PageKind::html ? "#verdicts" : "#all-verdicts";
    return {{o.claim.id, "id"},
            {o.condition.empty() ? o.ledger.quantity : fmt::format("{}; {}", o.ledger.quantity, o.condition)},
            {o.verdict == Verdict::not_computable ? printed_text(o.ledger) : statement_text(o)},
            {computed_text(o), "num"},
            std::move(verdict),
            {remark(o), "small"}};
}

Section statements_section(const FrontPage& page, int chapter, std::string title, PageKind kind) {
    const std::vector<std::string> ids = list_statements(page.ledger, chapter);
    Table t;
    t.style = "cards";
    t.header = {"Id", "Statement", "Text", "Computed ± U", "Verdict", "Note"};
    for (const std::string& id : ids) {
        const std::vector<Found> checks = find_checks(page, id);
        if (checks.empty()) t.rows.push_back(unchecked_row(page.ledger.at(id)));
        for (const Found& c : checks) t.rows.push_back(checked_row(c, kind));
    }
    Section s{fmt::format("chapter-{}", chapter), std::move(title), {}};
    if (!t.rows.empty()) s.blocks.emplace_back(std::move(t));
    return s;
}

Section guide_section() {
    return {
        "reading",
        "How to read this",
        {BulletList{{
            "A statement is a row of the ledger (reference_data/dissertation.csv) that can be right or wrong: a "
            "number that was computed or measured, a ratio, a trend or an ordering in words. It may have several "
            "checks (D113 and D113-b).",
            "match: within the tolerance, and U is small enough to tell. unresolved: U is too large to tell. "
            "differs-explained: outside, and a file shows the cause. not-reproduced: outside, and none does. "
            "not-computable: nothing can be computed, and the note says why.",
            "U holds the scatter over packings and lug phases with 95 % confidence, and how exactly the text’s own "
            "number can be read. Where no U is shown the check tells none.",
            "A verdict leads to its chapter’s report, which has tolerances with their origin, evidence, figures and "
            "every run. There the program is also judged by closed forms and other publications: “other sources”.",
            "This page holds nothing of its own: it is made from the reports’ checks.csv "
            "(make reproduce-chapter6).",
        }}}};
}

}  // namespace

Document compose(const FrontPage& page, PageKind kind) {
    const std::vector<std::string> all = list_statements(page.ledger, 0);
    const Standing s = count_standing(page, all);
    Document d;
    d.title = "A dissertation run again: every statement and its verdict";
    d.subtitle = fmt::format(
        "{} statements of the text that can be right or wrong, judged by rule in {} checks. The chapters’ reports have "
        "the figures.",
        all.size(), sum(s));
    std::vector<std::string> counts;
    for (std::size_t v = 0; v < s.checks.size(); ++v) {
        const std::string name(to_text(static_cast<Verdict>(v)));
        counts.push_back(fmt::format("{} {}", s.checks[v], name));
        d.tallies.push_back({name, name, s.checks[v]});
    }
    d.first_line = fmt::format("Verdicts: {} — {}.", fmt::join(counts, ", "),
                               s.unchecked == 0 ? "no statement without a check"
                                                : fmt::format("statements without a check yet: {}", s.unchecked));
    d.sections = {chapters_section(page, kind), conclusions_section(page)};
    const std::set<int> chapters = list_chapters(page);
    const int last = *chapters.rbegin();  // what the text closes with stands beside its conclusions
    d.sections.push_back(statements_section(page, last, "The closing claim", kind));
    for (const int chapter : chapters)
        if (chapter != last)
            d.sections.push_back(
                statements_section(page, chapter, fmt::format("Statements of chapter {}", chapter), kind));
    d.sections.push_back(guide_section());
    std::erase_if(d.sections, [](const Section& section) { return section.blocks.empty(); });
    return d;
}

void write_front_page(const std::string& conclusions_path, const std::vector<std::string>& report_dirs,
                      const std::string& out_dir) {
    const FrontPage page = read_front_page(conclusions_path, report_dirs, out_dir);
    write_text(out_dir + "/README.md", to_markdown(compose(page, PageKind::markdown)));
    write_html(compose(page, PageKind::html), out_dir, find_root(conclusions_path) + "/reports/templates");
}

}  // namespace ifedem
