#include "app/calibrate.hpp"

#include <fmt/format.h>
#include <omp.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <thread>

#include "app/calibrate_report.hpp"
#include "check/csv.hpp"
#include "check/measurements.hpp"
#include "check/statistics.hpp"
#include "core/error.hpp"
#include "record/directory_lock.hpp"
#include "record/files.hpp"
#include "soil_tests/world.hpp"
#include "step/limits.hpp"

namespace ifedem {
namespace {

/// Every job once, in order, on `count` threads; each takes the next when it is free. One job's samples are too small
/// to share among threads. The first error is thrown when all have ended.
void run_on_threads(const std::vector<std::function<void()>>& jobs, int count) {
    std::atomic<std::size_t> next{0};
    std::vector<std::exception_ptr> failed(jobs.size());
    const auto work = [&] {
        omp_set_num_threads(1);  // of this thread
        for (std::size_t n = next++; n < jobs.size(); n = next++) {
            try {
                jobs[n]();
            } catch (...) {
                failed[n] = std::current_exception();
            }
        }
    };
    {
        std::vector<std::jthread> threads;
        for (int k = 0; k < count; ++k) threads.emplace_back(work);
    }
    for (const std::exception_ptr& error : failed)
        if (error) std::rethrow_exception(error);
}

/// The sand itself first. Each step is large enough to be seen over the scatter of a few realisations.
std::vector<SandVariant> list_variants(const Case& c, Knobs knobs) {
    const ContactCase& own = c.contact;
    std::vector<SandVariant> variants{{"", "", c, {}}};
    if (knobs == Knobs::leave) return variants;
    const auto add = [&](const char* key, const std::string& change, auto&& turn) {
        SandVariant v{key, change, c, {}};
        turn(v.c.contact);
        variants.push_back(v);
    };
    add("contact.rolling_factor", "to 0", [](ContactCase& k) { k.rolling_factor = 0; });
    add("contact.rolling_factor", "× 0.1", [](ContactCase& k) { k.rolling_factor *= 0.1; });
    add("contact.friction_soil", "× 0.5", [](ContactCase& k) { k.friction_soil *= 0.5; });
    add("contact.normal_stiffness_N_m, tangential_stiffness_N_m", "× 2",
        [](ContactCase& k) { k.normal_stiffness_N_m *= 2, k.tangential_stiffness_N_m *= 2; });
    add("contact.consolidation_friction_soil", fmt::format("to {:g}", own.friction_soil),
        [](ContactCase& k) { k.consolidation_friction_soil = k.friction_soil; });
    return variants;
}

/// By what follows from the discs alone: a wheel's limits are not the sand's.
void refuse_what_cannot_be_tested(const CalibrateRequest& request, const std::vector<SandVariant>& variants) {
    if (!std::isfinite(request.stress_kPa))
        fail_input(
            fmt::format("--stress {} is no stress (it must be a finite number, kPa). Correct it?", request.stress_kPa));
    if (!(variants.front().c.gravity_m_s2 > 0))
        fail_input(
            fmt::format("{}: gravity_m_s2 is 0 (heap and plate need the sand's weight). Give the sand some gravity?",
                        request.case_path));
    for (const SandVariant& v : variants) {
        Scene scene = make_scene(soil_of(v.c), Stage::consolidation);
        scene.dem.soil.friction = v.c.contact.friction_soil;
        const std::vector<StepLimit> limits = find_case_limits(scene);
        if (const StepLimit* worst = find_worst(limits, v.c.time_step_s, Among::certain))
            fail_input(explain_excess(*worst, v.c.time_step_s));
        if (v.c.time_step_s > point_of_a_curve_s)
            fail_input(
                fmt::format("{}: time_step_s = {:g} s is longer than a point of a test's curve ({:g} s). Lower it?",
                            request.case_path, v.c.time_step_s, point_of_a_curve_s));
    }
}

void test_all(const CalibrateRequest& request, std::vector<SandVariant>& variants) {
    std::vector<std::function<void()>> jobs;
    const bool terminal = isatty(STDERR_FILENO) == 1;
    std::mutex showing;
    std::size_t done = 0;
    for (SandVariant& v : variants) v.tests.resize(static_cast<std::size_t>(request.realisations));
    for (SandVariant& v : variants)
        for (std::size_t k = 0; k < v.tests.size(); ++k)
            for (const SandTest test : every_sand_test)
                jobs.emplace_back([&, k, test] {
                    Case sand = soil_of(v.c);
                    sand.bed.seed += static_cast<std::int64_t>(k);
                    run_sand_test(test, sand, request.effort, 1e3 * request.stress_kPa, v.tests[k]);
                    const std::lock_guard lock(showing);
                    ++done;
                    if (terminal) fmt::print(stderr, "\r{} of {} tests", done, jobs.size());
                });
    run_on_threads(jobs, request.jobs);
    if (terminal) fmt::print(stderr, "\n");
}

std::string measurement_table(const SandVariant& sand) {
    std::vector<Measurement> measured;
    for (const SandQuantity& q : sand_quantities()) {
        const std::vector<double> values = read_values(sand, q);
        measured.push_back(
            {q.name, mean(values), q.units, standard_deviation(values), values.size(), q.test + ": " + q.title});
    }
    return measurements_csv(measured);
}

std::string realisation_table(const std::vector<SandVariant>& variants) {
    std::string text = csv_line({"key", "change", "seed", "name", "value", "units"});
    for (const SandVariant& v : variants)
        for (const SandQuantity& q : sand_quantities()) {
            const std::vector<double> values = read_values(v, q);
            for (std::size_t k = 0; k < values.size(); ++k)
                text += csv_line({v.key, v.change, std::to_string(v.c.bed.seed + static_cast<std::int64_t>(k)), q.name,
                                  format_number(values[k]), q.units});
        }
    return text;
}

}  // namespace

void calibrate(const CalibrateRequest& request) {
    std::vector<SandVariant> variants = list_variants(read_case(request.case_path, request.overrides), request.knobs);
    refuse_what_cannot_be_tested(request, variants);
    std::filesystem::create_directories(request.directory);
    const DirectoryLock lock(request.directory, Busy::refuse);
    test_all(request, variants);
    write_file_atomically(request.directory + "/measurements.csv", measurement_table(variants.front()));
    write_file_atomically(request.directory + "/realisations.csv", realisation_table(variants));
    if (request.knobs == Knobs::turn) write_file_atomically(request.directory + "/knobs.csv", knob_table(variants));
    write_calibration_report(request, variants);
    fmt::print("report: {}/index.html\n", request.directory);
}

}  // namespace ifedem
