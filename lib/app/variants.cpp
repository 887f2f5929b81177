#include "app/variants.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/children.hpp"
#include "core/error.hpp"
#include "model/case_changes.hpp"

namespace ifedem {
namespace {

Case in_realisation_of(const Case& original, int k, Case variant) {
    const Case realisation = make_realisation(original, k);
    variant.bed.seed = realisation.bed.seed;
    variant.wheel.lug_phase_deg = realisation.wheel.lug_phase_deg;
    return variant;
}

MeasuredVariant measure_runs(std::span<const WantedRun> runs, std::span<const int> status) {
    MeasuredVariant measured;
    measured.status = *std::max_element(status.begin(), status.end());
    if (measured.status != 0) {
        measured.note = measured.status == static_cast<int>(ExitCode::health)
                            ? "stopped by a health check"
                            : fmt::format("a run ended with status {}", measured.status);
        return measured;
    }
    try {
        for (const WantedRun& run : runs)
            measured.metrics.push_back(measure(read_run(run.directory), compared_window(run.c)));
    } catch (const Error& error) {
        return {{}, static_cast<int>(error.code()), error.what()};
    }
    return measured;
}

}  // namespace

std::vector<WantedRun> plan_variants(const VariantRequest& request, const std::vector<Variant>& variants) {
    if (request.realisations < 2)
        fail_input(fmt::format("--n {} leaves scatter unknown (it needs at least two realisations). Give --n 3?",
                               request.realisations));
    const Case file = read_case(request.case_path);
    std::vector<WantedRun> runs;
    for (const Variant& variant : variants) {
        (void)trim(compared_window(variant.c), lug_pair_pitch_m(variant.c));
        for (int k = 1; k <= request.realisations; ++k)
            runs.push_back(want_run(request.case_path,
                                    list_changes(file, in_realisation_of(request.original, k, variant.c)),
                                    fmt::format("{}/{}-r{}", request.directory, variant.name, k)));
    }
    return runs;
}

std::string describe_settings(const Case& from, const Case& to) {
    std::string text;
    for (const Override& change : list_changes(from, to))
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", change.key, change.value);
    return text;
}

std::vector<MeasuredVariant> measure_variants(const VariantRequest& request, const std::vector<Variant>& variants) {
    const std::vector<WantedRun> runs = plan_variants(request, variants);
    const std::vector<int> status = make_runs(runs, request.options);
    if (signal_of_children() != 0) return std::vector<MeasuredVariant>(variants.size());
    const auto n = static_cast<std::size_t>(request.realisations);
    std::vector<MeasuredVariant> measured;
    for (std::size_t v = 0; v < variants.size(); ++v)
        measured.push_back(measure_runs(std::span(runs).subspan(v * n, n), std::span(status).subspan(v * n, n)));
    return measured;
}

}  // namespace ifedem
