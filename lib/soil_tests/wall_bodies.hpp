#pragma once
#include <cstdint>
#include <vector>

#include "soil_tests/world.hpp"

namespace ifedem {

/// Sand between rigid bodies of wall discs that move without turning: a shear box, a plate.
///
/// Contacts see the bodies' velocities: a lid carries the sand along that it drags. As in Sample, lists are made with
/// the walls closer by `margin_m` (their discs larger) and made anew before a body has gone that far.
class WallBodies {
public:
    static constexpr double margin_m = 3e-4;

    /// `body[w]` is the body of wall disc w of `dem`.
    WallBodies(const DemConstants& dem, std::vector<Disc> discs, std::vector<std::uint32_t> body);

    /// One more wall disc; contacts keep their springs.
    void add(const WallDisc& wall, std::uint32_t body);
    /// From here on wall disc `wall` goes with another body.
    void assign(std::size_t wall, std::uint32_t body) { body_[wall] = body; }
    void set_velocity(std::uint32_t body, Vec2 velocity_m_s);
    void set_friction(double soil, double wall);

    void step();
    void advance(std::int64_t steps);

    /// What the sand did to a body in the last step.
    [[nodiscard]] Vec2 force_N(std::uint32_t body) const { return force_N_[body]; }
    [[nodiscard]] const SoilWorld& world() const { return world_; }

private:
    void measure();

    SoilWorld world_;
    std::vector<std::uint32_t> body_;
    std::vector<Vec2> velocity_m_s_, force_N_;
    double moved_m_ = 0;  ///< since the last rebuild, of the fastest body
};

}  // namespace ifedem
