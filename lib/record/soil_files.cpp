#include "record/soil_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <span>

#include "core/error.hpp"
#include "coupling/attached_discs.hpp"
#include "record/files.hpp"
#include "step/fields.hpp"
#include "step/scene.hpp"

namespace ifedem {

std::string conversions_csv(const SoilState& soil) {
    std::string text = "step,block,kind,refused,attached,attached_mass_kg";
    for (const char* when : {"before", "after"})
        text += fmt::format(
            ",discs_{0},disc_mass_{0}_kg,element_mass_{0}_kg,momentum_x_{0}_Ns,momentum_y_{0}_Ns,kinetic_{0}_J,"
            "elastic_{0}_J,height_{0}_J,surface_{0}_m",
            when);
    text += "\n";
    for (const ConversionRecord& r : soil.conversions) {
        text += fmt::format("{:.0f},{:.0f},{},{:.0f},{:.0f},{:.6g}", r.step, r.block,
                            r.kind == 0 ? "to-discs" : "to-element", r.refused, r.attached, r.attached_mass_kg);
        for (const SoilStock& s : {r.before, r.after})
            text += fmt::format(",{:.0f},{:.10g},{:.10g},{:.6g},{:.6g},{:.6g},{:.6g},{:.10g},{:.6g}", s.discs,
                                s.disc_mass_kg, s.element_mass_kg, s.momentum_x_Ns, s.momentum_y_Ns, s.kinetic_J,
                                s.elastic_J, s.height_J, s.surface_m);
        text += "\n";
    }
    return text;
}

std::string stress_csv(const Scene& scene, const State& state, const Workspace& work) {
    std::string text = "what,x_m,y_m,radius_m,stress_x_Pa,stress_y_Pa,stress_xy_Pa\n";
    const std::vector<DiscStress> stress = measure_stress(scene, state, work);
    for (std::size_t p = 0; p < stress.size(); ++p) {
        const Disc& d = state.discs.disc[p];
        fmt::format_to(std::back_inserter(text), "disc,{:.5f},{:.5f},{:.4f},{:.5g},{:.5g},{:.5g}\n", d.x_m, d.y_m,
                       d.radius_m, stress[p].x_Pa, stress[p].y_Pa, stress[p].xy_Pa);
    }
    for (const Element& e : work.soil.elements.element) {
        Vec2 centre;
        for (const std::uint32_t n : e.node) centre += 0.25 * state.soil.position_m[n];
        const auto s = centroid_stress_Pa(e, scene.soil.material, PlaneState::strain, state.soil.position_m);
        fmt::format_to(std::back_inserter(text), "element,{:.5f},{:.5f},,{:.5g},{:.5g},{:.5g}\n", centre.x, centre.y,
                       s[0], s[1], s[2]);
    }
    return text;
}

namespace {

const std::string header = "time_s,what,block,x0_m,y0_m,x1_m,y1_m,x2_m,y2_m,x3_m,y3_m\n";

std::string path_of(const std::string& directory) { return directory + "/soil.csv"; }

std::string soil_lines(const SoilState& soil, double time_s, std::uint32_t columns) {
    std::string text;
    for (std::uint32_t b = 0; b < soil.kind.size(); ++b) {
        if (soil.kind[b] != BlockKind::element) continue;
        text += fmt::format("{:.6f},element,{}", time_s, b);
        const std::uint32_t n = b / columns * (columns + 1) + b % columns;
        for (const std::uint32_t node : {n, n + 1, n + columns + 2, n + columns + 1})
            text += fmt::format(",{:.6f},{:.6f}", soil.position_m[node].x, soil.position_m[node].y);
        text += "\n";
    }
    for (std::uint32_t n = 0; n < soil.attached.size(); ++n) {
        const Vec2 at = attached_position_m(soil, n);
        fmt::format_to(std::back_inserter(text), "{:.6f},attached,{},{:.6f},{:.6f},{:.6f},,,,,\n", time_s,
                       soil.attached_block[n], at.x, at.y, soil.attached[n].radius_m);
    }
    return text;
}

/// A line's time is rounded to its last digit, so half of that is allowed.
bool is_at_most(const std::string& line, double time_s) {
    return std::strtod(line.c_str(), nullptr) <= time_s + 5.1e-7;
}

/// Length in bytes of the header and of the whole lines up to a time.
std::size_t kept_size(const std::string& path, double time_s) {
    const std::vector<std::byte> bytes = read_whole_file(path);
    std::string text(bytes.size(), '\0');
    std::transform(bytes.begin(), bytes.end(), text.begin(), [](std::byte b) { return static_cast<char>(b); });
    if (!text.starts_with(header))
        fail_io("'" + path +
                "' is not of this program (its first line differs). Start the run again in a new directory?");
    std::size_t at = header.size();
    for (std::size_t end = text.find('\n', at); end != std::string::npos; end = text.find('\n', at)) {
        if (!is_at_most(text.substr(at, end - at), time_s)) break;
        at = end + 1;
    }
    return at;
}

}  // namespace

void start_soil_frames(const std::string& directory) { write_file_atomically(path_of(directory), header); }

void add_soil_frame(const std::string& directory, const SoilState& soil, double time_s, std::uint32_t columns) {
    const std::string lines = soil_lines(soil, time_s, columns);
    OpenFile file(path_of(directory), O_WRONLY);
    file.write_at(file.size(), std::as_bytes(std::span(lines)));
    file.sync();
}

void drop_soil_frames_after(const std::string& directory, double time_s) {
    const std::size_t kept = kept_size(path_of(directory), time_s);
    OpenFile file(path_of(directory), O_WRONLY);
    file.truncate(kept);
    file.sync();
}

SoilOutline read_soil_outline(const std::string& directory, double time_s) {
    SoilOutline outline;
    std::ifstream file(path_of(directory));
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line) && !file.eof()) {  // a line without an end was cut short
        char* end = nullptr;
        if (std::fabs(std::strtod(line.c_str(), &end) - time_s) > 1e-6) continue;
        const bool element = line.find(",element,") != std::string::npos;
        std::size_t comma = 0;  // behind time, word and block
        for (int n = 0; n < 3; ++n) comma = line.find(',', comma) + 1;
        std::array<double, 8> v{};
        const char* at = line.c_str() + comma;
        for (std::size_t n = 0; n < (element ? 8U : 3U); ++n) v[n] = std::strtod(at, &end), at = end + 1;
        if (element)
            outline.element_m.push_back({Vec2{v[0], v[1]}, Vec2{v[2], v[3]}, Vec2{v[4], v[5]}, Vec2{v[6], v[7]}});
        else
            outline.attached.push_back({{v[0], v[1]}, v[2]});
    }
    return outline;
}

}  // namespace ifedem
