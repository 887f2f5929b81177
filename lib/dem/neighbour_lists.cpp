#include "dem/neighbour_lists.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "dem/blocks.hpp"
#include "dem/grid.hpp"
#include "dem/skins.hpp"
#include "dem/vector_width.hpp"
#include "dem/wall_lists.hpp"

namespace ifedem {
namespace {

/// Room for `count` items with little more memory than that: by itself a vector takes twice what it had.
template <class T>
void reserve_closely(std::vector<T>& list, std::size_t count) {
    if (count > list.capacity()) list.reserve(count + count / 32);
}

template <class T>
void lengthen(std::vector<T>& list, std::size_t count) {
    reserve_closely(list, count);
    if (count > list.size()) list.resize(count);
}

/// Gives back what a rebuild needed for all outer pairs and the inner list does not.
template <class T>
void trim(std::vector<T>& list) {
    if (list.capacity() > list.size() + list.size() / 8) list.shrink_to_fit();
}

template <class T>
void permute(std::vector<T>& items, const std::vector<std::uint32_t>& order) {
    if (items.empty()) return;
    std::vector<T> moved(items.size());
    for (std::size_t p = 0; p < order.size(); ++p) moved[p] = items[order[p]];
    items.swap(moved);
}

/// A pair's springs, filed under the lower of its positions before the rebuild.
struct KeptSpring {
    std::uint32_t higher = 0;
    double tangential_m = 0, rolling_Nm = 0;
};

/// Few a disc, so a linear search finds them. Ids are in no order in space: by them each search would be a cache miss.
struct KeptSprings {
    std::vector<std::uint32_t> begin;
    std::vector<KeptSpring> spring;

