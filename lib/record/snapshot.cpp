#include "record/snapshot.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <vector>

#include "core/error.hpp"
#include "core/gnuplot.hpp"
#include "record/files.hpp"

namespace ifedem {
namespace {

constexpr double left_px = 110, right_px = 170, top_px = 55, bottom_px = 90;  // around the axes, for the labels

/// Dark blue to yellow, equal steps look equal and it survives grey printing (the viridis map, sampled; CC0).
constexpr const char* palette =
    "set palette defined (0 '#440154', 1 '#482878', 2 '#3e4989', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', 6 '#35b779', "
    "7 '#6ece58', 8 '#b5de2b', 9 '#fde725')\n";

/// Fill of each Part: rim, intermediate layer, surface layer, lug.
constexpr std::array<const char*, 4> part_fill = {"#8d99ae", "#edf2f4", "#b7bcc6", "#5c677d"};

bool is_visible(const Frame& frame, std::size_t k, const SnapshotOptions& options) {
    const Vec2 at = frame.disc_position_m[k];
    const auto radius = static_cast<double>(frame.disc_radius_m[k]);
    return at.x + radius > options.x_min_m && at.x - radius < options.x_max_m && at.y + radius > options.y_min_m &&
           at.y - radius < options.y_max_m;
}

/// The value that 2 % of the visible discs exceed, so that one fast disc does not darken all others.
double choose_colour_max(const Frame& frame, std::span<const float> values, const SnapshotOptions& options) {
    std::vector<float> visible;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (is_visible(frame, k, options)) visible.push_back(values[k]);
    }
    if (visible.empty()) return 1;
    const auto place = visible.begin() + static_cast<std::ptrdiff_t>((visible.size() - 1) * 98 / 100);
    std::nth_element(visible.begin(), place, visible.end());
    return *place > 0 ? static_cast<double>(*place) : 1;
}

std::string disc_data(const Frame& frame, std::span<const float> values, double scale, const SnapshotOptions& options) {
    std::string data = "$discs << EOD\n";
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (!is_visible(frame, k, options)) continue;
        const Vec2 at = frame.disc_position_m[k];
        fmt::format_to(std::back_inserter(data), "{:.6f} {:.6f} {:.6f} {:.5g}\n", at.x, at.y, frame.disc_radius_m[k],
                       static_cast<double>(values[k]) * scale);
    }
    return data + "EOD\n";
}

/// Closed outlines of the elements of one part, blank lines between.
std::string part_data(const Frame& frame, const Mesh& wheel, std::size_t part) {
    std::string data = fmt::format("$part{} << EOD\n", part);
    for (std::size_t q = 0; q < wheel.quad.size(); ++q) {
        if (static_cast<std::size_t>(wheel.part[q]) != part) continue;
        for (const std::size_t corner : {0U, 1U, 2U, 3U, 0U}) {
            const Vec2 at = frame.wheel_position_m.at(wheel.quad[q][corner]);
            fmt::format_to(std::back_inserter(data), "{:.6f} {:.6f}\n", at.x, at.y);
        }
        data += "\n";
    }
    return data + "EOD\n";
}

/// Soil elements as outlines, attached discs in one grey.
std::string soil_data(const SoilOutline& soil) {
    std::string data = "$soil << EOD\n";
    for (const auto& element : soil.element_m) {
        for (const std::size_t corner : {0U, 1U, 2U, 3U, 0U})
            fmt::format_to(std::back_inserter(data), "{:.6f} {:.6f}\n", element[corner].x, element[corner].y);
        data += "\n";
    }
    data += "EOD\n$attached << EOD\n";
    for (const auto& disc : soil.attached)
        fmt::format_to(std::back_inserter(data), "{:.6f} {:.6f} {:.6f}\n", disc.centre_m.x, disc.centre_m.y,
                       disc.radius_m);
    return data + "EOD\n";
}

std::vector<std::size_t> parts_present(const Frame& frame, const Mesh& wheel) {
    std::vector<std::size_t> present;
    for (std::size_t part = 0; part < part_fill.size(); ++part) {
        const bool found = std::ranges::any_of(wheel.part, [&](Part p) { return static_cast<std::size_t>(p) == part; });
        if (found && !frame.wheel_position_m.empty()) present.push_back(part);
    }
    return present;
}

