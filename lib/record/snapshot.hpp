#pragma once
#include <span>
#include <string>

#include "fem/mesh.hpp"
#include "record/frame.hpp"
#include "record/soil_files.hpp"

namespace ifedem {

/// What the discs' colour tells.
enum class DiscColour { speed, pressure };

struct SnapshotOptions {
    double x_min_m = 0, x_max_m = 1.5;
    double y_min_m = 0, y_max_m = 0.6;
    DiscColour colour = DiscColour::speed;
    double colour_max = 0;  ///< m/s or Pa; 0: such that 2 % of the discs in the picture lie above
    int width_px = 1600;
    std::string title;  ///< empty: stage and time
};

/// A frame with the soil's elements and attached discs of its time, if it has any; they are drawn under the discs.
struct ShownFrame {
    Frame frame;
    SoilOutline soil;
};

/// Draws one frame to a PNG by gnuplot: discs as circles of true size, coloured; the wheel's elements by part with thin
/// edges; metres on both axes at equal scale. Equal frames make equal bytes with the same gnuplot and fonts.
/// Throws Error(io) if gnuplot is missing or fails.
void write_snapshot_png(const std::string& path, const ShownFrame& shown, const Mesh& wheel,
                        const SnapshotOptions& options);

/// Frames as panels of one PNG, `columns` side by side, each `options.width_px` wide, all with the same colours.
void write_contact_sheet_png(const std::string& path, std::span<const ShownFrame> frames, const Mesh& wheel,
                             const SnapshotOptions& options, int columns);

/// Frames one after the other as a GIF that repeats for ever, each shown for `frame_ms`.
void write_animation_gif(const std::string& path, std::span<const ShownFrame> frames, const Mesh& wheel,
                         const SnapshotOptions& options, int frame_ms);

}  // namespace ifedem
