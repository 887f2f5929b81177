#include "check/front_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "check/check.hpp"
#include "check/csv.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;

/// reports/chapter3 → 3.
int chapter_of(const std::string& directory) {
    const std::string name = fs::path(directory).lexically_normal().filename().string();
    const auto number = name.starts_with("chapter") ? parse_number(name.substr(7)) : std::nullopt;
    if (!number)
        fail_input(
            fmt::format("{}: no report of a chapter (its name is not chapterN). Give directories such as "
                        "reports/chapter3?",
                        directory));
    return static_cast<int>(*number);
}

/// A report's first heading.
std::string title_of(const std::string& directory, int chapter) {
    const fs::path report = fs::path(directory) / "report.md";
    if (fs::exists(report)) {
        std::istringstream lines(read_text(report.string()));
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with("# ")) return line.substr(2);
    }
    return fmt::format("Chapter {}", chapter);
}

ChapterReport read_report(const std::string& root, const std::string& directory, const std::string& out_dir,
                          const Ledger& ledger) {
    ChapterReport report;
    report.chapter = chapter_of(directory);
    report.title = title_of(directory, report.chapter);
    if (fs::exists(fs::path(directory) / "index.html"))
        report.directory = fs::relative(directory, out_dir).generic_string() + "/";
    const std::string claims = fmt::format("{}/reproductions/chapter{}/claims.csv", root, report.chapter);
    report.outcomes = read_checks(directory + "/checks.csv", read_all_claims(claims, ledger), ledger);
    return report;
}

std::vector<Conclusion> read_conclusions(const std::string& path, const Ledger& ledger) {
    const CsvTable table = read_csv(path);
    const auto point = table.require("point"), statement = table.require("statement"),
               rests_on = table.require("rests_on"), reason = table.require("reason"), source = table.require("source");
    std::vector<Conclusion> conclusions;
    for (const CsvRow& row : table.rows)
        conclusions.push_back({row.cells[point], row.cells[statement], row.cells[reason],
                               parse_ids(row.cells[rests_on], ledger, fmt::format("{}:{}", path, row.line)),
                               row.cells[source]});
    return conclusions;
}

}  // namespace

std::set<int> list_chapters(const FrontPage& page) {
    std::set<int> chapters;
    for (const auto& [id, row] : page.ledger)
        if (row.needs_verdict()) chapters.insert(row.chapter);
    for (const ChapterReport& report : page.reports) chapters.insert(report.chapter);
    return chapters;
}

std::vector<std::string> list_statements(const Ledger& ledger, int chapter) {
    std::vector<std::string> ids;
    for (const auto& [id, row] : ledger)
        if (row.needs_verdict() && (chapter == 0 || row.chapter == chapter)) ids.push_back(id);
    return ids;
}

std::vector<std::string> parse_ids(const std::string& text, const Ledger& ledger, const std::string& where) {
    std::vector<std::string> ids;
    for (const std::string& part : split(text, ' ')) {
        if (part.empty()) continue;
        const auto dots = part.find("..");
        const std::string first = part.substr(0, dots);
        const std::string last = dots == std::string::npos ? first : part.substr(dots + 2);
        for (const std::string& end : {first, last})
            if (const auto row = ledger.find(end); row == ledger.end() || !row->second.needs_verdict())
                fail_input(fmt::format("{}: {} is no statement of the ledger. Use ids, and ranges such as D076..D078?",
                                       where, end));
        for (auto row = ledger.find(first); row != ledger.end() && row->first <= last; ++row)
            if (row->second.needs_verdict()) ids.push_back(row->first);
    }
    if (ids.empty()) fail_input(fmt::format("{}: no statement is named. Name at least one?", where));
    return ids;
}

std::vector<Found> find_checks(const FrontPage& page, const std::string& id) {
    std::vector<Found> found;
    for (const ChapterReport& report : page.reports)
        for (const Outcome& o : report.outcomes)
            if (o.ledger.id == id) found.push_back({&o, &report});
    return found;
}

Standing count_standing(const FrontPage& page, const std::vector<std::string>& ids) {
    Standing s;
    for (const std::string& id : ids) {
        const std::vector<Found> checks = find_checks(page, id);
        for (const Found& c : checks) ++s.checks[static_cast<std::size_t>(c.outcome->verdict)];
        if (checks.empty()) ++s.unchecked;
    }
    return s;
}

FrontPage read_front_page(const std::string& conclusions_path, const std::vector<std::string>& report_dirs,
                          const std::string& out_dir) {
    FrontPage page;
    const std::string root = find_root(conclusions_path);
    page.ledger = read_ledger(root);
    page.conclusions = read_conclusions(conclusions_path, page.ledger);
    for (const std::string& directory : report_dirs)
        page.reports.push_back(read_report(root, directory, out_dir, page.ledger));
    return page;
}

}  // namespace ifedem
