#include "traction/contact_stress.hpp"

#include <algorithm>
#include <cmath>

#include "core/bitmath.hpp"

namespace ifedem {
namespace {

std::size_t segments_of(const StressState& stress) { return stress.segment.size() / stress.block.size() - 1; }

/// Clockwise, about the hub and relative to its motion.
double spin_Nms(const WheelModel& m, const WheelState& w) {
    double sum = m.body_inertia_kg_m2 * w.rim.omega_rad_s;
    for (const std::uint32_t n : m.free_node)
        sum += m.elements.mass_kg[n] * cross(w.position_m[n] - hub_position(w), w.velocity_m_s[n] - w.rim.velocity_m_s);
    return -sum;
}

/// `sign` −1 before the step, +1 after it.
void add_momentum(const WheelModel& model, const WheelState& wheel, double sign, StressBlock& b) {
    const Vec2 p = momentum_Ns(model, wheel);
    b.impulse_x_Ns += sign * p.x;
    b.impulse_y_Ns += sign * p.y;
    b.spin_Nms += sign * spin_Nms(model, wheel);
}

/// Force f on the wheel as (along, across) the outward unit vector: compression, and forward at bottom dead centre.
Vec2 resolve(Vec2 f, Vec2 outward) { return {-dot(f, outward), dot(f, Vec2{-outward.y, outward.x})}; }

void add_contact(const WheelState& wheel, const WheelContact& c, std::size_t segments, SegmentSum* sums) {
    const Vec2 foot = (1.0 - c.share) * wheel.position_m[c.from] + c.share * wheel.position_m[c.to];
    const Vec2 r = foot - hub_position(wheel);
    const Vec2 f = Vec2{0, 0} - c.on_disc.force_N;
    const double place = contact_angle_rad(r) / pi * static_cast<double>(segments);
    SegmentSum& s = sums[static_cast<std::size_t>(min_of(place, static_cast<double>(segments)))];
    const Vec2 radial = resolve(f, (1.0 / norm(r)) * r), own = resolve(f, c.outward);
    s.radial_N += radial.x, s.circumferential_N += radial.y;
    s.normal_N += own.x, s.tangential_N += own.y;
    s.fx_N += f.x, s.fy_N += f.y;
    s.moment_Nm += cross(r, f);
    s.contacts += 1;
}

void divide(SegmentSum& s, double by) {
    s.radial_N /= by, s.circumferential_N /= by;
    s.normal_N /= by, s.tangential_N /= by;
    s.fx_N /= by, s.fy_N /= by;
    s.moment_Nm /= by, s.contacts /= by;
}

}  // namespace

void add(SegmentSum& to, const SegmentSum& s) {
    to.radial_N += s.radial_N, to.circumferential_N += s.circumferential_N;
    to.normal_N += s.normal_N, to.tangential_N += s.tangential_N;
    to.fx_N += s.fx_N, to.fy_N += s.fy_N;
    to.moment_Nm += s.moment_Nm, to.contacts += s.contacts;
}

double contact_angle_rad(Vec2 from_hub_m) {
    const double angle = atan2_fixed(-from_hub_m.y, from_hub_m.x);
    return angle < 0 ? angle + 2 * pi : angle;
}

std::optional<std::size_t> enter_stress_block(const RecordCase& record, State& state) {
    if (record.stress_segments == 0 || state.progress.stage != Stage::travel) return std::nullopt;
    const double share =
        (hub_position(state.wheel).x - record.stress_from_x_m) / (record.stress_to_x_m - record.stress_from_x_m);
    if (!(share >= 0 && share < 1)) return std::nullopt;
    const auto blocks = static_cast<std::size_t>(record.stress_blocks);
    if (state.stress.block.empty()) {
        state.stress.block.resize(blocks);
        state.stress.segment.resize(blocks * static_cast<std::size_t>(record.stress_segments + 1));
    }
    return std::min(blocks - 1, static_cast<std::size_t>(share * static_cast<double>(blocks)));
}

void add_contacts_to_stress(const RecordCase& record, const WheelModel& model, const WheelWorkspace& work,
                            std::size_t block, State& state) {
    const auto segments = static_cast<std::size_t>(record.stress_segments);
    SegmentSum* sums = state.stress.segment.data() + block * (segments + 1);
    for (const WheelContact& c : work.contact) add_contact(state.wheel, c, segments, sums);
    add_momentum(model, state.wheel, -1.0, state.stress.block[block]);
}

void add_control_to_stress(const WheelModel& model, std::size_t block, State& state) {
    StressBlock& b = state.stress.block[block];
    b.steps += 1;
    b.drawbar_N += state.control.drawbar.output;
    b.torque_Nm += state.control.torque.output;
    b.effective_radius_m += effective_radius_m(model, state.wheel);
    add_momentum(model, state.wheel, 1.0, b);
}

StressBlock sum_blocks(const StressState& stress, std::optional<std::size_t> block) {
    StressBlock sum;
    for (std::size_t n = 0; n < stress.block.size(); ++n) {
        if (block && *block != n) continue;
        const StressBlock& b = stress.block[n];
        sum.steps += b.steps;
        sum.drawbar_N += b.drawbar_N, sum.torque_Nm += b.torque_Nm;
        sum.effective_radius_m += b.effective_radius_m;
        sum.impulse_x_Ns += b.impulse_x_Ns, sum.impulse_y_Ns += b.impulse_y_Ns, sum.spin_Nms += b.spin_Nms;
    }
    return sum;
}

std::vector<MeanSegment> mean_segments(const StressState& stress, std::optional<std::size_t> block) {
    const double steps = sum_blocks(stress, block).steps;
    if (!(steps > 0)) return {};
    const std::size_t segments = segments_of(stress);
    std::vector<MeanSegment> means(segments + 1);
    for (std::size_t k = 0; k <= segments; ++k) {
        means[k].angle_rad =
            k == segments ? 1.5 * pi : (static_cast<double>(k) + 0.5) * pi / static_cast<double>(segments);
        for (std::size_t n = 0; n < stress.block.size(); ++n)
            if (!block || *block == n) add(means[k].mean, stress.segment[n * (segments + 1) + k]);
        divide(means[k].mean, steps);
    }
    return means;
}

}  // namespace ifedem