/// A rectangle on the canvas, from its lower left corner.
struct Panel {
    double x_px = 0, y_px = 0, width_px = 0, height_px = 0;
};

/// The size that gives both axes the same scale, with fixed margins.
Panel size_panel(const SnapshotOptions& options) {
    const double plot_px = options.width_px - left_px - right_px;
    const double ratio = (options.y_max_m - options.y_min_m) / (options.x_max_m - options.x_min_m);
    return {0, 0, static_cast<double>(options.width_px), plot_px * ratio + top_px + bottom_px};
}

/// Terminal and output; `terminal` is gnuplot's with its options but the size.
std::string canvas(const std::string& terminal, const std::string& output, double width_px, double height_px) {
    return fmt::format("set terminal {} size {:.0f},{:.0f} font 'DejaVu Sans,14' background '#ffffff'\nset output {}\n",
                       terminal, width_px, height_px, quote_for_gnuplot(output));
}

std::string margins(const Panel& p, double width_px, double height_px) {
    const double left = (p.x_px + left_px) / width_px, right = (p.x_px + p.width_px - right_px) / width_px;
    const double bottom = (p.y_px + bottom_px) / height_px, top = (p.y_px + p.height_px - top_px) / height_px;
    return fmt::format(
        "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n"
        "set tmargin at screen {:.6f}\n"
        "set colorbox user origin screen {:.6f},{:.6f} size screen {:.6f},{:.6f}\n",
        left, right, bottom, top, right + 20 / width_px, bottom, 24 / width_px, top - bottom);
}

std::string axes(const std::string& title, const char* colour_label, double colour_max, const SnapshotOptions& o) {
    return fmt::format(
        "set encoding utf8\nset title {} noenhanced offset 0,-0.4\nset xlabel 'x [m]'\nset ylabel 'y [m]'\nset size "
        "ratio -1\n"
        "set xrange [{}:{}]\nset yrange [{}:{}]\nset tics out nomirror\nset border 3 lw 1\nunset key\n"
        "set cbrange [0:{:.6g}]\nset cblabel {} noenhanced\nset style fill solid 1.0 noborder\n",
        quote_for_gnuplot(title), o.x_min_m, o.x_max_m, o.y_min_m, o.y_max_m, colour_max,
        quote_for_gnuplot(colour_label));
}

const std::vector<float>& coloured_values(const Frame& frame, DiscColour colour) {
    return colour == DiscColour::speed ? frame.disc_speed_m_s : frame.disc_pressure_Pa;
}

/// Data and the plot command of one frame; where it goes on the canvas is set before.
std::string draw_frame(const ShownFrame& shown, const Mesh& wheel, const SnapshotOptions& o) {
    const Frame& frame = shown.frame;
    const bool speed = o.colour == DiscColour::speed;
    const std::vector<float>& values = coloured_values(frame, o.colour);
    const double scale = speed ? 1 : 1e-3;
    const double colour_max = scale * (o.colour_max > 0 ? o.colour_max : choose_colour_max(frame, values, o));
    const std::string title =
        o.title.empty() ? fmt::format("{}, t = {:.3f} s", stage_name(frame.progress.stage), frame.time_s) : o.title;

    std::string script = axes(title, speed ? "speed [m/s]" : "pressure [kPa]", colour_max, o) + palette;
    script += disc_data(frame, values, scale, o);
    std::string plot = "plot ";
    if (!shown.soil.element_m.empty()) {
        script += soil_data(shown.soil);
        plot += "$soil with filledcurves closed fc rgb '#e9e2d0', $soil with lines lw 0.8 lc rgb '#8a7f66', ";
        if (!shown.soil.attached.empty()) plot += "$attached using 1:2:3 with circles lc rgb '#8a7f66', ";
    }
    plot += "$discs using 1:2:3:4 with circles lc palette";
    for (const std::size_t part : parts_present(frame, wheel)) {
        script += part_data(frame, wheel, part);
        plot +=
            fmt::format(", $part{0} with filledcurves closed fc rgb '{1}', $part{0} with lines lw 0.6 lc rgb '#2b2d42'",
                        part, part_fill[part]);
    }
    if (!frame.wheel_position_m.empty()) {
        script += fmt::format("$hub << EOD\n{:.6f} {:.6f}\nEOD\n", frame.hub_position_m.x, frame.hub_position_m.y);
        plot += ", $hub with points pt 1 ps 2 lw 2 lc rgb '#2b2d42'";
    }
    return script + plot + "\n";
}

