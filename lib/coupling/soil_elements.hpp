#pragma once
#include <cstdint>
#include <vector>

#include "coupling/attached_discs.hpp"
#include "coupling/surface_contact.hpp"
#include "fem/elements.hpp"
#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// The soil's elements (chapter 5): what is constant about them. The grid has `columns` × `rows` rectangular blocks
/// between the side walls, each an element or, in the top row, a place for discs.
struct SoilModel {
    ElementsCase c;
    std::uint32_t columns = 0, rows = 0;  ///< 0: a scene without soil elements
    double thickness_m = 0;
    Material material;
    ContactConstants contact;  ///< of discs with the elements' boundary
    Vec2 gravity_m_s2;

    [[nodiscard]] std::uint32_t node(std::uint32_t i, std::uint32_t j) const { return j * (columns + 1) + i; }
    [[nodiscard]] std::uint32_t block(std::uint32_t i, std::uint32_t j) const { return j * columns + i; }
    [[nodiscard]] std::array<std::uint32_t, 4> nodes_of(std::uint32_t block) const {
        const std::uint32_t i = block % columns, j = block / columns;
        return {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)};
    }
};

/// `friction` differs between consolidation and the later stages, as the walls' does.
[[nodiscard]] SoilModel make_soil_model(const Case& c, const DemConstants& dem, double friction);

/// The grid at rest and free of stress; elements.disc_columns blocks of the top row are discs' places.
[[nodiscard]] SoilState place_soil(const SoilModel& model);

/// A node of the soil: its share of the elements' mass and what holds it. The floor is rough (both directions held),
/// the side walls are smooth.
struct SoilNode {
    std::uint32_t number = 0;
    double mass_kg = 0;
    double damping_kg_s = 0;
    bool held_x = false, held_y = false;
};

/// What a step needs of the elements that are there now; made from the state at the start and after each conversion.
struct SoilWorkspace : SurfaceWorkspace {
    ElementSet elements;               ///< of the blocks that are elements, in order of their numbers
    std::vector<std::uint32_t> block;  ///< the number of each
    std::vector<SoilNode> node;        ///< those with an element, ascending
    AttachedWorkspace attached;
    Surface edge;                      ///< skyline of the elements from the right wall to the left one
    std::vector<Vec2> force_N;         ///< per node of the grid: everything
    std::vector<WheelForce> on_discs;  ///< scratch: this step's, then merged into those of the wheel
    std::vector<WheelForce> merged;    ///< scratch
};

void attach_soil_workspace(const SoilModel& model, const SoilState& soil, SoilWorkspace& work);

/// Contact forces between discs and soil elements, attached discs included: for the discs joined to dem.wheel_force,
/// for the elements' nodes in work.contact_force_N. See add_surface_contacts().
void add_soil_contacts(const DemConstants& k, const SoilModel& model, State& state, DemWorkspace& dem,
                       SoilWorkspace& work, double spring_step_s);

/// Contact, internal and gravity forces of every node in work.force_N.
void add_soil_forces(const SoilModel& model, const SoilState& soil, SoilWorkspace& work);

/// Σ mass × velocity over the nodes.
[[nodiscard]] Vec2 momentum_Ns(const SoilWorkspace& work, const SoilState& soil);

}  // namespace ifedem
