#include "dem/skins.hpp"

#include <cmath>

namespace ifedem {
namespace {

double speed_squared(const Disc& d) { return d.vx_m_s * d.vx_m_s + d.vy_m_s * d.vy_m_s; }

/// How much wider a disc's skin is than the usual one: 1 up to `swift_speed` times the rms speed.
class SkinWidth {
public:
    explicit SkinWidth(const std::vector<Disc>& discs) {
        double sum = 0;
        for (const Disc& d : discs) sum += speed_squared(d);
        limit2_ = swift_speed * swift_speed * sum / static_cast<double>(discs.size());
    }
    [[nodiscard]] double operator()(const Disc& d) const {
        const double v2 = speed_squared(d);
        return v2 > limit2_ ? std::sqrt(v2 / limit2_) : 1.0;
    }

private:
    double limit2_ = 0;
};

}  // namespace

void note_outer_references(State& state) {
    const SkinWidth width(state.discs.disc);
    auto& reference = state.pairs.reference;
    reference.clear();
    for (const Disc& d : state.discs.disc)
        reference.push_back({d.x_m, d.y_m, min_of(outer_skin_m * width(d), largest_skin_m)});
}

void note_inner_references(State& state) {
    const SkinWidth width(state.discs.disc);
    const auto& disc = state.discs.disc;
    const auto& outer = state.pairs.reference;
    auto& reference = state.pairs.inner_reference;
    reference.resize(disc.size());
    for (std::size_t p = 0; p < disc.size(); ++p) {
        const double dx = disc[p].x_m - outer[p].x_m, dy = disc[p].y_m - outer[p].y_m;
        const double left = outer[p].skin_m - std::sqrt(dx * dx + dy * dy);
        reference[p] = {disc[p].x_m, disc[p].y_m, min_of(inner_skin_m * width(disc[p]), left)};
    }
}

void ask_for_lists(const State& state, DemWorkspace& work) {
    work.refresh_inner = true;
    const auto& disc = state.discs.disc;
    for (std::size_t p = 0; p < disc.size() && !work.rebuild_outer; ++p) {
        Reference spare = state.pairs.reference[p];
        spare.skin_m -= inner_skin_m;
        work.rebuild_outer = has_left(disc[p], spare);
    }
}

}  // namespace ifedem
