#pragma once
#include <array>
#include <set>
#include <string>
#include <vector>

#include "check/document.hpp"
#include "check/evaluate.hpp"

namespace ifedem {

/// One chapter's report, as far as the front page needs it.
struct ChapterReport {
    int chapter = 0;
    std::string title;      ///< "Chapter 3: …"
    std::string directory;  ///< seen from the front page; "" if there is no page to lead to
    std::vector<Outcome> outcomes;
};

/// What the text concludes in its last chapter, and the statements that this stands on.
struct Conclusion {
    std::string point;  ///< of the text's list; one point may conclude several things
    std::string statement;
    std::string reason;                 ///< why these rows
    std::vector<std::string> rests_on;  ///< ids of the ledger
    std::string source;
};

/// How many checks have each verdict, best first, and how many statements have no check.
struct Standing {
    std::array<std::size_t, verdict_count> checks{};
    std::size_t unchecked = 0;
};

/// All that the front page shows.
struct FrontPage {
    Ledger ledger;
    std::vector<ChapterReport> reports;
    std::vector<Conclusion> conclusions;
};

/// A check and the report that it stands in.
struct Found {
    const Outcome* outcome;
    const ChapterReport* report;
};

/// A statement's checks, in the order of the reports; they point into `page`.
[[nodiscard]] std::vector<Found> find_checks(const FrontPage& page, const std::string& id);

/// The checks of these statements over all reports.
[[nodiscard]] Standing count_standing(const FrontPage& page, const std::vector<std::string>& ids);

/// Chapters that make statements or have a report.
[[nodiscard]] std::set<int> list_chapters(const FrontPage& page);

/// The ledger's statements, those of one chapter or all (0), by id.
[[nodiscard]] std::vector<std::string> list_statements(const Ledger& ledger, int chapter);

/// "D076..D078 D094": ids and ranges of the ledger's statements; throws Error(bad_input) for what is none, with
/// `where`.
[[nodiscard]] std::vector<std::string> parse_ids(const std::string& text, const Ledger& ledger,
                                                 const std::string& where);

/// Reads a conclusions.csv (point,statement,rests_on,reason,source) and the checks.csv of directories named chapterN,
/// whose claims stand in the project's reproductions/chapterN. Throws Error(bad_input) or Error(io).
[[nodiscard]] FrontPage read_front_page(const std::string& conclusions_path,
                                        const std::vector<std::string>& report_dirs, const std::string& out_dir);

/// Pages lead to other pages of their own kind.
enum class PageKind { html, markdown };
[[nodiscard]] Document compose(const FrontPage& page, PageKind kind);

/// The `ledger` command: writes index.html and README.md into `out_dir`. Throws Error(bad_input) or Error(io).
void write_front_page(const std::string& conclusions_path, const std::vector<std::string>& report_dirs,
                      const std::string& out_dir);

}  // namespace ifedem
