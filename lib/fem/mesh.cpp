#include "fem/mesh.hpp"

#include "core/bitmath.hpp"
#include "core/error.hpp"
#include "fem/gmsh.hpp"
#include "fem/hub_core.hpp"
#include "model/case_checks.hpp"

namespace ifedem {
namespace {

/// Angle at which each column of elements begins, counter-clockwise, and whether it carries a lug.
struct Columns {
    std::vector<double> begin_rad;
    std::vector<std::uint8_t> lug;

    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(begin_rad.size()); }
    /// The column after k, around the wheel.
    [[nodiscard]] std::uint32_t after(std::uint32_t k) const { return k + 1 == count() ? 0 : k + 1; }
};

/// Radii of the circles of nodes from the rim outwards.
struct Rings {
    std::vector<double> radius_m;
    std::size_t intermediate = 0;  ///< rings of elements below the surface layer
};

void add_columns(Columns& columns, double begin_rad, double width_rad, std::int64_t count, std::uint8_t lug) {
    for (std::int64_t k = 0; k < count; ++k) {
        columns.begin_rad.push_back(begin_rad + width_rad * (static_cast<double>(k) / static_cast<double>(count)));
        columns.lug.push_back(lug);
    }
}

Columns lay_out_columns(const WheelCase& w) {
    Columns columns;
    const double phase_rad = w.lug_phase_deg * (pi / 180.0);
    if (w.lug_pairs == 0) {  // all alike
        add_columns(columns, phase_rad, 2 * pi, smooth_tread_columns(w), 0);
        return columns;
    }
    const double lug_rad = w.lug_thickness_m / w.tread_radius_m;
    const double gap_rad = w.lug_gap_m / w.tread_radius_m;
    const double pitch_rad = 2 * pi / static_cast<double>(w.lug_pairs);
    const double rest_rad = pitch_rad - 2 * lug_rad - gap_rad;
    for (std::int64_t pair = 0; pair < w.lug_pairs; ++pair) {
        const double begin = phase_rad + pitch_rad * static_cast<double>(pair);
        add_columns(columns, begin, lug_rad, 1, 1);
        add_columns(columns, begin + lug_rad, gap_rad, w.gap_columns, 0);
        add_columns(columns, begin + lug_rad + gap_rad, lug_rad, 1, 1);
        add_columns(columns, begin + 2 * lug_rad + gap_rad, rest_rad, w.pitch_columns, 0);
    }
    return columns;
}

Rings lay_out_rings(const WheelCase& w) {
    Rings rings;
    const double joint_m = w.tread_radius_m - w.surface_thickness_m;
    for (std::int64_t k = 0; k < w.intermediate_rings; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(w.intermediate_rings);
        rings.radius_m.push_back(w.rim_radius_m + (joint_m - w.rim_radius_m) * share);
    }
    for (std::int64_t k = 0; k < w.surface_rings; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(w.surface_rings);
        rings.radius_m.push_back(joint_m + w.surface_thickness_m * share);
    }
    rings.radius_m.push_back(w.tread_radius_m);
    rings.intermediate = static_cast<std::size_t>(w.intermediate_rings);
    return rings;
}

void add_layers(Mesh& mesh, const Columns& columns, const Rings& rings) {
    const std::uint32_t n = columns.count();
    for (const double radius : rings.radius_m) {
        for (const double angle : columns.begin_rad) {
            const CosSin a = cos_sin(angle);
            mesh.node_m.push_back({radius * a.cos, radius * a.sin});
        }
    }
    for (std::uint32_t ring = 0; ring + 1 < rings.radius_m.size(); ++ring) {
        const std::uint32_t inner = ring * n;
        const std::uint32_t outer = inner + n;
        for (std::uint32_t k = 0; k < n; ++k) {
            const std::uint32_t next = columns.after(k);
            mesh.quad.push_back({inner + k, outer + k, outer + next, inner + next});
            mesh.part.push_back(ring < rings.intermediate ? Part::intermediate : Part::surface);
        }
    }
}

/// A block with parallel sides on the tread nodes `first` and `second`; its corners lie on the outermost circle, so
/// that the largest diameter is that of Table 3-1. Returns its first node; the second follows.
std::uint32_t add_lug(Mesh& mesh, std::uint32_t first, std::uint32_t second, double top_radius_m) {
    const Vec2 a = mesh.node_m[first];
    const Vec2 b = mesh.node_m[second];
    const Vec2 middle = 0.5 * (a + b);
    const Vec2 outwards = (1.0 / norm(middle)) * middle;
    const double half_width = 0.5 * norm(b - a);
    const double height = std::sqrt(top_radius_m * top_radius_m - half_width * half_width) - norm(middle);
    const auto top = static_cast<std::uint32_t>(mesh.node_m.size());
    mesh.node_m.push_back(a + height * outwards);
    mesh.node_m.push_back(b + height * outwards);
    mesh.quad.push_back({first, top, top + 1, second});
    mesh.part.push_back(Part::lug);
    return top;
}

/// Adds the lugs and returns the outer loop.
std::vector<std::uint32_t> add_lugs(Mesh& mesh, const Columns& columns, std::uint32_t tread, double top_radius_m) {
    std::vector<std::uint32_t> loop;
    for (std::uint32_t k = 0; k < columns.count(); ++k) {
        loop.push_back(tread + k);
        if (columns.lug[k] == 0) continue;
        const std::uint32_t top = add_lug(mesh, tread + k, tread + columns.after(k), top_radius_m);
        loop.push_back(top);
        loop.push_back(top + 1);
    }
    return loop;
}

/// A rigid rectangle of elements, half as high as long.
WheelMesh make_plate_mesh(double length_m) {
    constexpr std::uint32_t columns = 8, rows = 4;
    WheelMesh plate;
    for (std::uint32_t j = 0; j <= rows; ++j)
        for (std::uint32_t i = 0; i <= columns; ++i)
            plate.mesh.node_m.push_back({length_m * (static_cast<double>(i) / columns - 0.5),
                                         0.5 * length_m * (static_cast<double>(j) / rows - 0.5)});
    const auto at = [](std::uint32_t i, std::uint32_t j) { return j * (columns + 1) + i; };
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            plate.mesh.quad.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            plate.mesh.part.push_back(Part::intermediate);
        }
    for (std::uint32_t i = 0; i < columns; ++i) plate.boundary.push_back(at(i, 0));
    for (std::uint32_t j = 0; j < rows; ++j) plate.boundary.push_back(at(columns, j));
    for (std::uint32_t i = columns; i > 0; --i) plate.boundary.push_back(at(i, rows));
    for (std::uint32_t j = rows; j > 0; --j) plate.boundary.push_back(at(0, j));
    for (std::uint32_t k = 0; k < plate.mesh.node_m.size(); ++k) plate.rigid.push_back(k);
    plate.rim_surface = plate.boundary;
    return plate;
}

}  // namespace

