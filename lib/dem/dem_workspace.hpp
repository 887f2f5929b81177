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

/// A range of discs with the pairs that they own (as the lower list position) and where their forces go.
struct Block {
    std::uint32_t disc_begin = 0, disc_end = 0;
    std::uint32_t outer_begin = 0, outer_end = 0;  ///< into the outer list
    std::uint32_t pair_begin = 0, pair_end = 0;    ///< into the inner list
    std::uint32_t wall_begin = 0, wall_end = 0;    ///< into the discs near walls
    std::uint32_t halo_begin = 0, halo_end = 0;  ///< into the halos: discs behind its own, to the last that it reaches
    std::uint32_t merge_begin = 0, merge_end = 0;  ///< into Merge: what earlier blocks hold for this one
    std::uint32_t first_source = 0;                ///< the first block whose pairs reach into this one, or itself
    bool moved = false;                            ///< a disc has left its inner skin in this step
    std::uint32_t calm_steps = 0;                  ///< so many steps none can leave it,
    double calm_m_s = 0;                           ///< unless one is faster than this

    [[nodiscard]] std::uint32_t size() const { return disc_end - disc_begin; }
};

/// "Add the force in the halos at `halo` to that of the disc at the list position `target`."
struct Merge {
    std::uint32_t halo = 0, target = 0;
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
    std::vector<DiscForce> halo;                       ///< what each block's pairs do to discs of later blocks
    std::size_t slots = 0;                             ///< that a thread needs,
    std::vector<std::vector<DiscForce>> thread_force;  ///< for the blocks that it works at: 0 between steps
    bool keep_forces = false;
    std::vector<DiscForce> kept_force;    ///< if they are kept: the last sums, by list position
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
