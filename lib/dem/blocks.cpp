#include "dem/blocks.hpp"

#include <algorithm>

#include "dem/dem_constants.hpp"

namespace ifedem {

void lay_out_blocks(const State& state, DemWorkspace& work) {
    const auto& p = state.pairs;
    const auto count = static_cast<std::uint32_t>(state.discs.disc.size());
    work.block.clear();
    work.outer_slot_j.resize(p.i.size());
    work.force_slot.resize(count);
    std::vector<std::vector<Merge>> incoming((count + discs_per_block - 1) / discs_per_block);
    std::vector<std::uint32_t> first_source(incoming.size(), count);
    std::vector<std::uint32_t> slot_of_halo(count);  // of the present block
    std::vector<std::uint32_t> halo;
    std::uint32_t pair = 0, slot = 0;
    for (std::uint32_t begin = 0; begin < count; begin += discs_per_block) {
        Block b;
        b.disc_begin = begin, b.disc_end = std::min<std::uint32_t>(count, begin + discs_per_block);
        b.outer_begin = pair, b.force_begin = slot;
        halo.clear();
        for (; pair < p.i.size() && p.i[pair] < b.disc_end; ++pair)
            if (p.j[pair] >= b.disc_end) halo.push_back(p.j[pair]);
        b.outer_end = pair;
        std::sort(halo.begin(), halo.end());
        halo.erase(std::unique(halo.begin(), halo.end()), halo.end());
        for (std::uint32_t d = b.disc_begin; d < b.disc_end; ++d) work.force_slot[d] = slot++;
        for (const std::uint32_t h : halo) {
            slot_of_halo[h] = slot++;
            incoming[h / discs_per_block].push_back({slot_of_halo[h], h});
            auto& first = first_source[h / discs_per_block];
            first = std::min(first, static_cast<std::uint32_t>(work.block.size()));
        }
        b.force_end = slot;
        for (std::uint32_t n = b.outer_begin; n < b.outer_end; ++n) {
            work.outer_slot_j[n] = p.j[n] < b.disc_end ? work.force_slot[p.j[n]] : slot_of_halo[p.j[n]];
        }
        work.block.push_back(b);
    }
    work.force.resize(slot);
    work.merge.clear();
    for (std::size_t n = 0; n < work.block.size(); ++n) {
        Block& b = work.block[n];
        b.first_source = std::min(first_source[n], static_cast<std::uint32_t>(n));
        b.merge_begin = static_cast<std::uint32_t>(work.merge.size());
        for (const Merge& m : incoming[n]) work.merge.push_back({m.slot, work.force_slot[m.target]});
        b.merge_end = static_cast<std::uint32_t>(work.merge.size());
    }
}

}  // namespace ifedem