WheelMesh make_wheel_mesh(const WheelCase& wheel) {
    if (wheel.shape == WheelShape::plate) return make_plate_mesh(wheel.plate_length_m);
    if (!wheel.mesh_file.empty()) return read_gmsh_wheel(wheel);
    if (const auto fault = find_wheel_fault(wheel)) fail_input(*fault);
    const Columns columns = lay_out_columns(wheel);
    const Rings rings = lay_out_rings(wheel);
    WheelMesh result;
    add_layers(result.mesh, columns, rings);
    const auto tread = static_cast<std::uint32_t>(rings.radius_m.size() - 1) * columns.count();
    result.boundary = add_lugs(result.mesh, columns, tread, wheel.tread_radius_m + wheel.lug_height_m);
    for (std::uint32_t k = 0; k < columns.count(); ++k) result.rim_surface.push_back(k);

    if (wheel.body == WheelBody::rigid_rim) result.rigid = result.rim_surface;
    if (wheel.body == WheelBody::rigid) {
        for (std::uint32_t k = 0; k < result.mesh.node_m.size(); ++k) result.rigid.push_back(k);
    }
    if (wheel.body == WheelBody::elastic) {
        result.hub = add_hub_core(result.mesh, columns.begin_rad, wheel.rim_radius_m, wheel.rim_rings);
    }
    return result;
}

}  // namespace ifedem
