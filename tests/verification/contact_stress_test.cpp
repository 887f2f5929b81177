// Averaging of contact forces on virtual segments (Eqs 4.1, 4.2): vectors, bins, window, balance of momentum.
#include "traction/contact_stress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "record/checkpoint.hpp"
#include "support/dem_scenes.hpp"
#include "support/scratch.hpp"
#include "traction/contact_stress_curve.hpp"

namespace ifedem {
namespace {

using namespace scene;

RecordCase make_record(std::int64_t segments) {
    RecordCase r;
    r.stress_segments = segments, r.stress_blocks = 2;
    r.stress_from_x_m = 0.4, r.stress_to_x_m = 0.6;
    return r;
}

WheelCase make_smooth_wheel() {
    WheelCase w;
    w.lug_pairs = 0;
    return w;
}

/// A wheel at rest with random contacts all round and random forces: what the sums must be is known contact by contact.
struct Contacts {
    WheelModel model = make_wheel_model(make_smooth_wheel());
    State state;
    WheelWorkspace work;
    double size_N = 0;

    explicit Contacts(std::uint64_t seed) {
        state.progress.stage = Stage::travel;
        state.wheel = place_wheel(model, {0.45, 0.3});
        Random random{seed};
        const auto& loop = model.mesh.boundary;
        for (int n = 0; n < 500; ++n) {
            WheelContact c;
            const std::size_t k = random.below(loop.size());
            c.from = loop[k], c.to = loop[(k + 1) % loop.size()];
            c.share = random.uniform();
            const Vec2 along = state.wheel.position_m[c.to] - state.wheel.position_m[c.from];
            c.outward = (1 / norm(along)) * Vec2{along.y, -along.x};
            c.on_disc.force_N = {random.uniform() - 0.5, random.uniform() - 0.5};
            size_N += norm(c.on_disc.force_N);
            work.contact.push_back(c);
        }
    }

    [[nodiscard]] Vec2 foot(const WheelContact& c) const {
        return (1 - c.share) * state.wheel.position_m[c.from] + c.share * state.wheel.position_m[c.to];
    }

