#include "app/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "core/error.hpp"
#include "model/case.hpp"
#include "record/files.hpp"
#include "record/frame_file.hpp"
#include "record/soil_files.hpp"

namespace ifedem {
namespace {

constexpr double column_m = 0.012;  // two of the largest discs of chapter 5

/// Highest y per column of the bin.
struct Profile {
    double length_m = 0;
    std::vector<double> top_m;

    void raise(double x_m, double y_m) {
        const double at = x_m / length_m * static_cast<double>(top_m.size());
        if (at >= 0 && at < static_cast<double>(top_m.size())) {
            double& top = top_m[static_cast<std::size_t>(at)];
            top = std::max(top, y_m);
        }
    }
};

/// Along the highest side of an element.
void raise_along(Profile& profile, Vec2 left, Vec2 right) {
    const int parts = static_cast<int>(std::ceil((right.x - left.x) / (0.25 * column_m)));
    for (int n = 0; n <= parts; ++n) {
        const Vec2 p = left + static_cast<double>(n) / std::max(parts, 1) * (right - left);
        profile.raise(p.x, p.y);
    }
}

Profile profile_of(const std::string& run, const Frame& frame, double length_m) {
    Profile profile;
    profile.length_m = length_m;
    profile.top_m.resize(static_cast<std::size_t>(std::lround(length_m / column_m)), 0.0);
    for (std::size_t n = 0; n < frame.disc_id.size(); ++n)
        profile.raise(frame.disc_position_m[n].x,
                      frame.disc_position_m[n].y + static_cast<double>(frame.disc_radius_m[n]));
    const SoilOutline soil = read_soil_outline(run, frame.time_s);
    for (const auto& disc : soil.attached) profile.raise(disc.centre_m.x, disc.centre_m.y + disc.radius_m);
    for (const auto& corner : soil.element_m) raise_along(profile, corner[3], corner[2]);
    return profile;
}

}  // namespace

void write_surface(const SurfaceRequest& request) {
    const std::string path = request.run + "/results.h5";
    const FrameReader results(path);
    const std::size_t count = results.frames().size();
    if (count == 0) fail_input(fmt::format("{} holds no frame (was the run stopped?). Run the case again?", path));
    const double length = parse_case(results.header().case_text, path).bed.length_m;
    const Profile first = profile_of(request.run, results.read(0), length),
                  last = profile_of(request.run, results.read(count - 1), length);
    std::string text = "x_m,top_m,first_m\n";
    for (std::size_t n = 0; n < last.top_m.size(); ++n)
        fmt::format_to(std::back_inserter(text), "{:.5f},{:.5f},{:.5f}\n",
                       (static_cast<double>(n) + 0.5) * length / static_cast<double>(last.top_m.size()), last.top_m[n],
                       first.top_m[n]);
    write_file_atomically(request.output, text);
}

}  // namespace ifedem
