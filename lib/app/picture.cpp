#include "app/picture.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "model/case.hpp"
#include "record/frame_file.hpp"
#include "record/snapshot.hpp"

namespace ifedem {

void draw_pictures(const std::string& run_directory, const std::string& out_directory, long frame) {
    const std::string path = run_directory + "/results.h5";
    const FrameReader results(path);
    const auto count = static_cast<long>(results.frames().size());
    const long number = frame < 0 ? count - 1 : frame;
    if (number < 0 || number >= count)
        fail_input(fmt::format("{} has no frame {} (it holds {}). Choose --frame below that?", path, frame, count));
    const FrameFileHeader header = results.header();
    const Frame shown = results.read(static_cast<std::uint64_t>(number));
    const double length_m = parse_case(header.case_text, path).bed.length_m;
    const Vec2 hub = shown.hub_position_m;
    SnapshotOptions near;
    near.width_px = 1100;  // sharp on a page, and a chapter's report stays small
    near.x_min_m = hub.x - 0.35, near.x_max_m = hub.x + 0.25;
    near.y_min_m = 0, near.y_max_m = hub.y + 0.2;
    write_snapshot_png(out_directory + "/snapshot.png", shown, header.mesh, near);
    SnapshotOptions far;
    far.width_px = near.width_px;
    far.x_max_m = length_m, far.y_max_m = near.y_max_m;
    far.colour = DiscColour::pressure;
    write_snapshot_png(out_directory + "/snapshot_bed.png", shown, header.mesh, far);
}

}  // namespace ifedem
