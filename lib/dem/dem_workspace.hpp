#pragma once
#include <cstdint>
#include <vector>

#include "dem/contact_law.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Force on a disc as the pair loop adds it up: 32 bytes.
struct alignas(32) DiscForce {
    double x_N = 0;
    double turning_N = 0;  ///< moment of the tangential forces over the radius, counter-clockwise
    double y_N = 0;
    double rolling_Nm = 0;  ///< Σ of Eq 2.18's limits, ≥ 0; of DemConstants::rolling_springs: their moment
};

/// A range of discs with the pairs that they own (as the lower list position) and the force slots they write to.
struct Block {
    std::uint32_t disc_begin = 0, disc_end = 0;
    std::uint32_t outer_begin = 0, outer_end = 0;  ///< into the outer list
    std::uint32_t pair_begin = 0, pair_end = 0;    ///< into the inner list
    std::uint32_t wall_begin = 0, wall_end = 0;    ///< into the discs near walls
    std::uint32_t force_begin = 0, force_end = 0;  ///< slots of its discs, and on to the last that its pairs reach
    std::uint32_t merge_begin = 0, merge_end = 0;  ///< into Merge: what earlier blocks hold for this one
    std::uint32_t first_source = 0;                ///< the first block whose pairs reach into this one, or itself
    bool moved = false;                            ///< a disc has left its inner skin in this step
    std::uint32_t calm_steps = 0;                  ///< so many steps none can leave it,
    double calm_m_s = 0;                           ///< unless one is faster than this

    /// Force slot of the disc at a list position, as far as the block's slots go.
    [[nodiscard]] std::uint32_t slot(std::uint32_t position) const { return position - disc_begin + force_begin; }
};

/// "Add force slot `slot` to that of this block's disc `target`."
struct Merge {
    std::uint32_t slot = 0, target = 0;
};

/// What the wheel does to a disc.
struct WheelForce {
    std::uint32_t position = 0;
    DiscForce on_disc;
};

/// A disc close enough to a wall to touch it before the next refresh, or rebuild.
struct WallCandidate {
    std::uint32_t position = 0;  ///< list position of the disc
    std::uint32_t wall = 0;      ///< flat wall, or wall disc
};

/// Everything that a step needs and that can be made from State alone; never saved.
struct DemWorkspace {
    int vector_width = 1;  ///< of the instructions that may be used
    void (*pair_kernel)(const ContactConstants&, const struct PairBatch&) = nullptr;  ///< see vector_width.hpp
    std::vector<Block> block;
    // Inner pairs, unpacked for the pair loop.
    std::vector<std::uint32_t> i, j;  ///< list positions
    std::vector<double> damping_Ns_m;
    std::vector<double> rolling_Nm;  ///< of DemConstants::rolling_springs, else empty
    std::vector<Merge> merge;
    std::vector<DiscForce> force;         ///< all blocks' slots
    std::vector<double> spin_per_moment;  ///< per disc: Δt/I, I = m r²/2
    std::vector<std::uint32_t> position_of_id;
    std::vector<WallCandidate> wall;      ///< as State::wall_contacts, with positions
    std::vector<WheelForce> wheel_force;  ///< of this step, sorted by position
    // As State's outer pairs: what a refresh copies into the arrays above.
    std::vector<WallCandidate> outer_wall;
    // Scratch of a refresh.
    std::vector<std::uint32_t> next_inner;
    std::vector<double> next_rolling_Nm;
    std::vector<double> block_spring;  ///< of one block, by outer pair
    std::vector<BoundaryContact> next_wall;
    bool refresh_inner = true;
    bool rebuild_outer = true;
    std::uint64_t rebuilds = 0, refreshes = 0;  ///< for the account of costs only
};

}  // namespace ifedem
