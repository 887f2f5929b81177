#include "check/report.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "check/csv.hpp"
#include "check/document.hpp"
#include "check/html.hpp"
#include "core/error.hpp"
#include "support/synthetic_runs.hpp"

using namespace ifedem;
using namespace ifedem::test;
namespace fs = std::filesystem;

namespace {

/// Runs as the campaign of chapter 3 makes them, with made-up numbers near the text's, and both wheels' stiffness.
std::vector<std::string> write_campaign(const fs::path& root) {
    std::vector<std::string> runs;
    Random random{5};
    const auto noise = [&](double width) { return width * (2 * random.uniform() - 1); };
    const auto add = [&](const char* wheel, const char* planet, double load, double slip, int realisation) {
        const double share = load / 170;
        const double stiff = std::string(wheel) == "B6" ? 1 : 0;
        const double effort = share * (22 - 8 * stiff + 1.35 * slip) + noise(2) * share;
        const double pull = share * (-18 - 6 * stiff + 1.0 * slip) + noise(2) * share;
        const bool is_mars = std::string(planet) == "mars";
        runs.push_back(write_synthetic_run(
            root, {.name = fmt::format("{}-{}-{:g}N-s{:g}-r{}", wheel, planet, load, slip, realisation),
                   .gravity_m_s2 = is_mars ? 3.71 : 9.81,
                   .load_N = load,
                   .slip_percent = slip,
                   .seed = realisation,
                   .effort_N = effort,
                   .net_traction_N = pull,
                   .sinkage_m = -0.01 - 0.01 * (is_mars ? 1 : share) - (6.2e-4 - 1e-4 * stiff) * slip + noise(5e-4),
                   .effective_radius_m = 0.1402 + 0.0064 * stiff + (4e-5 - 3e-5 * stiff) * slip + noise(1e-4),
                   .intermediate_young_Pa = stiff > 0 ? 0.3e6 : 0.05e6}));
    };
    for (const char* wheel : {"B3", "B6"})
        for (int slip = 0; slip <= 70; slip += 10)
            for (int r = 1; r <= (slip == 60 ? 3 : 1); ++r) {
                for (const double load : {50, 100, 170}) add(wheel, "earth", load, slip, r);
                add(wheel, "mars", 64.4, slip, r);
            }
    // Any bytes will do for a picture: the report embeds them as they are.
    for (const auto& run : runs)
        if (run.find("earth-170N-s20-r1") != std::string::npos)
            write_text(run + "/snapshot.png", std::string("\x89PNG\r\n\x1a\n", 8));
    std::string points = "wheel,phase_deg,deflection_m,load_N\n";
    for (const auto& [wheel, k] : {std::pair{"B3", 15.8}, {"B6", 50.0}})
        for (const double phase : {0.0, 15.0})
            for (int load = 0; load <= 170; load += 17)
                points += fmt::format("{},{},{:.6g},{}\n", wheel, phase, 1e-3 * load / (k + phase / 10), load);
    write_text((root / "stiffness/stiffness.csv").string(), points);
    write_text((root / "stiffness/stiffness_summary.csv").string(),
               "wheel,stiffness_N_mm,min_N_mm,max_N_mm\nB3,15.8,15.6,16.0\nB6,50,48,52\n");
    runs.push_back((root / "stiffness").string());
    return runs;
}

}  // namespace

TEST(Html, EscapesAndTypesets) {
    EXPECT_EQ(escape_html("a < b & \"c\""), "a &lt; b &amp; &quot;c&quot;");
    EXPECT_EQ(typeset("P_d < r_e"), "<i>P</i><sub>d</sub> &lt; <i>r</i><sub>e</sub>");
}

TEST(Html, Base64OfRfc4648) {
    // RFC 4648, section 10.
    for (const auto& [plain, coded] : {std::pair{"", ""},
                                       {"f", "Zg=="},
                                       {"fo", "Zm8="},
                                       {"foo", "Zm9v"},
                                       {"foob", "Zm9vYg=="},
                                       {"fooba", "Zm9vYmE="},
                                       {"foobar", "Zm9vYmFy"}})
        EXPECT_EQ(encode_base64(plain), coded);
}

TEST(Html, SvgIdsAreItsOwn) {
    const std::string svg =
        "<?xml version='1.0'?>\n<svg width='1'><g id=\"a\"/><use xlink:href='#b'/><p fill='url(#c)'/></svg>";
    const std::string out = inline_svg(svg, "f1", "A \"plot\"");
    EXPECT_EQ(out.substr(0, 4), "<svg");
    EXPECT_NE(out.find("id=\"f1-a\""), std::string::npos);
    EXPECT_NE(out.find("href='#f1-b'"), std::string::npos);
    EXPECT_NE(out.find("url(#f1-c)"), std::string::npos);
    EXPECT_NE(out.find("aria-label=\"A &quot;plot&quot;\""), std::string::npos);
}

