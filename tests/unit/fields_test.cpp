// Mean stress of discs (Eq 5.10) for contacts whose arms are known.
#include "step/fields.hpp"

#include <gtest/gtest.h>

#include "core/bitmath.hpp"
#include "support/dem_scenes.hpp"

namespace ifedem {
namespace {

using namespace scene;

constexpr double overlap_m = 2e-4;

/// −r F / V of one contact whose normal is horizontal.
double pressure_Pa(const World& w, const Disc& d, double arm_m) {
    const double volume = pi * d.radius_m * d.radius_m * w.scene.c.soil.thickness_m;
    return arm_m * stiffness_N_m * overlap_m / volume;
}

TEST(DiscStress, of_an_unequal_pair_has_the_laws_arms) {
    constexpr double small = 0.001, large = 0.003, distance = small + large - overlap_m;
    World w = make_world(make_dem(make_contact(stiffness_N_m, 0.25 * stiffness_N_m, 0.5), 0, 1e-9),
                         {make_disc({0, 0}, small, 0.001), make_disc({distance, 0}, large, 0.009)});
    update_lists(w.scene.dem, w.state, w.work.dem);
    const auto stress = measure_stress(w.scene, w.state, w.work);
    const auto fields = measure_fields(w.scene, w.state, w.work);
    for (std::size_t p = 0; p < 2; ++p) {
        const Disc& d = w.state.discs.disc[p];
        const double expected = pressure_Pa(w, d, distance * d.radius_m / (small + large));
        EXPECT_NEAR(stress[p].x_Pa, -expected, 1e-9 * expected);
        EXPECT_NEAR(stress[p].y_Pa, 0, 1e-9 * expected);
        EXPECT_NEAR(static_cast<double>(fields.pressure_Pa[p]), 0.5 * expected, 1e-6 * expected);
    }
}

TEST(DiscStress, at_walls_reaches_to_the_foot_or_divides_the_distance) {
    constexpr double radius = 0.002, opposite = 0.003;
    for (const bool flat : {true, false}) {
        DemConstants k = make_dem(make_contact(stiffness_N_m, 0.25 * stiffness_N_m, 0.5), 0, 1e-9);
        if (flat)
            k.flat_walls = {{{radius - overlap_m, 0}, {-1, 0}}};
        else
            k.wall_discs = {{{radius + opposite - overlap_m, 0}, opposite}};
        World w = make_world(k, {make_disc({0, 0}, radius, 0.01)});
        update_lists(w.scene.dem, w.state, w.work.dem);
        const double arm = flat ? radius - overlap_m : (radius + opposite - overlap_m) * radius / (radius + opposite);
        const double expected = pressure_Pa(w, w.state.discs.disc[0], arm);
        EXPECT_NEAR(measure_stress(w.scene, w.state, w.work)[0].x_Pa, -expected, 1e-9 * expected) << flat;
    }
}

}  // namespace
}  // namespace ifedem
