#pragma once
#include <cstdint>
#include <vector>

#include "dem/contact_law.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Force on a disc as the pair loop adds it up: 32 bytes.
struct DiscForce {
    double x_N = 0, y_N = 0;
    double moment_Nm = 0;         ///< of the tangential forces, counter-clockwise
    double rolling_limit_Nm = 0;  ///< Σ of Eq 2.18 over the disc's contacts, ≥ 0
};

/// A range of discs with the pairs that they own (as the lower list position) and the force slots they write to.
struct Block {
    std::uint32_t disc_begin = 0, disc_end = 0;
    std::uint32_t pair_begin = 0, pair_end = 0;    ///< into the inner list
    std::uint32_t force_begin = 0, force_end = 0;  ///< own discs first, then the discs of later blocks that pairs reach
    std::uint32_t merge_begin = 0, merge_end = 0;  ///< into Merge: what earlier blocks hold for this one
};

/// "Add force slot `slot` to that of this block's disc `target`."
struct Merge {
    std::uint32_t slot = 0, target = 0;
};

/// A disc close enough to a wall to touch it before the next refresh.
struct WallCandidate {
    std::uint32_t position = 0;  ///< list position of the disc
    std::uint32_t wall = 0;      ///< flat wall, or wall disc
};

/// Everything that a step needs and that can be made from State alone; never saved.
struct DemWorkspace {
    void (*pair_kernel)(const ContactConstants&, const struct PairBatch&) = nullptr;  ///< see vector_width.hpp
    std::vector<Block> block;
    // Inner pairs, unpacked for the pair loop.
    std::vector<std::uint32_t> i, j;            ///< list positions
    std::vector<std::uint32_t> slot_i, slot_j;  ///< force slots
    std::vector<double> damping_Ns_m;
    std::vector<Merge> merge;
    std::vector<DiscForce> force;            ///< all blocks' slots
    std::vector<std::uint32_t> force_slot;   ///< per disc: its own slot
    std::vector<double> outer_damping_Ns_m;  ///< as State's outer pairs
    std::vector<double> spin_per_moment;     ///< per disc: Δt/I, I = m r²/2
    std::vector<std::uint32_t> position_of_id;
    std::vector<WallCandidate> wall;        ///< as State::wall_contacts, with positions
    std::vector<std::uint8_t> block_moved;  ///< per block: a disc has left its inner skin
    bool refresh_inner = true;
    bool rebuild_outer = true;
    std::uint64_t rebuilds = 0, refreshes = 0;  ///< for the account of costs only
};

}  // namespace ifedem
