#include "step/move_fours.hpp"

#include "core/pack.hpp"

namespace ifedem {
namespace {

IFEDEM_INLINE Four load(const double* p) { return load_as<Four>(p); }
IFEDEM_INLINE void store(double* p, Four v) { __builtin_memcpy(p, &v, sizeof v); }

template <bool springs>
IFEDEM_INLINE bool move_all(const MotionBatch& batch) {
    const MotionBatch m = batch;
    const Four dt = Four{} + m.step_s, fall_x = Four{} + m.fall_x_m_s, fall_y = Four{} + m.fall_y_m_s, zero{};
    const Four limit = zero + m.calm_m_s * m.calm_m_s;
    auto calm = zero == zero;  // NOLINT(misc-redundant-expression): true in each lane
    for (std::uint32_t p = 0; p + 4 <= m.count; p += 4) {
        Disc* d = m.disc + p;
        DiscForce* f = m.force + p;
        auto [x, y, vx, vy] = transpose({load(&d[0].x_m), load(&d[1].x_m), load(&d[2].x_m), load(&d[3].x_m)});
        auto [omega, radius, inverse_mass, angle] = transpose(
            {load(&d[0].omega_rad_s), load(&d[1].omega_rad_s), load(&d[2].omega_rad_s), load(&d[3].omega_rad_s)});
        const auto [fx, turning, fy, rolling] =
            transpose({load(&f[0].x_N), load(&f[1].x_N), load(&f[2].x_N), load(&f[3].x_N)});
        for (int n = 0; n < 4; ++n) store(&f[n].x_N, zero);
        const Four spin = load(m.spin_per_moment + p);
        if constexpr (springs) {
            omega = omega + spin * (radius * turning + rolling);
        } else {
            const Four free = omega + spin * (radius * turning);
            const Four turned = -free, size = free > turned ? free : turned;
            const Four rest = size - spin * rolling, slower = rest > zero ? rest : zero;
            omega = free < zero ? -slower : slower;
        }
        const Four impulse = dt * inverse_mass;
        vx = vx + (impulse * fx + fall_x), vy = vy + (impulse * fy + fall_y);
        x = x + dt * vx, y = y + dt * vy, angle = angle + dt * omega;
        const FourRows first = transpose({x, y, vx, vy}), second = transpose({omega, radius, inverse_mass, angle});
        store(&d[0].x_m, first.a), store(&d[1].x_m, first.b), store(&d[2].x_m, first.c), store(&d[3].x_m, first.d);
        store(&d[0].omega_rad_s, second.a), store(&d[1].omega_rad_s, second.b);
        store(&d[2].omega_rad_s, second.c), store(&d[3].omega_rad_s, second.d);
        calm &= vx * vx + vy * vy <= limit;
    }
    return calm[0] && calm[1] && calm[2] && calm[3];
}

}  // namespace

bool move_fours(const MotionBatch& batch) {
    return batch.rolling_springs ? move_all<true>(batch) : move_all<false>(batch);
}

Watch watch_fours(const MotionBatch& batch) {
    const Four zero{};
    auto stays = zero == zero;  // NOLINT(misc-redundant-expression): true in each lane
    Four spare = zero + 1e300, fastest = zero;
    for (std::uint32_t p = 0; p + 4 <= batch.count; p += 4) {
        const Disc* d = batch.disc + p;
        const auto [x, y, vx, vy] = transpose({load(&d[0].x_m), load(&d[1].x_m), load(&d[2].x_m), load(&d[3].x_m)});
        // x0 y0 s0 x1 | y1 s1 x2 y2 | s2 x3 y3 s3
        const double* from = &batch.from[p].x_m;
        const Four u = load(from), v = load(from + 4), w = load(from + 8);
        const Four from_x = __builtin_shufflevector(__builtin_shufflevector(u, v, 0, 3, 6, 6), w, 0, 1, 2, 5);
        const Four from_y = __builtin_shufflevector(__builtin_shufflevector(u, v, 1, 4, 7, 7), w, 0, 1, 2, 6);
        const Four skin = __builtin_shufflevector(__builtin_shufflevector(u, v, 2, 5, 5, 5), w, 0, 1, 4, 7);
        const Four dx = x - from_x, dy = y - from_y, gone2 = dx * dx + dy * dy, speed2 = vx * vx + vy * vy;
        stays &= gone2 <= skin * skin;  // as has_left()
        const Four left = skin - root(Pack<4>(Pack<4>::FromRaw{}, gone2)).v;
        spare = left < spare ? left : spare;
        fastest = speed2 > fastest ? speed2 : fastest;
    }
    const Pack<4> speed = root(Pack<4>(Pack<4>::FromRaw{}, fastest));
    Watch out{!(stays[0] && stays[1] && stays[2] && stays[3]), spare[0], speed.v[0]};
    for (int lane = 1; lane < 4; ++lane) {
        out.spare_m = spare[lane] < out.spare_m ? spare[lane] : out.spare_m;
        out.fastest_m_s = speed.v[lane] > out.fastest_m_s ? speed.v[lane] : out.fastest_m_s;
    }
    return out;
}

}  // namespace ifedem
