// The front page of the committed reports is what their checks give, byte for byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "check/csv.hpp"
#include "check/front_page.hpp"
#include "support/synthetic_runs.hpp"

namespace ifedem {
namespace {

TEST(CommittedPage, is_made_of_the_committed_checks) {
    const std::string reports = IFEDEM_SOURCE_DIR "/reports";
    const std::filesystem::path scratch = test::fresh_directory("committed-page");
    std::vector<std::string> chapters;
    for (const auto& entry : std::filesystem::directory_iterator(reports))
        if (entry.path().filename().string().starts_with("chapter") &&
            std::filesystem::exists(entry.path() / "checks.csv"))
            chapters.push_back(entry.path().string());
    std::sort(chapters.begin(), chapters.end());
    ASSERT_GE(chapters.size(), 2U);
    // Beside copies of the chapters, so that the page leads to them by the same names.
    std::vector<std::string> copies;
    for (const std::string& chapter : chapters) {
        copies.push_back((scratch / std::filesystem::path(chapter).filename()).string());
        std::filesystem::copy(chapter, copies.back());
    }
    write_front_page(IFEDEM_SOURCE_DIR "/reproductions/chapter6/conclusions.csv", copies, scratch.string());
    for (const char* name : {"index.html", "README.md"})
        EXPECT_TRUE(read_text((scratch / name).string()) == read_text(reports + "/" + name))
            << "reports/" << name << " is older than the checks, claims or style beside it. make front-page renews it.";
    std::filesystem::remove_all(scratch);
}

}  // namespace
}  // namespace ifedem
