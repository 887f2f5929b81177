// The front page of the reports: what it reads, what it counts, where it leads.
#include "check/front_page.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "check/check.hpp"
#include "check/csv.hpp"
#include "core/error.hpp"
#include "support/synthetic_runs.hpp"

namespace ifedem {
namespace {

constexpr const char* checks_header =
    "id,chapter,quantity,units,condition,reference,computed,scatter,n,tolerance,error_over_tolerance,verdict,expected,"
    "evidence,source,uncertainty\n";

/// A project with four statements, an input and a closed form; chapter 3 has a report, chapter 4 none.
class FrontPageProject : public ::testing::Test {
protected:
    void SetUp() override {
        root = test::fresh_directory(std::string("front-page-") +
                                     ::testing::UnitTest::GetInstance()->current_test_info()->name());
        write("reference_data/dissertation.csv",
              "id,chapter,quantity,symbol,value,units,condition,source,line,kind,note\n"
              "D101,3,H,H,102,N,slip 60 %,Fig 3-17a,686,result,\n"
              "D102,3,Time step,dt,1e-05,s,,3.2.2,504,input,\n"
              "D103,3,Sinkage | a trend,z,monotonic,-,,Fig 3-14,643,qualitative,\n"
              "D104,4,Entry angle,t,65,deg,,4.3.1,900,result,\n"
              "D105,4,Exit angle,t,105,deg,,4.3.1,901,result,\n");
        write("reference_data/external.csv",
              "id,chapter,quantity,symbol,value,units,condition,source,line,kind,note\n"
              "X001,2,A root,r,2,-,,algebra,,exact,\n");
        write("reproductions/chapter3/claims.csv",
              "id,metric,window,wheel,gravity,load_N,slip_percent,compare,reference,tolerance,tolerance_origin,"
              "expected,evidence,note\n"
              "D101,measured:H,,,,,,equal,,U,scatter,match,,\n"
              "D101-b,measured:H,,,,,,above,=90,U,scatter,match,,a bound\n"
              "X001,measured:root,,,,,,equal,,0.1,any,match,,\n"
              "D103,,,,,,,none,,,,not-computable,,the curve is not printed\n");
        write("reports/chapter3/checks.csv",
              std::string(checks_header) +
                  "D101,3,H,N,slip 60 %,102,98.883,4.787,8,12.05,-0.26,unresolved,match,,\"Fig 3-17a, line "
                  "686\",12.0487\n"
                  "D101-b,3,H,N,slip 60 %,90,98.883,4.787,8,12.05,-0.74,match,match,,\"Fig 3-17a, line 686\",12.0487\n"
                  "X001,2,A root,-,,2,2.01,0,1,0.1,0.1,match,match,,algebra,0\n"
                  "D103,3,Sinkage | a trend,-,,monotonic,,,,,,not-computable,not-computable,the curve is not "
                  "printed,\"Fig 3-14, line 643\",\n");
        write("reports/chapter3/report.md", "Verdicts\n\n# Chapter 3: a wheel\n");
        write("reports/chapter3/index.html", "");
        write("reports/templates/report.html", "<body>{{body}}</body>");
        write("reports/templates/report.css", "p {}");
        write("conclusions.csv", "point,statement,rests_on,reason,source\n1,Wheels roll,D101..D104,all of it,6\n");
    }
    void TearDown() override { std::filesystem::remove_all(root); }
    [[nodiscard]] std::string file(const std::string& name) const { return (root / name).string(); }
    void write(const std::string& name, const std::string& text) const { write_text(file(name), text); }
    [[nodiscard]] FrontPage read() const {
        return read_front_page(file("conclusions.csv"), {file("reports/chapter3")}, file("reports"));
    }
    [[nodiscard]] std::string message() const {
        try {
            static_cast<void>(read());
        } catch (const Error& e) {
            return e.what();
        }
        return "no error";
    }