    /// One step of averaging.
    std::vector<MeanSegment> average(std::int64_t segments) {
        state.stress = {};
        const RecordCase record = make_record(segments);
        const auto block = enter_stress_block(record, state);
        EXPECT_EQ(block, 0U);
        add_contacts_to_stress(record, model, work, *block, state);
        add_control_to_stress(model, *block, state);
        return mean_segments(state.stress);
    }
};

TEST(ContactStress, keeps_vectors_and_moments_of_every_contact) {
    Contacts w(1);
    const std::vector<MeanSegment> means = w.average(1000);
    ASSERT_EQ(means.size(), 1001U);
    std::vector<SegmentSum> exact(1001);
    for (const WheelContact& c : w.work.contact) {
        const Vec2 r = w.foot(c) - Vec2{0.45, 0.3}, f = -1.0 * c.on_disc.force_N;
        const double angle = std::atan2(-r.y, r.x), radial = -dot(f, r) / norm(r), moment = r.x * f.y - r.y * f.x;
        const std::size_t k = angle < 0 ? 1000 : static_cast<std::size_t>(angle / pi * 1000);
        exact[k].radial_N += radial;
        exact[k].circumferential_N += moment / norm(r);
        exact[k].normal_N -= dot(f, c.outward);
        exact[k].tangential_N += c.outward.x * f.y - c.outward.y * f.x;
        exact[k].fx_N += f.x, exact[k].fy_N += f.y;
        exact[k].moment_Nm += moment;
        exact[k].contacts += 1;
    }
    for (std::size_t k = 0; k <= 1000; ++k) {
        EXPECT_NEAR(means[k].mean.radial_N, exact[k].radial_N, 1e-14 * w.size_N) << k;
        EXPECT_NEAR(means[k].mean.circumferential_N, exact[k].circumferential_N, 1e-14 * w.size_N) << k;
        EXPECT_NEAR(means[k].mean.normal_N, exact[k].normal_N, 1e-14 * w.size_N) << k;
        EXPECT_NEAR(means[k].mean.tangential_N, exact[k].tangential_N, 1e-14 * w.size_N) << k;
        EXPECT_NEAR(means[k].mean.fx_N, exact[k].fx_N, 1e-14 * w.size_N) << k;
        EXPECT_NEAR(means[k].mean.fy_N, exact[k].fy_N, 1e-14 * w.size_N) << k;
        EXPECT_NEAR(means[k].mean.moment_Nm, exact[k].moment_Nm, 1e-14 * w.size_N) << k;
        EXPECT_EQ(means[k].mean.contacts, exact[k].contacts) << k;
    }
}

// A contact is at most half a segment from its segment's centre: parts turned back there are that near to the vector.
TEST(ContactStress, of_segments_is_within_half_a_segment_of_the_vectors) {
    for (const std::int64_t segments : {500, 1000, 2000}) {
        Contacts w(2);
        Vec2 vectors, turned;
        for (const MeanSegment& m : w.average(segments)) {
            if (m.angle_rad > pi) continue;
            const double c = std::cos(m.angle_rad), s = std::sin(m.angle_rad);
            vectors += Vec2{m.mean.fx_N, m.mean.fy_N};
            turned += Vec2{m.mean.circumferential_N * s - m.mean.radial_N * c,
                           m.mean.radial_N * s + m.mean.circumferential_N * c};
        }
        const double error = norm(vectors - turned) / w.size_N;
        std::printf("%ld segments: %.2e of the forces (bound %.2e)\n", static_cast<long>(segments), error,
                    pi / 2 / static_cast<double>(segments));
        EXPECT_LE(error, pi / 2 / static_cast<double>(segments));
        EXPECT_GT(error, 0);
    }
}

TEST(ContactStress, of_fewer_segments_is_the_sum_of_more) {
    Contacts w(3);
    const auto coarse = w.average(500), middle = w.average(1000), fine = w.average(2000);
    for (std::size_t k = 0; k < 500; ++k) {
        double two = 0, four = 0;
        for (std::size_t n = 0; n < 2; ++n) two += middle[2 * k + n].mean.radial_N;
        for (std::size_t n = 0; n < 4; ++n) four += fine[4 * k + n].mean.radial_N;
        EXPECT_NEAR(coarse[k].mean.radial_N, two, 1e-14 * w.size_N);
        EXPECT_NEAR(coarse[k].mean.radial_N, four, 1e-14 * w.size_N);
    }
    EXPECT_NEAR(middle[0].angle_rad, 0.5 * pi / 1000, 1e-15);  // (k − 1/2) π/1000
    EXPECT_EQ(coarse.back().mean.contacts, fine.back().mean.contacts);
}

TEST(ContactStress, is_averaged_in_the_window_alone_and_block_by_block) {
    Contacts w(4);
    const RecordCase record = make_record(1000);
    const auto at = [&](double x) {
        w.state.wheel.rim.position_m.x = x;
        return enter_stress_block(record, w.state);
    };
    EXPECT_FALSE(at(0.3999));
    EXPECT_TRUE(w.state.stress.block.empty());  // nothing in the state before the window
    EXPECT_EQ(at(0.4), 0U);
    EXPECT_EQ(at(0.4999), 0U);
    EXPECT_EQ(at(0.5), 1U);
    EXPECT_EQ(at(0.5999), 1U);
    EXPECT_FALSE(at(0.6));
    w.state.progress.stage = Stage::sinkage;
    EXPECT_FALSE(at(0.5));
    w.state.progress.stage = Stage::travel;
    RecordCase none = record;
    none.stress_segments = 0;
    EXPECT_FALSE(enter_stress_block(none, w.state));
}

/// An elastic smooth wheel on a small bed, travelling.
World make_travel(double load_N) {
    Case c;
    c.bed.length_m = 0.5, c.bed.disc_count = 500;
    c.wheel.lug_pairs = 0;
    c.wheel.load_N = load_N;
    c.travel.start_x_m = 0.25, c.travel.distance_m = 0.01, c.travel.acceleration_time_s = 0.01;
    c.record.stress_segments = 200, c.record.stress_blocks = 3;
    c.record.stress_from_x_m = 0.2500, c.record.stress_to_x_m = 0.2506;
    World w;
    w.state = make_initial_state(c);
    omp_set_num_threads(1);
    for (const auto& [stage, steps] :
         {std::pair{Stage::consolidation, 6000}, {Stage::sinkage, 4000}, {Stage::travel, 0}}) {
        w.scene = make_scene(c, stage);
        begin_stage(w.scene, w.state);
        w.work = make_workspace(w.scene, w.state);
        advance(w, steps);
    }
    return w;
}

// Soil on the wheel + controller + load = growth of momentum, over any window, to round-off.
TEST(ContactStress, balances_with_the_controllers_and_the_load) {
    World w = make_travel(60);
    advance(w, 800);
    const StressBlock b = sum_blocks(w.state.stress);
    ASSERT_GT(b.steps, 250);
    ASSERT_GT(w.state.stress.block[2].steps, 0);
    double fx = 0, fy = 0, moment = 0;
    for (const MeanSegment& m : mean_segments(w.state.stress)) {
        fx += m.mean.fx_N, fy += m.mean.fy_N, moment += m.mean.moment_Nm;
        EXPECT_TRUE(m.angle_rad < pi || m.mean.contacts == 0);
    }
    const double time = b.steps * w.scene.dem.step_s;
    EXPECT_NEAR(fx + b.drawbar_N / b.steps, b.impulse_x_Ns / time, 1e-9 * 60);
    EXPECT_NEAR(fy - 60, b.impulse_y_Ns / time, 1e-9 * 60);
    const double torque = b.torque_Nm / b.steps;
    std::printf("torque %.5f N m, moment of contacts %.5f, growth of spin %.5f\n", torque, moment, b.spin_Nms / time);
    EXPECT_NEAR(moment, torque - b.spin_Nms / time, 2e-3 * std::fabs(torque));
    EXPECT_GT(fy, 10);  // a wheel that bounces, but on the ground
}

TEST(ContactStress, goes_on_after_a_checkpoint_as_if_nothing_had_been) {
    const Scratch scratch;
    World w = make_travel(60);
    advance(w, 300);
    ASSERT_FALSE(w.state.stress.block.empty());
    write_checkpoint(scratch.file("a.h5"), w.state, w.scene.c);
    World resumed;
    resumed.scene = make_scene(w.scene.c, Stage::travel);
    resumed.state = read_checkpoint(scratch.file("a.h5")).state;
    resumed.work = make_workspace(resumed.scene, resumed.state);
    advance(w, 300);
    advance(resumed, 300);
    EXPECT_EQ(hash_state(resumed.state), hash_state(w.state));
}

// ---- What is read off the curves -----------------------------------------------------------------------------------

/// σ a parabola between 65° and 105° with its peak in the middle, τ one between 60° and 100°, on 1000 segments.
StressCurve make_curve() {
    StressCurve c;
    const auto hump = [](double deg, double from, double to) {
        return std::fmax(0.0, (deg - from) * (to - deg) * 4 / ((to - from) * (to - from)));
    };
    for (int k = 0; k < 1000; ++k) {
        const double deg = (k + 0.5) * 0.18;
        c.angle_rad.push_back(deg * pi / 180);
        c.normal_Pa.push_back(40e3 * hump(deg, 65, 105));
        c.tangential_Pa.push_back(10e3 * hump(deg, 60, 100) - 3e3 * hump(deg, 100, 110));
    }
    return c;
}

TEST(StressCurve, features_are_those_of_the_curve) {
    const CurveFeatures f = find_features(make_curve(), 0.8 * pi / 180);
    EXPECT_NEAR(f.greatest_normal_rad * 180 / pi, 85, 0.01);
    EXPECT_NEAR(f.greatest_normal_Pa, 40e3, 40);  // the kernel takes its variance off a parabola's top
    EXPECT_NEAR(f.greatest_tangential_rad * 180 / pi, 80, 0.01);
    EXPECT_NEAR(f.least_tangential_Pa, -3e3, 50);
    // 5 % of the peak of a parabola: (1 − √0.95)/2 of its width inside the edge.
    EXPECT_NEAR(f.entry_rad[2] * 180 / pi, 65 + 20 * (1 - std::sqrt(0.95)), 0.1);
    EXPECT_NEAR(f.exit_rad[2] * 180 / pi, 105 - 20 * (1 - std::sqrt(0.95)), 0.1);
    EXPECT_LT(f.entry_rad[0], f.entry_rad[1]);
    EXPECT_GT(f.exit_rad[0], f.exit_rad[1]);
    EXPECT_NEAR(f.relative_peak(), 5.0 / (90 - f.entry_rad[1] * 180 / pi), 1e-3);
}

TEST(StressCurve, stray_contacts_far_out_are_no_entry) {
    StressCurve c = make_curve();
    for (std::size_t k = 100; k < 110; ++k) c.normal_Pa[k] = 20e3;
    EXPECT_EQ(find_features(c, 0.01).entry_rad, find_features(make_curve(), 0.01).entry_rad);
}

TEST(StressCurve, smoothing_keeps_straight_lines_and_sums) {
    std::vector<double> line, spike(200);
    for (int k = 0; k < 200; ++k) line.push_back(3 + 0.5 * k);
    spike[100] = 1;
    const auto smooth_line = smooth(line, 0.01, 0.055), smooth_spike = smooth(spike, 0.01, 0.055);
    for (std::size_t k = 10; k < 190; ++k) EXPECT_NEAR(smooth_line[k], line[k], 1e-12);
    double sum = 0;
    for (const double s : smooth_spike) sum += s;
    EXPECT_NEAR(sum, 1, 1e-14);
    EXPECT_GT(smooth_spike[105], 0);
    EXPECT_EQ(smooth_spike[106], 0);
}

// Blocks that are alike scatter nothing; blocks that differ scatter as means of draws do.
TEST(StressCurve, bootstrap_scatters_as_the_blocks_do) {
    const auto make = [](double spread) {
        StressState s;
        s.block.assign(10, {});
        s.segment.assign(10 * 101, {});
        for (std::size_t b = 0; b < 10; ++b) {
            s.block[b].steps = 100;
            for (std::size_t k = 40; k <= 60; ++k) {
                const double x = (static_cast<double>(k) - 50) / 10.5;
                const double factor = 1 + spread * (static_cast<double>(b) - 4.5);
                s.segment[b * 101 + k].radial_N = 100 * (1 - x * x) * factor;
            }
        }
        return s;
    };
    const ContactArc arc{0.17, 0.2675};
    const auto deviation = [&](double spread) {
        Random random{1};
        const std::vector<StressState> runs{make(spread)};
        const auto replicates = bootstrap_features(runs, arc, Decomposition::radial, 0.05, 2000, random);
        double sum = 0, squares = 0;
        for (const CurveFeatures& f : replicates) sum += f.greatest_normal_Pa;
        sum /= 2000;
        for (const CurveFeatures& f : replicates) squares += std::pow(f.greatest_normal_Pa / sum - 1, 2);
        return std::sqrt(squares / 2000);
    };
    EXPECT_LT(deviation(0), 1e-12);
    // Factors −4.5 … 4.5 times the spread: standard deviation √8.25, of the mean of ten draws that over √10.
    EXPECT_NEAR(deviation(0.05), 0.05 * std::sqrt(8.25 / 10), 0.004);
}

}  // namespace
}  // namespace ifedem