TEST(Markdown, TablesKeepTheirColumns) {
    Document d;
    d.first_line = "Verdicts: 1 match";
    d.title = "T";
    Table t;
    t.header = {"a", "b"};
    t.rows = {{{"|x|", ""}, {"y\nz", ""}}};
    d.sections.push_back({"s", "S", {t}});
    const std::string text = to_markdown(d);
    EXPECT_EQ(text.substr(0, text.find('\n')), "Verdicts: 1 match");
    EXPECT_NE(text.find("| a | b |\n|---|---|\n| \\|x\\| | y z |\n"), std::string::npos) << text;
}

TEST(Report, IsCompleteSelfContainedAndTheSameTwice) {
    const fs::path root = fresh_directory("report");
    const std::string source = IFEDEM_SOURCE_DIR;
    ReportRequest request{source + "/reproductions/chapter3/claims.csv", write_campaign(root / "runs"),
                          (root / "one").string(), "Tractive performance of an elastic wheel for planetary rovers", ""};
    write_report(request);
    const std::string html = read_text((root / "one/index.html").string());
    const std::string markdown = read_text((root / "one/report.md").string());
    EXPECT_EQ(markdown.substr(0, 10), "Verdicts: ");
    EXPECT_LT(html.find("Verdicts: "), html.find("<h1>"));
    EXPECT_EQ(html.find("{{"), std::string::npos);
    EXPECT_EQ(html.find("src=\"figures"), std::string::npos);  // nothing is loaded from elsewhere
    EXPECT_EQ(html.find("http://"), html.find("http://www.w3.org"));
    EXPECT_EQ(html.find("<script"), std::string::npos);
    for (const char* name : {"agreement", "fig3-7b", "fig3-8b", "fig3-9b", "fig3-11b", "fig3-12b", "fig3-13b",
                             "fig3-14b", "fig3-15b", "fig3-16a", "fig3-16b", "fig3-17a", "fig3-17b", "fig3-18a",
                             "fig3-18b", "fig3-19a", "fig3-19b", "stiffness", "travel"}) {
        EXPECT_NE(html.find(fmt::format("<figure id=\"{}\"", name)), std::string::npos) << name;
        EXPECT_TRUE(fs::exists(root / "one/figures" / (std::string(name) + ".csv"))) << name;
    }
    EXPECT_NE(html.find("<figure id=\"fig3-6\""), std::string::npos);
    EXPECT_NE(html.find("<figure id=\"fig3-10\""), std::string::npos);
    EXPECT_NE(html.find("data:image/png;base64,iVBORw0KGgo="),
              std::string::npos);  // the run's own picture, byte by byte
    EXPECT_EQ(read_csv((root / "one/runs.csv").string()).rows.size(), 80U);
    EXPECT_GE(read_csv((root / "one/checks.csv").string()).rows.size(), 53U);
    EXPECT_NE(html.find("text: 102"), std::string::npos);
    EXPECT_NE(html.find("left over"), std::string::npos);
    EXPECT_LT(html.size(), 5U << 20);

    request.out_dir = (root / "two").string();
    write_report(request);
    EXPECT_EQ(html, read_text((root / "two/index.html").string()));
    EXPECT_EQ(markdown, read_text((root / "two/report.md").string()));
    if (std::getenv("IFEDEM_KEEP_REPORT") == nullptr) fs::remove_all(root);
}

