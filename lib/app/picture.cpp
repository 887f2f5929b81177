#include "app/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/error.hpp"
#include "model/case.hpp"
#include "record/frame_file.hpp"
#include "record/snapshot.hpp"

namespace ifedem {
namespace {

/// A wheel's largest radius over that of the wheel for which the distances below were chosen.
double relative_size(const Mesh& wheel) {
    constexpr double chosen_for_m = 0.158;
    double largest_m = 0;
    for (const Vec2 node : wheel.node_m) largest_m = std::max(largest_m, norm(node));
    return largest_m > 0 ? largest_m / chosen_for_m : 1;
}

/// The part of the bed that the wheel passes, at true size.
SnapshotOptions frame_travel(const std::vector<ShownFrame>& frames, const Mesh& wheel) {
    const double size = relative_size(wheel);
    SnapshotOptions options;
    options.x_min_m = 1e9, options.x_max_m = -1e9, options.y_max_m = 0;
    for (const auto& [frame, soil] : frames) {
        options.x_min_m = std::min(options.x_min_m, frame.hub_position_m.x - 0.25 * size);
        options.x_max_m = std::max(options.x_max_m, frame.hub_position_m.x + 0.25 * size);
        options.y_max_m = std::max(options.y_max_m, frame.hub_position_m.y + 0.2 * size);
    }
    return options;
}

ShownFrame read_shown(const FrameReader& results, std::size_t k, const std::string& run_directory) {
    ShownFrame shown{results.read(k), {}};
    shown.soil = read_soil_outline(run_directory, shown.frame.time_s);
    return shown;
}

/// Up to `most` frames, evenly spaced, the first and the last among them.
std::vector<ShownFrame> read_some(const FrameReader& results, std::size_t most, const std::string& run_directory) {
    const std::size_t count = results.frames().size();
    if (count == 0) fail_io(fmt::format("{}/results.h5 has no frames yet. Resume the run?", run_directory));
    const std::size_t shown = std::min(most, count);
    std::vector<ShownFrame> frames;
    for (std::size_t k = 0; k < shown; ++k)
        frames.push_back(read_shown(results, shown == 1 ? count - 1 : k * (count - 1) / (shown - 1), run_directory));
    return frames;
}

}  // namespace

void draw_pictures(const std::string& run_directory, const std::string& out_directory, long frame) {
    const std::string path = run_directory + "/results.h5";
    const FrameReader results(path);
    const auto count = static_cast<long>(results.frames().size());
    const long number = frame < 0 ? count - 1 : frame;
    if (number < 0 || number >= count)
        fail_input(fmt::format("{} has no frame {} (it holds {}). Choose --frame below that?", path, frame, count));
    const FrameFileHeader header = results.header();
    const ShownFrame shown = read_shown(results, static_cast<std::size_t>(number), run_directory);
    const double length_m = parse_case(header.case_text, path).bed.length_m;
    const double size = relative_size(header.mesh);
    const Vec2 hub = shown.frame.hub_position_m;
    SnapshotOptions near;
    near.width_px = 800;  // sharp on a page, and a chapter's report stays below 5 MiB
    near.x_min_m = hub.x - 0.35 * size, near.x_max_m = hub.x + 0.25 * size;
    near.y_min_m = 0, near.y_max_m = hub.y + 0.2 * size;
    write_snapshot_png(out_directory + "/snapshot.png", shown, header.mesh, near);
    SnapshotOptions far;
    far.width_px = near.width_px;
    far.x_max_m = length_m, far.y_max_m = near.y_max_m;
    far.colour = DiscColour::pressure;
    write_snapshot_png(out_directory + "/snapshot_bed.png", shown, header.mesh, far);
}

void draw_contact_sheet(const std::string& run_directory, const std::string& out_directory, DiscColour colour) {
    const FrameReader results(run_directory + "/results.h5");
    const Mesh wheel = results.header().mesh;
    const std::vector<ShownFrame> frames = read_some(results, 9, run_directory);
    SnapshotOptions options = frame_travel(frames, wheel);
    options.width_px = 560;
    options.colour = colour;
    write_contact_sheet_png(out_directory + "/contact_sheet.png", frames, wheel, options, 3);
}

void draw_animation(const std::string& run_directory, const std::string& out_directory, DiscColour colour) {
    const FrameReader results(run_directory + "/results.h5");
    const Mesh wheel = results.header().mesh;
    const std::vector<ShownFrame> frames = read_some(results, 30, run_directory);
    SnapshotOptions options = frame_travel(frames, wheel);
    options.width_px = 800;  // below a megabyte
    options.colour = colour;
    write_animation_gif(out_directory + "/travel.gif", frames, wheel, options, 300);
}

}  // namespace ifedem
