#include "dem/blocks.hpp"

#include <algorithm>

namespace ifedem {
namespace {

/// What block `source` holds in `slot` for the disc at list position `target`.
struct Incoming {
    std::uint32_t slot = 0, target = 0, source = 0;
};

}  // namespace

void lay_out_blocks(const State& state, DemWorkspace& work) {
    const auto& p = state.pairs;
    const auto count = static_cast<std::uint32_t>(state.discs.disc.size());
    work.block.clear();
    std::vector<std::vector<Incoming>> incoming((count + discs_per_block - 1) / discs_per_block);
    std::vector<std::uint32_t> halo;
    std::uint32_t pair = 0, slot = 0;
    for (std::uint32_t begin = 0; begin < count; begin += discs_per_block) {
        Block b;
        b.first_source = static_cast<std::uint32_t>(work.block.size());
        b.disc_begin = begin, b.disc_end = std::min<std::uint32_t>(count, begin + discs_per_block);
        b.outer_begin = pair, b.force_begin = slot;
        halo.assign(1, b.disc_end - 1);  // the last own disc: no merge, but slots up to it in any case
        for (; pair < p.i.size() && p.i[pair] < b.disc_end; ++pair)
            if (p.j[pair] >= b.disc_end) halo.push_back(p.j[pair]);
        b.outer_end = pair;
        std::sort(halo.begin(), halo.end());
        halo.erase(std::unique(halo.begin(), halo.end()), halo.end());
        b.force_end = slot = b.slot(halo.back()) + 1;
        for (auto h = halo.begin() + 1; h != halo.end(); ++h)
            incoming[*h / discs_per_block].push_back({b.slot(*h), *h, b.first_source});
        work.block.push_back(b);
    }
    work.force.reserve(slot), work.force.resize(slot);  // by itself it would take twice as much
    work.merge.clear();
    for (std::size_t n = 0; n < work.block.size(); ++n) {
        Block& b = work.block[n];
        b.merge_begin = static_cast<std::uint32_t>(work.merge.size());
        for (const Incoming& m : incoming[n]) {
            b.first_source = std::min(b.first_source, m.source);
            work.merge.push_back({m.slot, b.slot(m.target)});
        }
        b.merge_end = static_cast<std::uint32_t>(work.merge.size());
    }
}

}  // namespace ifedem
