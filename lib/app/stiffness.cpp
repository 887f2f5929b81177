#include "app/stiffness.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "check/run.hpp"
#include "fem/radial_stiffness.hpp"
#include "model/case.hpp"
#include "record/files.hpp"

namespace ifedem {

void write_stiffness(const StiffnessRequest& request) {
    constexpr int phases = 8, points = 12;
    std::filesystem::create_directories(request.directory);
    std::string curves = "wheel,phase_deg,deflection_m,load_N\n";
    std::string summary = "wheel,stiffness_N_mm,min_N_mm,max_N_mm\n";
    for (const std::string& path : request.case_paths) {
        const Case c = read_case(path);
        const std::string wheel = condition_of(c).wheel;
        const double load_N = request.load_N > 0 ? request.load_N : c.wheel.load_N;
        const RadialStiffness k = find_radial_stiffness(c.wheel, load_N, phases);
        summary += fmt::format("{},{:.6g},{:.6g},{:.6g}\n", wheel, 1e-3 * k.mean_N_m, 1e-3 * k.smallest_N_m,
                               1e-3 * k.largest_N_m);
        std::vector<double> deflections;
        const double deepest = 1.3 * load_N / k.smallest_N_m;
        for (int n = 0; n <= points; ++n) deflections.push_back(deepest * n / points);
        for (int p = 0; p < phases; p += 2) {
            const double phase = lug_pitch_deg(c.wheel) * p / phases;
            for (const LoadDeflection& row : press_on_plane(c.wheel, deflections, phase))
                curves += fmt::format("{},{:.4g},{:.6g},{:.6g}\n", wheel, phase, row.deflection_m, row.load_N);
        }
        fmt::print("{} ({}): {:.2f} N/mm at {:g} N ({:.2f} to {:.2f} over a lug pitch)\n", path, wheel,
                   1e-3 * k.mean_N_m, load_N, 1e-3 * k.smallest_N_m, 1e-3 * k.largest_N_m);
    }
    write_file_atomically(request.directory + "/stiffness.csv", curves);
    write_file_atomically(request.directory + "/stiffness_summary.csv", summary);
}

}  // namespace ifedem
