#include "app/surface_profile.hpp"

#include <algorithm>
#include <vector>

#include "check/statistics.hpp"
#include "model/case.hpp"
#include "record/frame_file.hpp"

namespace ifedem {
namespace {

/// Heights of the highest disc tops over columns of two mean diameters; none where not one column fits.
struct Profile {
    std::vector<double> x_m, top_m;
};
Profile take_profile(const Frame& frame, double from_m, double to_m, double column_m) {
    Profile p;
    const auto columns = static_cast<std::size_t>(std::max(0.0, (to_m - from_m) / column_m));
    p.top_m.assign(columns, 0.0);
    for (std::size_t k = 0; k < columns; ++k) p.x_m.push_back(from_m + (static_cast<double>(k) + 0.5) * column_m);
    for (std::size_t n = 0; n < frame.disc_position_m.size(); ++n) {
        const double at = (frame.disc_position_m[n].x - from_m) / column_m;
        if (!(at >= 0 && at < static_cast<double>(columns))) continue;
        double& top = p.top_m[static_cast<std::size_t>(at)];
        top = std::max(top, frame.disc_position_m[n].y + static_cast<double>(frame.disc_radius_m[n]));
    }
    return p;
}

double roughness(const Profile& p) {
    if (p.x_m.size() < 3) return SurfaceMeasure::unknown;
    const std::vector<double> weights(p.x_m.size(), 1.0);
    const PolynomialFit line = fit_polynomial(p.x_m, p.top_m, weights, 1);
    std::vector<double> rest;
    for (std::size_t k = 0; k < p.x_m.size(); ++k) rest.push_back(p.top_m[k] - line.at(p.x_m[k]));
    return standard_deviation(rest);
}

double highest(const Profile& p) { return p.top_m.empty() ? SurfaceMeasure::unknown : std::ranges::max(p.top_m); }

}  // namespace

SurfaceMeasure measure_surface(const std::string& run_directory) {
    const std::string path = run_directory + "/results.h5";
    const FrameReader results(path);
    if (results.frames().empty()) return {};
    const Case c = parse_case(results.header().case_text, path);
    const Frame last = results.read(results.frames().size() - 1);
    const double radius = c.wheel.tread_radius_m, hub = last.hub_position_m.x;
    const double column = 4 * *std::max_element(c.soil.radii_m.begin(), c.soil.radii_m.end());
    // Behind: from where the ramp of speed ended to a radius behind the hub, where contact has ended; ahead: from where
    // the heap ends to the same distance from the wall.
    const Profile behind = take_profile(last, c.travel.start_x_m + ramp_way_m(c.travel), hub - radius, column);
    const Profile ahead = take_profile(last, hub + radius, c.bed.length_m - column, column);
    SurfaceMeasure m;
    m.rough_behind_m = roughness(behind), m.rough_ahead_m = roughness(ahead);
    m.highest_behind_m = highest(behind) - mean(ahead.top_m);
    m.highest_ahead_m = highest(ahead) - mean(ahead.top_m);
    return m;
}

}  // namespace ifedem