    std::filesystem::path root;
};

TEST_F(FrontPageProject, ids_and_ranges_name_statements_only) {
    const Ledger ledger = read().ledger;
    EXPECT_EQ(parse_ids("D101..D104", ledger, "a"), (std::vector<std::string>{"D101", "D103", "D104"}));
    EXPECT_EQ(parse_ids("D105 D101", ledger, "a"), (std::vector<std::string>{"D105", "D101"}));
    EXPECT_THROW(static_cast<void>(parse_ids("D102", ledger, "a")), Error);  // an input
    EXPECT_THROW(static_cast<void>(parse_ids("D101..D999", ledger, "a")), Error);
    EXPECT_THROW(static_cast<void>(parse_ids("X001", ledger, "a")), Error);
    EXPECT_THROW(static_cast<void>(parse_ids("", ledger, "a")), Error);
    EXPECT_EQ(list_statements(ledger, 4), (std::vector<std::string>{"D104", "D105"}));
    EXPECT_EQ(list_statements(ledger, 0).size(), 4U);
}

TEST_F(FrontPageProject, a_file_of_checks_reads_back_as_it_was_written) {
    const FrontPage page = read();
    EXPECT_EQ(checks_to_csv(page.reports.at(0).outcomes), read_text(file("reports/chapter3/checks.csv")));
    const Outcome& h = page.reports[0].outcomes[0];
    EXPECT_EQ(h.claim.comparison, Comparison::equal);
    EXPECT_DOUBLE_EQ(h.uncertainty, 12.0487);
    EXPECT_EQ(h.ledger.line, 686U);
    EXPECT_EQ(page.reports[0].title, "Chapter 3: a wheel");
    EXPECT_EQ(page.reports[0].directory, "chapter3/");
}

TEST_F(FrontPageProject, counts_checks_and_statements_without_one) {
    const FrontPage page = read();
    const Standing s = count_standing(page, list_statements(page.ledger, 0));
    EXPECT_EQ(s.checks, (std::array<std::size_t, verdict_count>{1, 1, 0, 0, 1}));  // the closed form is no statement
    EXPECT_EQ(s.unchecked, 2U);
    EXPECT_EQ(count_standing(page, page.conclusions.at(0).rests_on).unchecked, 1U);
}

TEST_F(FrontPageProject, shows_every_statement_once_a_check) {
    const FrontPage page = read();
    const Document d = compose(page, PageKind::markdown);
    EXPECT_EQ(
        d.first_line,
        "Verdicts: 1 match, 1 unresolved, 0 differs-explained, 0 not-reproduced, 1 not-computable — statements without "
        "a check yet: 2.");
    const std::string text = to_markdown(d);
    const auto shows = [&](const std::string& line) { return text.find(line) != std::string::npos; };
    EXPECT_TRUE(shows("| [Chapter 3: a wheel](chapter3/report.md) | 1 | 1 | – | – | 1 | – | 1 of 1 match |\n")) << text;
    EXPECT_TRUE(shows("| Chapter 4 (no report yet) | – | – | – | – | – | 2 | – |\n"));
    EXPECT_TRUE(shows("| All | 1 | 1 | – | – | 1 | 2 | 1 of 1 match |\n"));
    EXPECT_TRUE(shows("1 of 3 checks match: D101-b; 1 unresolved: D101; 1 not-computable: D103; no check yet: D104."));
    EXPECT_TRUE(
        shows("| D101 | H; slip 60 % | 102 N (Fig 3-17a, line 686) | 99 ± 12 N | "
              "[unresolved (expected match)](chapter3/report.md#all-verdicts) |"));
    EXPECT_TRUE(
        shows("| D101-b | H; slip 60 % | > 90 N (Fig 3-17a, line 686) | 99 ± 12 N | "
              "[match](chapter3/report.md#all-verdicts) | a bound |"));
    EXPECT_TRUE(shows("| D103 | Sinkage \\| a trend | monotonic (Fig 3-14, line 643) | – | [not-computable]"));
    EXPECT_TRUE(shows("| D105 | Exit angle | 105 deg (4.3.1, line 901) | – | no check yet |"));
    EXPECT_FALSE(shows("X001"));
    write_front_page(file("conclusions.csv"), {file("reports/chapter3")}, file("reports"));
    EXPECT_EQ(read_text(file("reports/README.md")), text);
    EXPECT_TRUE(read_text(file("reports/index.html")).starts_with("<body><header>"));
}

TEST_F(FrontPageProject, pages_lead_to_pages_of_their_kind) {
    const std::string html = to_html(compose(read(), PageKind::html), "", "{{body}}", "");
    EXPECT_NE(html.find("<span><a href=\"chapter3/index.html\">Chapter 3: a wheel</a></span>"), std::string::npos);
    EXPECT_NE(html.find("<a href=\"chapter3/index.html#verdicts\">match</a>"), std::string::npos);
    std::filesystem::remove(file("reports/chapter3/index.html"));
    EXPECT_EQ(to_html(compose(read(), PageKind::html), "", "{{body}}", "").find("chapter3/"), std::string::npos);
}

TEST_F(FrontPageProject, says_what_is_wrong) {
    write("reports/chapter3/checks.csv",
          std::string(checks_header) + "D999,3,H,N,,102,98,1,8,12,0,match,match,,a,12\n");
    EXPECT_NE(message().find("checks.csv:2: D999 is no row of the ledger"), std::string::npos) << message();
    write("reports/chapter3/checks.csv", std::string(checks_header) + "D101,3,H,N,,102,98,1,8,12,0,good,match,,a,12\n");
    EXPECT_NE(message().find("checks.csv:2: D101"), std::string::npos) << message();
    EXPECT_THROW(static_cast<void>(read_front_page(file("conclusions.csv"), {file("reports")}, "")), Error);
}

// A check that a newer claims.csv has dropped is shown as it stands; a file from before U was written shows none.
TEST_F(FrontPageProject, older_checks_are_shown_as_they_stand) {
    std::string old(checks_header);
    old.replace(old.find(",uncertainty"), 12, "");
    write("reports/chapter3/checks.csv", old + "D101-z,3,H,N,,102,98.883,1,8,12,0,match,match,,a\n");
    EXPECT_NE(
        to_markdown(compose(read(), PageKind::markdown)).find("| D101-z | H | 102 (Fig 3-17a, line 686) | 98.88 N |"),
        std::string::npos);
}

TEST(Conclusions, rest_on_statements_of_the_ledger) {
    const FrontPage page = read_front_page(IFEDEM_SOURCE_DIR "/reproductions/chapter6/conclusions.csv", {}, "");
    EXPECT_EQ(page.conclusions.front().point, "1");
    EXPECT_EQ(page.conclusions.back().point, "3");
    EXPECT_EQ(page.conclusions.back().rests_on.back(), "D271");
}

}  // namespace
}  // namespace ifedem
