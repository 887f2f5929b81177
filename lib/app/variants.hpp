#pragma once
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "app/run_set.hpp"
#include "check/metrics.hpp"
#include "core/error.hpp"
#include "model/case.hpp"

namespace ifedem {

/// A case under a name that is a part of its runs' directories.
struct Variant {
    std::string name;
    Case c;
};

/// The realisations in which every variant is run.
struct VariantRequest {
    std::string case_path;  ///< children are told by --set in what a variant differs from this file
    std::string directory;  ///< runs are DIRECTORY/NAME-rK
    Case original;          ///< gives the realisations: variants of the mesh have the lug phases of this one
    int realisations = 3;
    RunSetOptions options;
};

/// Window means of a variant by realisation; none if a run did not end well.
struct MeasuredVariant {
    std::vector<RunMetrics> metrics;
    int status = 0;    ///< the worst of its runs
    std::string note;  ///< why there is nothing
};

/// Throws Error(bad_input), before anything is run, if the realisations are fewer than two, a variant is no case, or
/// the case travels too short a way for one pair of lugs.
[[nodiscard]] std::vector<WantedRun> plan_variants(const VariantRequest& request, const std::vector<Variant>& variants);

/// Makes what is missing of the planned runs and measures them over compared_window(). After a signal
/// (signal_of_children()) what it returns says nothing.
[[nodiscard]] std::vector<MeasuredVariant> measure_variants(const VariantRequest& request,
                                                            const std::vector<Variant>& variants);

/// The entry of this name in the table that `--only TEXT` chooses from. Throws Error(bad_input), listing the names;
/// `how`: what there is "less" or "more" of.
template <class Entry, std::size_t N>
[[nodiscard]] const Entry& find_named(const Entry (&table)[N], const std::string& name, const std::string& only,
                                      std::string_view how) {
    std::string names;
    for (const Entry& entry : table) {
        if (entry.name == name) return entry;
        names += (names.empty() ? "" : ", ") + std::string(entry.name);
    }
    fail_input(
        fmt::format("--only {}: '{}' is nothing that can be {} (there are {}). Correct it?", only, name, how, names));
}

/// "bed.disc_count = 600, bed.length_m = 1.2".
[[nodiscard]] std::string describe_settings(const Case& from, const Case& to);

}  // namespace ifedem
