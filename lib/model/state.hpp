#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec2.hpp"

namespace ifedem {

// All that evolves. Whatever survives a step is here, and for_each_member() at the end names all of it once, so that
// checkpoint, hash and comparison are loops and a resumed run has the same bits as an uninterrupted one.

/// A disc as the pair loop reads it: one 64-byte cache line, so eight of them transpose in registers.
struct alignas(64) Disc {
    double x_m = 0, y_m = 0;
    double vx_m_s = 0, vy_m_s = 0;
    double omega_rad_s = 0;  ///< counter-clockwise
    double radius_m = 0;
    double inverse_mass_1_kg = 0;
    double angle_rad = 0;
};
static_assert(sizeof(Disc) == 64);

/// Acceleration of the last step; only the modified Euler integrators (Eqs 2.9–2.12) need it.
struct DiscAcceleration {
    double x_m_s2 = 0, y_m_s2 = 0, angular_rad_s2 = 0, unused = 0;
};

struct DiscState {
    std::vector<Disc> disc;                      ///< in list order (sorted by cell at each rebuild)
    std::vector<std::uint32_t> id;               ///< the disc's number from the beginning, per list position
    std::vector<DiscAcceleration> acceleration;  ///< empty for the symplectic integrator
};

/// Where a disc stood when a list was made, and how far it may go from there before the list is made anew.
struct Reference {
    double x_m = 0, y_m = 0, skin_m = 0;
};

/// Neighbours closer than radii + skins, each pair once, with the elastic tangential displacement of its contact.
/// i and j are list positions, i < j, sorted by i then j.
struct PairState {
    std::vector<std::uint32_t> i, j;
    std::vector<double> tangential_m;  ///< Δu_s of Eq 2.17; 0 out of contact
    std::vector<Reference> reference;  ///< of the last rebuild, list order
    // The inner list: entries of the outer one that are near enough to touch before the next refresh.
    std::vector<std::uint32_t> inner;        ///< index into i, j
    std::vector<Reference> inner_reference;  ///< of the last refresh
};

/// Contact of a disc with a wall or a wheel segment: who, and the tangential displacement.
struct BoundaryContact {
    std::uint32_t disc = 0;     ///< id, not list position
    std::uint32_t surface = 0;  ///< wall number, or wheel segment
    double tangential_m = 0;
};

/// The wheel's rigid part: the rim, or the whole wheel if it is rigid. Counter-clockwise angle, like the soil.
struct RigidBody {
    Vec2 position_m;
    Vec2 velocity_m_s;
    double angle_rad = 0;
    double omega_rad_s = 0;
};

struct WheelState {
    std::vector<Vec2> position_m;  ///< node positions, all nodes of the mesh
    std::vector<Vec2> velocity_m_s;
    RigidBody rim;  ///< for an elastic rim: hub node and mean rotation of the rim surface
};

/// Memory of one PID loop (Eqs 3.2, 3.3).
struct PidState {
    double error_sum = 0;  ///< Σ e Δt
    double error_old = 0;
    double output = 0;  ///< P in N, or T in N m (clockwise)
    double target = 0;  ///< x in m, or the clockwise angle in rad
};

struct ControlState {
    PidState drawbar;
    PidState torque;
};

/// Work and dissipation since the beginning of the stage, in J; sampled, see RecordCase::energy_interval_s.
struct EnergyLedger {
    double work_torque_J = 0;
    double work_drawbar_J = 0;
    double lost_normal_J = 0;      ///< dashpots and the release of springs cut off at the contact end
    double lost_tangential_J = 0;  ///< sliding and tangential dashpots
    double lost_rolling_J = 0;
    double lost_wheel_J = 0;  ///< damping of the wheel's and the soil's elements
};

/// Sums over the steps since the last line of series.csv, so that a line is the mean over its interval.
struct SeriesSums {
    double steps = 0;
    double drawbar_N = 0, torque_Nm = 0;          ///< P and T (clockwise)
    double fx_positive_N = 0, fx_negative_N = 0;  ///< Eqs 2.13, 2.14
    double fy_N = 0;
    double effective_radius_m = 0, hub_speed_m_s = 0, omega_clockwise_rad_s = 0;
};

/// Sums over the steps of one block of the averaging window, of the forces on the wheel whose contact lies on one
/// virtual segment (section 4.2.2). θ > 0 clockwise from the direction of travel; normal > 0 in compression,
/// tangential > 0 forward at bottom dead centre.
struct SegmentSum {
    double radial_N = 0, circumferential_N = 0;  ///< along and across the radius at the contact's own angle
    double normal_N = 0, tangential_N = 0;       ///< along and across the deformed surface's own normal
    double fx_N = 0, fy_N = 0;
    double moment_Nm = 0;  ///< about the hub, counter-clockwise: what the torque overcomes
    double contacts = 0;
};

/// Sums over the same steps for the balance of momentum.
struct StressBlock {
    double steps = 0;
    double drawbar_N = 0, torque_Nm = 0;  ///< P and T (clockwise)
    double effective_radius_m = 0;
    double impulse_x_Ns = 0, impulse_y_Ns = 0;  ///< growth of the wheel's momentum
    double spin_Nms = 0;                        ///< growth of its clockwise angular momentum about the hub
};

struct StressState {
    std::vector<SegmentSum> segment;  ///< block by block: the segments, then one for contacts on the upper half
    std::vector<StressBlock> block;
};

enum class Stage : std::uint64_t { consolidation = 0, sinkage = 1, travel = 2, finished = 3 };

struct Progress {
    Stage stage = Stage::consolidation;
    std::uint64_t step = 0;         ///< within the stage; time = step · dt, never accumulated
    std::uint64_t total_steps = 0;  ///< of all stages so far
};

// ---- Soil elements (chapter 5) --------------------------------------------------------------------------------------

/// What a block of the soil's grid consists of.
enum class BlockKind : std::uint32_t { discs = 0, element = 1 };

/// The shape in which a soil element is free of stress, counter-clockwise from its lower left corner.
struct ElementShape {
    std::array<Vec2, 4> corner_m;
};

/// A disc that an element carries on a segment or a node of its border (section 5.1.4): no mass, no weight.
struct AttachedDisc {
    double share = 0;                       ///< N_j of Eqs 5.4–5.6: where on its segment; 0 or 1 on a node
    double offset_x_m = 0, offset_y_m = 0;  ///< of its centre from there
    double radius_m = 0;
};

/// What discs and elements hold together, before or after a conversion.
struct SoilStock {
    double discs = 0;  ///< how many
    double disc_mass_kg = 0, element_mass_kg = 0;
    double momentum_x_Ns = 0, momentum_y_Ns = 0;
    double kinetic_J = 0, elastic_J = 0, height_J = 0;
    double surface_m = 0;  ///< of the block that changes
};

/// A conversion that was made or refused. Numbers only, so that it is stored as any other member.
struct ConversionRecord {
    double step = 0;  ///< of the travel
    double block = 0;
    double kind = 0;                            ///< 0: element to discs; 1: discs to element
    double refused = 0;                         ///< 1: the block's shape allowed no element
    double attached = 0, attached_mass_kg = 0;  ///< discs that became attached, and the mass that they lost
    SoilStock before, after;
};

/// The soil's grid of blocks: node (i, j) has number j (columns + 1) + i, block (i, j) number j columns + i. Nodes
/// without an element rest at their last place.
struct SoilState {
    std::vector<BlockKind> kind;
    std::vector<ElementShape> shape;  ///< per block; of no meaning for discs
    std::vector<double> mass_kg;  ///< of each block's element where conversions hand mass over (0: discs); else empty
    std::vector<Vec2> position_m, velocity_m_s;
    std::vector<BoundaryContact> contacts;  ///< with the elements' segments; sorted by list position, segment
    std::vector<AttachedDisc> attached;
    std::vector<std::uint32_t> attached_from, attached_to;  ///< nodes of each one's segment
    std::vector<std::uint32_t> attached_block;
    std::vector<BoundaryContact> attached_contacts;  ///< free discs with attached ones; sorted by list position, number
    std::vector<Disc> pattern;                  ///< the discs of one block, relative to its lower left corner; constant
    std::vector<ConversionRecord> conversions;  ///< of this stage
};

struct State {
    Progress progress;
    DiscState discs;
    PairState pairs;
    std::vector<BoundaryContact> wall_contacts;   ///< sorted by list position, wall
    std::vector<BoundaryContact> wheel_contacts;  ///< sorted by list position, segment
    WheelState wheel;
    ControlState control;
    EnergyLedger energy;
    SeriesSums series;
    StressState stress;
    Vec2 touch_position_m;  ///< hub centre just before the first touch: the zero of sinkage
    SoilState soil;         ///< empty without soil elements
};

[[nodiscard]] inline bool has_soil_elements(const State& s) { return !s.soil.kind.empty(); }

/// Calls f(name, member) for every member of the state, in a fixed order. Members are arithmetic values, enums, Vec2
/// and other aggregates of doubles, or vectors of these. Works on State& and const State&.
template <class S, class F>
void for_each_member(S& s, F&& f) {
    f("progress/stage", s.progress.stage);
    f("progress/step", s.progress.step);
    f("progress/total_steps", s.progress.total_steps);
    f("discs/disc", s.discs.disc);
    f("discs/id", s.discs.id);
    f("discs/acceleration", s.discs.acceleration);
    f("pairs/i", s.pairs.i);
    f("pairs/j", s.pairs.j);
    f("pairs/tangential_m", s.pairs.tangential_m);
    f("pairs/reference", s.pairs.reference);
    f("pairs/inner", s.pairs.inner);
    f("pairs/inner_reference", s.pairs.inner_reference);
    f("wall_contacts", s.wall_contacts);
    f("wheel_contacts", s.wheel_contacts);
    f("wheel/position_m", s.wheel.position_m);
    f("wheel/velocity_m_s", s.wheel.velocity_m_s);
    f("wheel/rim", s.wheel.rim);
    f("control/drawbar", s.control.drawbar);
    f("control/torque", s.control.torque);
    f("energy", s.energy);
    f("series", s.series);
    f("touch_position_m", s.touch_position_m);
}

/// The same for the members that only scenes with soil elements have: they add nothing to other scenes' hash and
/// checkpoint.
template <class S, class F>
void for_each_soil_member(S& s, F&& f) {
    f("soil_kind", s.soil.kind);
    f("soil_shape", s.soil.shape);
    f("soil_position_m", s.soil.position_m);
    f("soil_velocity_m_s", s.soil.velocity_m_s);
    f("soil_contacts", s.soil.contacts);
    f("soil_attached", s.soil.attached);
    f("soil_attached_from", s.soil.attached_from);
    f("soil_attached_to", s.soil.attached_to);
    f("soil_attached_block", s.soil.attached_block);
    f("soil_attached_contacts", s.soil.attached_contacts);
    f("soil_pattern", s.soil.pattern);
    f("soil_conversions", s.soil.conversions);
}

/// True if forces of contacts with the wheel are being averaged, or have been.
[[nodiscard]] inline bool has_contact_stress(const State& s) { return !s.stress.block.empty(); }

/// And for the members that only such scenes have.
template <class S, class F>
void for_each_stress_member(S& s, F&& f) {
    f("stress_segment", s.stress.segment);
    f("stress_block", s.stress.block);
}

/// True if conversions hand mass over, so that an element need not have its density times its volume.
[[nodiscard]] inline bool has_element_mass(const State& s) { return !s.soil.mass_kg.empty(); }

/// And for the member that only such scenes have.
template <class S, class F>
void for_each_mass_member(S& s, F&& f) {
    f("soil_mass_kg", s.soil.mass_kg);
}

/// All of these that the state has: what is hashed is what a checkpoint holds.
template <class S, class F>
void for_each_present_member(S& s, F&& f) {
    for_each_member(s, f);
    if (has_soil_elements(s)) for_each_soil_member(s, f);
    if (has_contact_stress(s)) for_each_stress_member(s, f);
    if (has_element_mass(s)) for_each_mass_member(s, f);
}

/// The hash that `run` prints: every member, bytes as they are.
[[nodiscard]] std::uint64_t hash_state(const State& state);

}  // namespace ifedem
