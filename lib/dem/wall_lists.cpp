#include "dem/wall_lists.hpp"

#include "dem/forces.hpp"

namespace ifedem {
namespace {

/// Signed gap between a disc and a wall.
double wall_gap(const DemConstants& k, std::uint32_t wall, const Disc& d) {
    const WallSide side = find_wall_side(k, wall, d);
    return side.distance_m - side.opposite_radius_m - d.radius_m;
}

/// Each block's part of the discs near walls.
void share_walls(DemWorkspace& work) {
    std::uint32_t n = 0;
    for (Block& block : work.block) {
        block.wall_begin = n;
        while (n < work.wall.size() && work.wall[n].position < block.disc_end) ++n;
        block.wall_end = n;
    }
}

}  // namespace

void find_outer_walls(const DemConstants& k, const State& state, DemWorkspace& work) {
    work.outer_wall.clear();
    const auto walls = static_cast<std::uint32_t>(k.flat_walls.size() + k.wall_discs.size());
    for (std::uint32_t p = 0; p < state.discs.disc.size(); ++p) {
        const Reference& reference = state.pairs.reference[p];
        Disc there = state.discs.disc[p];
        there.x_m = reference.x_m, there.y_m = reference.y_m;
        for (std::uint32_t w = 0; w < walls; ++w)
            if (wall_gap(k, w, there) <= reference.skin_m) work.outer_wall.push_back({p, w});
    }
}

void refresh_wall_contacts(const DemConstants& k, State& state, DemWorkspace& work) {
    auto& found = work.next_wall;
    found.clear(), work.wall.clear();
    std::size_t old = 0;
    const auto& before = state.wall_contacts;
    for (const WallCandidate& c : work.outer_wall) {
        if (wall_gap(k, c.wall, state.discs.disc[c.position]) > state.pairs.inner_reference[c.position].skin_m)
            continue;
        BoundaryContact contact{state.discs.id[c.position], c.wall, 0.0};
        while (old < before.size()) {
            const std::uint32_t at = work.position_of_id[before[old].disc];
            if (at > c.position || (at == c.position && before[old].surface >= c.wall)) break;
            ++old;
        }
        if (old < before.size() && before[old].disc == contact.disc && before[old].surface == c.wall)
            contact.tangential_m = before[old].tangential_m;
        found.push_back(contact);
        work.wall.push_back(c);
    }
    state.wall_contacts.swap(found);
    share_walls(work);
}

void unpack_walls(const State& state, DemWorkspace& work) {
    work.wall.clear();
    for (const BoundaryContact& c : state.wall_contacts) work.wall.push_back({work.position_of_id[c.disc], c.surface});
    share_walls(work);
}

}  // namespace ifedem