/// Frames one after the other on one canvas, all with the same colours: those of the fastest frame.
SnapshotOptions share_colours(std::span<const ShownFrame> frames, SnapshotOptions o) {
    if (o.colour_max > 0) return o;
    for (const auto& [frame, soil] : frames)
        o.colour_max = std::max(o.colour_max, choose_colour_max(frame, coloured_values(frame, o.colour), o));
    return o;
}

std::string first_line(const std::string& path) {
    std::string line;
    for (const std::byte b : read_whole_file(path)) {
        if (b == std::byte{'\n'} && !line.empty()) break;
        line += static_cast<char>(b);
    }
    return line;
}

void check_options(const SnapshotOptions& options) {
    if (!(options.x_max_m > options.x_min_m && options.y_max_m > options.y_min_m) || options.width_px < 400) {
        fail_input("a snapshot needs x_min < x_max, y_min < y_max and at least 400 pixels. Correct its options?");
    }
}

/// Runs the script that `make` gives for a temporary output, and renames what it drew.
template <class Make>
void draw(const std::string& path, const Make& make) {
    const std::string script = path + ".gp", picture = path + ".tmp", log = path + ".log";
    write_file_atomically(script, make(picture));
    const int status = execute_gnuplot({script}, log);
    std::string reason;
    if (status != 0)
        reason =
            "exit status " + std::to_string(status) + ": " + (::access(log.c_str(), R_OK) == 0 ? first_line(log) : "");
    ::unlink(log.c_str());
    ::unlink(script.c_str());
    if (status != 0 || ::access(picture.c_str(), R_OK) != 0) {
        ::unlink(picture.c_str());
        fail_io("gnuplot could not draw '" + path + "' (" + reason + "). Install gnuplot and check free disk space?");
    }
    replace_file(picture, path);
}

}  // namespace

void write_snapshot_png(const std::string& path, const ShownFrame& shown, const Mesh& wheel,
                        const SnapshotOptions& options) {
    check_options(options);
    const Panel all = size_panel(options);
    draw(path, [&](const std::string& output) {
        return canvas("pngcairo", output, all.width_px, all.height_px) + margins(all, all.width_px, all.height_px) +
               draw_frame(shown, wheel, options) + "unset output\n";
    });
}

void write_contact_sheet_png(const std::string& path, std::span<const ShownFrame> frames, const Mesh& wheel,
                             const SnapshotOptions& options, int columns) {
    check_options(options);
    const SnapshotOptions shared = share_colours(frames, options);
    const Panel one = size_panel(options);
    const auto across = std::min(static_cast<std::size_t>(columns), frames.size());
    const std::size_t down = (frames.size() + across - 1) / across;
    const double width_px = one.width_px * static_cast<double>(across);
    const double height_px = one.height_px * static_cast<double>(down);
    draw(path, [&](const std::string& output) {
        std::string script = canvas("pngcairo", output, width_px, height_px) + "set multiplot\n";
        for (std::size_t k = 0; k < frames.size(); ++k) {
            const std::size_t row = k / across;
            const Panel panel{one.width_px * static_cast<double>(k % across),
                              height_px - one.height_px * static_cast<double>(row + 1), one.width_px, one.height_px};
            script += margins(panel, width_px, height_px) + draw_frame(frames[k], wheel, shared);
        }
        return script + "unset multiplot\nunset output\n";
    });
}

void write_animation_gif(const std::string& path, std::span<const ShownFrame> frames, const Mesh& wheel,
                         const SnapshotOptions& options, int frame_ms) {
    check_options(options);
    const SnapshotOptions shared = share_colours(frames, options);
    const Panel all = size_panel(options);
    draw(path, [&](const std::string& output) {
        std::string script = canvas(fmt::format("gif animate delay {} loop 0 optimize", frame_ms / 10), output,
                                    all.width_px, all.height_px) +
                             margins(all, all.width_px, all.height_px);
        for (const ShownFrame& frame : frames) script += draw_frame(frame, wheel, shared);
        return script + "unset output\n";
    });
}

}  // namespace ifedem
