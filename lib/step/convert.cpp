#include "step/convert.hpp"

#include "coupling/region.hpp"
#include "dem/closed_pairs.hpp"

namespace ifedem {
namespace {

TyreEdges find_tyre_edges(const WheelModel& model, const WheelState& wheel) {
    TyreEdges e{1e300, -1e300};
    for (const std::uint32_t n : model.mesh.boundary) {
        e.rear_x_m = min_of(e.rear_x_m, wheel.position_m[n].x);
        e.front_x_m = max_of(e.front_x_m, wheel.position_m[n].x);
    }
    return e;
}

std::optional<DueConversion> find_due(const Scene& scene, const State& state) {
    if (scene.soil.c.region == RegionRule::position)
        return find_due_conversion(scene.soil, state.soil, find_tyre_edges(scene.wheel, state.wheel));
    std::vector<Vec2> tread;
    for (const std::uint32_t n : scene.wheel.mesh.boundary) tread.push_back(state.wheel.position_m[n]);
    return find_due_adaptive(scene.soil, scene.dem, state, tread);
}

/// What discs and elements hold now. Springs are those between discs: what they have with elements is not known
/// between steps.
SoilStock take_stock(const Scene& scene, const State& state, const Workspace& work, std::uint32_t block) {
    SoilStock s;
    const auto& disc = state.discs.disc;
    s.discs = static_cast<double>(disc.size());
    const Vec2 g = scene.soil.gravity_m_s2;
    for (const Disc& d : disc) {
        const double mass = 1.0 / d.inverse_mass_1_kg;
        const Vec2 v{d.vx_m_s, d.vy_m_s};
        s.disc_mass_kg += mass;
        s.momentum_x_Ns += mass * v.x, s.momentum_y_Ns += mass * v.y;
        s.kinetic_J += 0.5 * mass * (dot(v, v) + 0.5 * d.omega_rad_s * d.omega_rad_s * d.radius_m * d.radius_m);
        s.height_J -= mass * dot(g, {d.x_m, d.y_m});
    }
    for_each_closed_pair(disc, work.dem, [&](const ClosedPair& c) {
        const double spring = state.pairs.tangential_m[c.number];
        const ContactConstants& k = scene.dem.soil;
        s.elastic_J +=
            0.5 * (k.normal_stiffness_N_m * c.overlap_m * c.overlap_m + k.tangential_stiffness_N_m * spring * spring);
    });
    for (const SoilNode& n : work.soil.node) {
        const Vec2 v = state.soil.velocity_m_s[n.number];
        s.element_mass_kg += n.mass_kg;
        s.momentum_x_Ns += n.mass_kg * v.x, s.momentum_y_Ns += n.mass_kg * v.y;
        s.kinetic_J += 0.5 * n.mass_kg * dot(v, v);
        s.height_J -= n.mass_kg * dot(g, state.soil.position_m[n.number]);
    }
    s.elastic_J += strain_energy_J(work.soil.elements, state.soil.position_m);
    s.surface_m = block_surface_m(scene.soil, state, block);
    return s;
}

bool was_refused_before(const SoilState& soil, std::uint32_t block) {
    return !soil.conversions.empty() && soil.conversions.back().refused != 0 &&
           soil.conversions.back().block == static_cast<double>(block);
}

/// True: something has changed, and more may be due.
bool convert_once(const Scene& scene, State& state, Workspace& work) {
    const auto due = find_due(scene, state);
    if (!due) return false;
    const ConversionEdit edit = due->kind == ConversionKind::to_discs
                                    ? plan_to_discs(scene.soil, scene.dem, state.soil, due->block)
                                    : plan_to_element(scene.soil, scene.dem, state, work.soil, due->block);
    ConversionRecord record;
    record.step = static_cast<double>(state.progress.step);
    record.block = due->block;
    record.kind = static_cast<double>(due->kind);
    record.refused = edit.refusal.empty() ? 0 : 1;
    if (record.refused != 0 && was_refused_before(state.soil, due->block)) return false;
    record.before = record.after = take_stock(scene, state, work, due->block);
    if (record.refused == 0) {
        for (const Attachment& a : edit.attach)
            record.attached_mass_kg += 1.0 / state.discs.disc[a.position].inverse_mass_1_kg;
        record.attached = static_cast<double>(edit.attach.size());
        apply_conversion(edit, scene.soil, scene.dem, state, work.dem, work.soil);
        record.after = take_stock(scene, state, work, due->block);
    }
    state.soil.conversions.push_back(record);
    return record.refused == 0;
}

}  // namespace

void convert_at_boundary(const Scene& scene, State& state, Workspace& work) {
    const std::int64_t interval = scene.soil.c.conversion_interval_steps;
    if (!scene.has_soil_elements() || interval == 0 || scene.stage != Stage::travel) return;
    if (state.progress.step % static_cast<std::uint64_t>(interval) != 0) return;
    while (convert_once(scene, state, work)) {
    }
}

}  // namespace ifedem
