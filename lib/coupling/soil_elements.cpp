#include "coupling/soil_elements.hpp"

#include <algorithm>
#include <iterator>

namespace ifedem {
namespace {

/// The elements as a mesh of separate quads in their stress-free shapes: neighbours that were made at different times
/// share nodes but no reference configuration.
Mesh make_separate_quads(const SoilState& soil, const std::vector<std::uint32_t>& block) {
    Mesh mesh;
    for (const std::uint32_t b : block) {
        const auto first = static_cast<std::uint32_t>(mesh.node_m.size());
        mesh.node_m.insert(mesh.node_m.end(), soil.shape[b].corner_m.begin(), soil.shape[b].corner_m.end());
        mesh.quad.push_back({first, first + 1, first + 2, first + 3});
        mesh.part.push_back(Part::rim);
    }
    return mesh;
}

/// Blocks of a column that are elements, counted from the floor.
std::uint32_t height_of(const SoilModel& model, const SoilState& soil, std::uint32_t column) {
    std::uint32_t j = 0;
    while (j < model.rows && soil.kind[model.block(column, j)] == BlockKind::element) ++j;
    return j;
}

/// From the right wall to the left one, the elements on the left of each segment.
Surface find_skyline(const SoilModel& model, const SoilState& soil) {
    std::vector<std::uint32_t> path;
    for (std::uint32_t i = model.columns; i-- > 0;) {
        const std::uint32_t here = height_of(model, soil, i);
        if (path.empty()) path.push_back(model.node(i + 1, here));
        const std::uint32_t before = path.back() / (model.columns + 1);
        for (std::uint32_t j = before; j < here; ++j) path.push_back(model.node(i + 1, j + 1));
        for (std::uint32_t j = before; j > here; --j) path.push_back(model.node(i + 1, j - 1));
        path.push_back(model.node(i, here));
    }
    Surface edge;
    for (std::uint32_t k = 0; k + 1 < path.size(); ++k)
        edge.push_back({path[k], path[k + 1], k == 0 ? SurfaceEdge::none : k - 1,
                        k + 2 == path.size() ? SurfaceEdge::none : k + 1});
    return edge;
}

void gather_nodes(const SoilModel& model, SoilWorkspace& work, const std::vector<double>& mass_kg,
                  const std::vector<double>& damping_kg_s) {
    work.node.clear();
    for (std::uint32_t n = 0; n < mass_kg.size(); ++n) {
        const std::uint32_t i = n % (model.columns + 1), j = n / (model.columns + 1);
        const bool floor = j == 0;
        if (mass_kg[n] > 0)
            work.node.push_back({n, mass_kg[n], damping_kg_s[n], floor || i == 0 || i == model.columns, floor});
    }
}

}  // namespace

SoilModel make_soil_model(const Case& c, const DemConstants& dem, double friction) {
    SoilModel m;
    m.c = c.elements;
    m.columns = static_cast<std::uint32_t>(c.elements.columns);
    m.rows = static_cast<std::uint32_t>(c.elements.rows);
    m.thickness_m = c.soil.thickness_m;
    m.material = c.elements.material;
    m.contact = dem.soil;
    m.contact.friction = friction;
    m.gravity_m_s2 = dem.gravity_m_s2;
    return m;
}

SoilState place_soil(const SoilModel& model) {
    SoilState soil;
    const double length = model.c.block_length_m, height = model.c.block_height_m;
    for (std::uint32_t j = 0; j <= model.rows; ++j)
        for (std::uint32_t i = 0; i <= model.columns; ++i) soil.position_m.push_back({i * length, j * height});
    soil.velocity_m_s.resize(soil.position_m.size());
    const auto first = static_cast<std::uint32_t>(model.c.first_disc_column);
    const auto last = first + static_cast<std::uint32_t>(model.c.disc_columns);
    for (std::uint32_t b = 0; b < model.columns * model.rows; ++b) {
        const std::uint32_t i = b % model.columns, j = b / model.columns;
        const bool discs = j + 1 == model.rows && i >= first && i < last;
        soil.kind.push_back(discs ? BlockKind::discs : BlockKind::element);
        ElementShape shape;
        const auto nodes = model.nodes_of(b);
        for (std::size_t a = 0; a < 4; ++a) shape.corner_m[a] = soil.position_m[nodes[a]];
        soil.shape.push_back(shape);
        if (model.c.stress_handover == StressHandover::mean)
            soil.mass_kg.push_back(discs ? 0 : model.material.density_kg_m3 * model.thickness_m * (length * height));
    }
    return soil;
}

void attach_soil_workspace(const SoilModel& model, const SoilState& soil, SoilWorkspace& work) {
    work.block.clear();
    for (std::uint32_t b = 0; b < soil.kind.size(); ++b)
        if (soil.kind[b] == BlockKind::element) work.block.push_back(b);
    const Material m = model.material;
    work.elements =
        make_elements(make_separate_quads(soil, work.block), {m, m, m, m}, model.thickness_m, PlaneState::strain);
    std::vector<double> mass(soil.position_m.size(), 0.0), damping(soil.position_m.size(), 0.0);
    for (std::size_t k = 0; k < work.block.size(); ++k) {
        work.elements.element[k].node = model.nodes_of(work.block[k]);
        if (!soil.mass_kg.empty()) work.elements.element_mass_kg[k] = soil.mass_kg[work.block[k]];
        for (const std::uint32_t n : work.elements.element[k].node) {
            mass[n] += 0.25 * work.elements.element_mass_kg[k];
            damping[n] += m.damping_1_s * (0.25 * work.elements.element_mass_kg[k]);
        }
    }
    gather_nodes(model, work, mass, damping);
    work.elements.mass_kg = std::move(mass);
    work.elements.damping_kg_s = std::move(damping);
    work.edge = find_skyline(model, soil);
    work.search = work.attached.search = true;
}

namespace {

/// Both are sorted by position; the wheel's forces come first on a disc that has several.
void merge_forces(const std::vector<WheelForce>& more, std::vector<WheelForce>& merged, std::vector<WheelForce>& all) {
    merged.clear();
    std::merge(all.begin(), all.end(), more.begin(), more.end(), std::back_inserter(merged),
               [](const WheelForce& a, const WheelForce& b) { return a.position < b.position; });
    all.swap(merged);
}

}  // namespace

void add_soil_contacts(const DemConstants& k, const SoilModel& model, State& state, DemWorkspace& dem,
                       SoilWorkspace& work, double spring_step_s) {
    work.on_discs.clear();
    // The skyline is long and hardly moves: searched with each outer list, a few times less often than the wheel.
    const DiscsNearby nearby{state.discs, state.pairs.reference, dem.rebuilds, dem.position_of_id, k.largest_radius_m};
    add_surface_contacts(model.contact, k.damping_ratio, {work.edge, state.soil.position_m, state.soil.velocity_m_s},
                         nearby, spring_step_s, state.soil.contacts, work, work.on_discs);
    merge_forces(work.on_discs, work.merged, dem.wheel_force);
    if (state.soil.attached.empty()) {
        work.attached.contact.clear();
        return;
    }
    add_attached_contacts(k.soil, k.damping_ratio, state.soil, nearby, spring_step_s, state.soil.attached_contacts,
                          work.attached, work.contact_force_N);
    merge_forces(work.attached.on_discs, work.merged, dem.wheel_force);
}

void add_soil_forces(const SoilModel& model, const SoilState& soil, SoilWorkspace& work) {
    work.force_N = work.contact_force_N;
    for (const SoilNode& n : work.node) work.force_N[n.number] += n.mass_kg * model.gravity_m_s2;
    add_internal_force(work.elements, soil.position_m, work.force_N);
}

Vec2 momentum_Ns(const SoilWorkspace& work, const SoilState& soil) {
    Vec2 p;
    for (const SoilNode& n : work.node) p += n.mass_kg * soil.velocity_m_s[n.number];
    return p;
}

}  // namespace ifedem