TEST(Report, DrawsFilesThatDirectoriesHold) {
    const fs::path root = fresh_directory("report-files");
    write_text((root / "reference_data/dissertation.csv").string(),
               "id,chapter,quantity,symbol,value,units,condition,source,line,kind,note\n"
               "D001,2,A number,x,1,-,,Eq 1,1,result,\n");
    const std::string source = IFEDEM_SOURCE_DIR;
    fs::create_directories(root / "reports");
    fs::copy(source + "/reports/templates", root / "reports/templates");
    fs::copy(source + "/reports/style.gp", root / "reports/style.gp");
    const fs::path chapter = root / "reproductions/chapter2";
    write_text((chapter / "claims.csv").string(),
               "id,metric,window,wheel,gravity,load_N,slip_percent,compare,reference,tolerance,tolerance_origin,"
               "expected,evidence,note\nD001,measured:x,,,,,,equal,,0.1,a test,match,,\n");
    write_text((chapter / "choices.csv").string(), "key,value,text_says,reason,sensitivity\n");
    write_text((chapter / "curve.gp").string(), "load style\nplot data using 1:2 with lines\n");
    write_text((chapter / "figures.csv").string(),
               "name,script,data,metric,series,title,ylabel,caption,style\n"
               "second,curve.gp,file,b,out/curve.csv,Second,,,\n"
               "first,curve.gp,file,,out/curve.csv,First,,,\n"
               "picture,,file,,picture.png,Picture,,,\n"
               "absent,curve.gp,file,,nowhere.csv,Absent,,,\n");
    const std::string measured = "name,value,units,scatter,n,note\n";
    write_text((root / "a/measurements.csv").string(), measured + "x,1.05,-,,1,a note\n");
    write_text((root / "b/measurements.csv").string(), measured);
    write_text((root / "a/out/curve.csv").string(), "x,y\n0,1\n1,2\n");
    write_text((root / "b/out/curve.csv").string(), "x,y\n0,3\n1,4\n");
    write_text((root / "b/picture.png").string(), std::string("\x89PNG\r\n\x1a\n", 8));
    write_report({(chapter / "claims.csv").string(),
                  {(root / "a").string(), (root / "b/").string()},
                  (root / "out").string(),
                  "",
                  ""});
    EXPECT_EQ(read_text((root / "out/figures/first.csv").string()), "x,y\n0,1\n1,2\n");
    EXPECT_EQ(read_text((root / "out/figures/second.csv").string()), "x,y\n0,3\n1,4\n");
    EXPECT_TRUE(fs::exists(root / "out/figures/first.svg"));
    EXPECT_TRUE(fs::exists(root / "out/figures/picture.png"));
    EXPECT_FALSE(fs::exists(root / "out/figures/absent.csv"));
    const std::string markdown = read_text((root / "out/report.md").string());
    EXPECT_EQ(markdown.find("Verdicts: 1 match"), 0U) << markdown.substr(0, 100);
    EXPECT_NE(markdown.find("a note"), std::string::npos);
    fs::remove_all(root);
}

TEST(Report, SaysWhatMoreOfEverythingWouldChange) {
    const fs::path root = fresh_directory("report-doubt");
    const std::string source = IFEDEM_SOURCE_DIR;
    write_text((root / "doubt/doubt.csv").string(),
               "variation,changes,quantity,unit,n,default,variant,difference,half_width,tolerance,verdict,n_needed,"
               "relative_cost,note\n"
               "depth,bed.disc_count = 2000,H,N,3,100,104,4,3,5,moves,1,2,\n"
               "depth,bed.disc_count = 2000,Pd,N,3,50,50.5,0.5,2,2.5,within scatter,2,2,\n"
               "step,time_step_s = 4e-05,H,N,0,,,,,,not run,,2,stopped by a health check\n"
               "step,time_step_s = 4e-05,Pd,N,0,,,,,,not run,,2,stopped by a health check\n");
    write_report({source + "/reproductions/chapter3/claims.csv", {(root / "doubt").string()}, root.string(), "", ""});
    const std::string markdown = read_text((root / "report.md").string());
    EXPECT_NE(markdown.find("| More | What that is | n | Cost | ΔH [N] | ΔP_d [N] |"), std::string::npos) << markdown;
    EXPECT_NE(markdown.find("| Depth | bed.disc_count = 2000 | 3 | × 2 | +4.0 ± 3.0 | +0.5 ± 2.0 |"),
              std::string::npos);
    EXPECT_NE(markdown.find("| Step | time_step_s = 4e-05: stopped by a health check | 0 | × 2 | – | – |"),
              std::string::npos);
    const std::string html = read_text((root / "index.html").string());
    const std::size_t depth = html.find("bed.disc_count = 2000");
    const std::size_t step = html.find("time_step_s = 4e-05");
    EXPECT_LT(html.find("num strong", depth), step);  // H moves, P_d does not
    EXPECT_EQ(html.find("num strong", html.find("num strong", depth) + 1), std::string::npos);
    fs::remove_all(root);
}

TEST(Report, WithoutRunsSaysSo) {
    const fs::path root = fresh_directory("report-empty");
    const std::string source = IFEDEM_SOURCE_DIR;
    write_report({source + "/reproductions/chapter3/claims.csv", {}, root.string(), "", ""});
    const std::string markdown = read_text((root / "report.md").string());
    EXPECT_EQ(markdown.find("Verdicts: 0 match, 0 unresolved, 0 differs-explained, 0 not-reproduced, "), 0U);
    EXPECT_NE(markdown.find("no run of B3, Earth, 170 N, slip 60 %"), std::string::npos);
    fs::remove_all(root);
}
