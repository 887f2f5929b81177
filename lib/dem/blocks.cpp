#include "dem/blocks.hpp"

#include <algorithm>

namespace ifedem {
namespace {

/// What block `source` holds at `halo` for the disc at list position `target`.
struct Incoming {
    std::uint32_t halo = 0, target = 0, source = 0;
};

}  // namespace

void lay_out_blocks(const State& state, DemWorkspace& work) {
    const auto& p = state.pairs;
    const auto count = static_cast<std::uint32_t>(state.discs.disc.size());
    work.block.clear();
    std::vector<std::vector<Incoming>> incoming((count + discs_per_block - 1) / discs_per_block);
    std::vector<std::uint32_t> reached;
    std::uint32_t pair = 0, halo = 0, longest_halo = 0;
    for (std::uint32_t begin = 0; begin < count; begin += discs_per_block) {
        Block b;
        b.first_source = static_cast<std::uint32_t>(work.block.size());
        b.disc_begin = begin, b.disc_end = std::min<std::uint32_t>(count, begin + discs_per_block);
        b.outer_begin = pair, b.halo_begin = halo;
        reached.clear();
        for (; pair < p.i.size() && p.i[pair] < b.disc_end; ++pair)
            if (p.j[pair] >= b.disc_end) reached.push_back(p.j[pair]);
        b.outer_end = pair;
        std::sort(reached.begin(), reached.end());
        reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
        for (const std::uint32_t position : reached)
            incoming[position / discs_per_block].push_back({halo + position - b.disc_end, position, b.first_source});
        if (!reached.empty()) halo += reached.back() + 1 - b.disc_end;
        b.halo_end = halo;
        longest_halo = std::max(longest_halo, b.halo_end - b.halo_begin);
        work.block.push_back(b);
    }
    work.halo.resize(halo);
    work.merge.clear();
    std::uint32_t most_waiting = 0;
    for (std::size_t n = 0; n < work.block.size(); ++n) {
        Block& b = work.block[n];
        b.merge_begin = static_cast<std::uint32_t>(work.merge.size());
        for (const Incoming& m : incoming[n]) {
            b.first_source = std::min(b.first_source, m.source);
            work.merge.push_back({m.halo, m.target});
        }
        b.merge_end = static_cast<std::uint32_t>(work.merge.size());
        most_waiting = std::max(most_waiting, static_cast<std::uint32_t>(n) - b.first_source);
    }
    work.slots = (most_waiting + 1) * discs_per_block + longest_halo;
}

}  // namespace ifedem