    [[nodiscard]] KeptSpring find(std::uint32_t a, std::uint32_t b) const {
        const std::uint32_t low = std::min(a, b), high = std::max(a, b);
        for (std::uint32_t s = begin[low]; s < begin[low + 1]; ++s)
            if (spring[s].higher == high) return spring[s];
        return {};
    }
};

KeptSprings keep_springs(const State& state, const DemWorkspace& work) {
    const auto& p = state.pairs;
    KeptSprings kept;
    kept.begin.assign(state.discs.disc.size() + 1, 0);
    kept.spring.reserve(p.inner.size());
    for (std::size_t n = 0; n < p.inner.size(); ++n) {  // sorted by i, the lower one
        const double rolling = work.rolling_Nm.empty() ? 0.0 : work.rolling_Nm[n];
        if (p.tangential_m[n] == 0.0 && rolling == 0.0) continue;
        ++kept.begin[p.i[p.inner[n]] + 1];
        kept.spring.push_back({p.j[p.inner[n]], p.tangential_m[n], rolling});
    }
    for (std::size_t k = 1; k < kept.begin.size(); ++k) kept.begin[k] += kept.begin[k - 1];
    return kept;
}

double distance_squared(const Disc& a, const Disc& b) {
    const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
    return dx * dx + dy * dy;
}

bool is_within(const Disc& a, const Disc& b, double skins_m) {
    const double reach = a.radius_m + b.radius_m + skins_m;
    return distance_squared(a, b) <= reach * reach;
}

/// Pairs with at least one disc whose outer skin is wider than usual, filed under their lower position: `higher` holds
/// those of p from begin[p] to begin[p + 1].
struct SwiftPairs {
    std::vector<std::uint32_t> begin, higher;
};

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// A counting sort: in a fast flow half of all discs are swift, and comparing would cost more than finding them.
SwiftPairs file_pairs(const std::vector<Pair>& pairs, std::size_t discs) {
    SwiftPairs filed;
    filed.begin.assign(discs + 1, 0);
    filed.higher.resize(pairs.size());
    for (const auto& [low, high] : pairs) ++filed.begin[low + 1];
    for (std::size_t p = 0; p < discs; ++p) filed.begin[p + 1] += filed.begin[p];
    std::vector<std::uint32_t> next(filed.begin.begin(), filed.begin.end() - 1);
    for (const auto& [low, high] : pairs) filed.higher[next[low]++] = high;
    return filed;
}

/// The discs are sorted by cell. A pair is found once, from the disc with the wider skin (the lower position of two
/// alike), so that twice its own skin is as far as a disc has to look.
SwiftPairs find_swift_pairs(const Grid& grid, const State& state) {
    const auto& disc = state.discs.disc;
    const auto& reference = state.pairs.reference;
    double largest = 0;
    for (const Disc& d : disc) largest = max_of(largest, d.radius_m);
    std::vector<Pair> pairs;
    std::size_t found = 0;
    for (std::uint32_t i = 0; i < disc.size(); ++i) {
        const double skin = reference[i].skin_m;
        if (skin <= outer_skin_m) continue;
        const double reach = disc[i].radius_m + largest + 2 * skin;
        const std::uint32_t row0 = grid.row(disc[i].y_m - reach), row1 = grid.row(disc[i].y_m + reach);
        for (std::uint32_t x = grid.column(disc[i].x_m - reach); x <= grid.column(disc[i].x_m + reach); ++x) {
            const std::uint32_t first = grid.begin[x * grid.rows + row0], last = grid.begin[x * grid.rows + row1 + 1];
            lengthen(pairs, found + (last - first));
            for (std::uint32_t n = first; n < last; ++n) {
                const double other = reference[n].skin_m;
                const bool narrower = (other < skin) | ((other == skin) & (n > i));
                pairs[found] = {std::min(i, n), std::max(i, n)};
                found += static_cast<std::size_t>(narrower & is_within(disc[i], disc[n], skin + other));
            }
        }
    }
    pairs.resize(found);
    return file_pairs(pairs, disc.size());
}

/// All pairs within their outer skins, sorted by i then j. Here as everywhere in the lists a candidate is written and
/// kept by moving on behind it: a branch would be mistaken every third time.
void find_outer_pairs(const Grid& grid, State& state) {
    const Disc* disc = state.discs.disc.data();
    const Reference* reference = state.pairs.reference.data();
    const auto discs = static_cast<std::uint32_t>(state.discs.disc.size());
    const SwiftPairs swift = find_swift_pairs(grid, state);
    auto& p = state.pairs;
    p.i.clear();
    std::size_t found = 0;
    for (std::uint32_t i = 0; i < discs; ++i) {
        const std::size_t first_found = found;
        const std::uint32_t cx = grid.column(disc[i].x_m), cy = grid.row(disc[i].y_m);
        const std::uint32_t row0 = cy == 0 ? 0 : cy - 1, row1 = std::min(cy + 1, grid.rows - 1);
        const bool usual = reference[i].skin_m <= outer_skin_m;
        for (std::uint32_t x = cx == 0 ? 0 : cx - 1; usual && x <= std::min(cx + 1, grid.columns - 1); ++x) {
            const std::uint32_t first = std::max(grid.begin[x * grid.rows + row0], i + 1);
            const std::uint32_t last = grid.begin[x * grid.rows + row1 + 1];
            if (first >= last) continue;
            lengthen(p.j, found + (last - first));
            // Cells of a column follow each other and the discs are sorted by cell: positions ascend.
            for (std::uint32_t n = first; n < last; ++n) {
                p.j[found] = n;
                const bool near = is_within(disc[i], disc[n], 2 * outer_skin_m);
                found += static_cast<std::size_t>(near) & static_cast<std::size_t>(reference[n].skin_m <= outer_skin_m);
            }
        }
        const std::uint32_t swifts = swift.begin[i + 1] - swift.begin[i];
        if (swifts != 0) {
            lengthen(p.j, found + swifts);
            std::copy_n(swift.higher.begin() + swift.begin[i], swifts,
                        p.j.begin() + static_cast<std::ptrdiff_t>(found));
            found += swifts;
            std::sort(p.j.begin() + static_cast<std::ptrdiff_t>(first_found),
                      p.j.begin() + static_cast<std::ptrdiff_t>(found));
        }
        reserve_closely(p.i, found);
        p.i.resize(found, i);
    }
    p.j.resize(found);
}

void note_ids(const State& state, DemWorkspace& work) {
    work.position_of_id.resize(state.discs.id.size());
    for (std::uint32_t p = 0; p < state.discs.id.size(); ++p) work.position_of_id[state.discs.id[p]] = p;
}

/// Sorted by list position, then surface: the order in which contacts are computed.
void sort_by_position(std::vector<BoundaryContact>& contacts, const DemWorkspace& work) {
    std::sort(contacts.begin(), contacts.end(), [&](const BoundaryContact& a, const BoundaryContact& b) {
        const std::uint32_t pa = work.position_of_id[a.disc], pb = work.position_of_id[b.disc];
        return pa != pb ? pa < pb : a.surface < b.surface;  // unique keys: no ties
    });
}

void rebuild_outer_list(const DemConstants& k, State& state, DemWorkspace& work) {
    auto& discs = state.discs;
    const KeptSprings kept = keep_springs(state, work);
    const Grid grid = make_grid(discs.disc, 2 * (k.largest_radius_m + outer_skin_m));
    permute(discs.disc, grid.item);
    permute(discs.id, grid.item);
    permute(discs.acceleration, grid.item);
    note_outer_references(state);
    find_outer_pairs(grid, state);
    note_ids(state, work);
    sort_by_position(state.wall_contacts, work);
    sort_by_position(state.wheel_contacts, work);
    sort_by_position(state.soil.contacts, work);
    sort_by_position(state.soil.attached_contacts, work);
    // Until the inner list is chosen, it is the whole outer list with the springs carried over.
    auto& p = state.pairs;
    p.inner.resize(p.i.size());
    std::iota(p.inner.begin(), p.inner.end(), 0U);
    p.tangential_m.resize(p.i.size());
    if (k.rolling_springs) work.rolling_Nm.resize(p.i.size());
    for (std::size_t n = 0; n < p.i.size(); ++n) {
        const KeptSpring spring = kept.find(grid.item[p.i[n]], grid.item[p.j[n]]);
        p.tangential_m[n] = spring.tangential_m;
        if (k.rolling_springs) work.rolling_Nm[n] = spring.rolling_Nm;
    }
    ++work.rebuilds;
}

/// The block's outer pairs that are within their inner skins. Gives the end of what was kept.
std::size_t choose_inner_pairs(const Block& block, const State& state, DemWorkspace& work, std::size_t kept) {
    const auto& p = state.pairs;
    const Disc* disc = state.discs.disc.data();
    const Reference* reference = p.inner_reference.data();
    const std::size_t most = kept + (block.outer_end - block.outer_begin);
    for (auto* list : {&work.i, &work.j, &work.next_inner}) lengthen(*list, most);
    for (std::uint32_t n = block.outer_begin; n < block.outer_end; ++n) {
        const std::uint32_t i = p.i[n], j = p.j[n];
        work.i[kept] = i, work.j[kept] = j;
        work.next_inner[kept] = n;
        kept += is_within(disc[i], disc[j], reference[i].skin_m + reference[j].skin_m) ? 1U : 0U;
    }
    return kept;
}

/// Carries the springs of the block's pairs from the old inner list, of which they are [old, old_end), to the new one.
/// They are laid out by outer pair in between: to walk along both lists, each step waiting for the one before, took
/// twice as long as all the rest.
void carry_springs(const Block& block, std::size_t old, std::size_t old_end, const PairState& p,
                   const std::vector<double>& spring, DemWorkspace& work, std::vector<double>& next) {
    auto& by_outer = work.block_spring;  // 0 but for what stands in it here
    lengthen(by_outer, block.outer_end - block.outer_begin);
    lengthen(next, block.pair_end);
    for (std::size_t n = old; n < old_end; ++n) by_outer[p.inner[n] - block.outer_begin] = spring[n];
    for (std::size_t n = block.pair_begin; n < block.pair_end; ++n)
        next[n] = by_outer[work.next_inner[n] - block.outer_begin];
    for (std::size_t n = old; n < old_end; ++n) by_outer[p.inner[n] - block.outer_begin] = 0;
}

/// The dashpots of the inner list's pairs, made again at each refresh: to keep those of all outer pairs takes 25 bytes
/// a disc more and hardly less time.
void note_damping(const DemConstants& k, const State& state, DemWorkspace& work) {
    const Disc* disc = state.discs.disc.data();
    reserve_closely(work.damping_Ns_m, work.i.size());
    work.damping_Ns_m.resize(work.i.size());
    for (std::size_t n = 0; n < work.i.size(); ++n) {
        const double reduced = 1.0 / (disc[work.i[n]].inverse_mass_1_kg + disc[work.j[n]].inverse_mass_1_kg);
        work.damping_Ns_m[n] = dashpot_Ns_m(k.damping_ratio, k.soil.normal_stiffness_N_m, reduced);
    }
}

/// Chooses the pairs of the inner list and unpacks them for the pair loop; springs are carried over, into the memory of
/// the dashpots, which are made anew in that of the old springs.
void refresh_inner_list(const DemConstants& k, State& state, DemWorkspace& work) {
    auto& p = state.pairs;
    note_inner_references(state);
    const bool rolling_springs = !work.rolling_Nm.empty();
    std::size_t kept = 0, old_end = 0;
    for (Block& block : work.block) {
        block.pair_begin = static_cast<std::uint32_t>(kept);
        kept = choose_inner_pairs(block, state, work, kept);
        block.pair_end = static_cast<std::uint32_t>(kept);
        block.calm_steps = 0;
        const std::size_t old_begin = old_end;
        while (old_end < p.inner.size() && p.inner[old_end] < block.outer_end) ++old_end;
        carry_springs(block, old_begin, old_end, p, p.tangential_m, work, work.damping_Ns_m);
        if (rolling_springs) carry_springs(block, old_begin, old_end, p, work.rolling_Nm, work, work.next_rolling_Nm);
    }
    for (auto* list : {&work.i, &work.j, &work.next_inner}) list->resize(kept);
    work.damping_Ns_m.resize(kept);
    p.inner.swap(work.next_inner);
    p.tangential_m.swap(work.damping_Ns_m);
    note_damping(k, state, work);
    if (rolling_springs) work.next_rolling_Nm.resize(kept), work.rolling_Nm.swap(work.next_rolling_Nm);
    ++work.refreshes;
}

/// The inner list as it stands.
void unpack_pairs(const DemConstants& k, const State& state, DemWorkspace& work) {
    const auto& p = state.pairs;
    for (auto* list : {&work.i, &work.j}) list->clear(), list->reserve(p.inner.size());
    std::size_t n = 0;
    for (Block& block : work.block) {
        block.pair_begin = static_cast<std::uint32_t>(n);
        for (; n < p.inner.size() && p.inner[n] < block.outer_end; ++n) {
            const std::uint32_t outer = p.inner[n];
            work.i.push_back(p.i[outer]), work.j.push_back(p.j[outer]);
        }
        block.pair_end = static_cast<std::uint32_t>(n);
    }
    note_damping(k, state, work);
}

/// What depends on masses and radii alone: renewed when the outer list is.
void note_constants(const DemConstants& k, const State& state, DemWorkspace& work) {
    work.spin_per_moment.clear(), work.spin_per_moment.reserve(state.discs.disc.size());
    for (const Disc& d : state.discs.disc)
        work.spin_per_moment.push_back(2.0 * (k.step_s * d.inverse_mass_1_kg) / (d.radius_m * d.radius_m));
}

/// Everything that stays as it is until the next rebuild.
void lay_out(const DemConstants& k, const State& state, DemWorkspace& work) {
    note_constants(k, state, work);
    find_outer_walls(k, state, work);
    lay_out_blocks(state, work);
}

}  // namespace

void update_lists(const DemConstants& k, State& state, DemWorkspace& work) {
    if (!work.rebuild_outer && !work.refresh_inner) return;
    if (work.rebuild_outer) {
        rebuild_outer_list(k, state, work);
        lay_out(k, state, work);
    }
    refresh_inner_list(k, state, work);
    if (work.rebuild_outer) {
        work.next_inner.clear();
        trim(work.next_inner), trim(state.pairs.inner);
        trim(work.damping_Ns_m), trim(state.pairs.tangential_m);
    }
    refresh_wall_contacts(k, state, work);
    work.rebuild_outer = work.refresh_inner = false;
}

void attach_workspace(const DemConstants& k, State& state, DemWorkspace& work) {
    work.vector_width = vector_width(), work.pair_kernel = choose_pair_kernel(work.vector_width);
    note_ids(state, work);
    work.rebuild_outer = work.refresh_inner = state.pairs.reference.empty();
    if (work.rebuild_outer) return;
    lay_out(k, state, work);
    unpack_pairs(k, state, work);
    unpack_walls(state, work);
    if (k.rolling_springs) work.rolling_Nm.assign(work.i.size(), 0.0);
    const auto left = [&](std::size_t p) { return has_left(state.discs.disc[p], state.pairs.inner_reference[p]); };
    for (std::size_t p = 0; p < state.discs.disc.size(); ++p)
        if (left(p)) return ask_for_lists(state, work);
}

}  // namespace ifedem
