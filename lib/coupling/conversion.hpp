#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coupling/soil_elements.hpp"
#include "dem/dem_workspace.hpp"
#include "model/state.hpp"

namespace ifedem {

// Soil that changes between elements and discs (sections 5.1.2–5.1.4). A conversion is first planned, as a pure
// function of model and state, into a list of edits that is plain data; then applied. Whoever wants to know what a
// conversion does reads the edit.

enum class ConversionKind : std::uint32_t { to_discs = 0, to_element = 1 };

/// A block whose turn it is.
struct DueConversion {
    ConversionKind kind = ConversionKind::to_discs;
    std::uint32_t block = 0;
};

/// The tyre's outermost vertical edges: 2* and 1* of Fig 5-1.
struct TyreEdges {
    double rear_x_m = 0, front_x_m = 0;
};

/// Columns of the top row that are discs, from `first` up to but without `last`; equal if there are none.
struct DiscColumns {
    std::uint32_t first = 0, last = 0;
};
[[nodiscard]] DiscColumns find_disc_columns(const SoilModel& model, const SoilState& soil);

/// The next block of the top row to convert by the tyre's place. In front: the first element, once 1* has passed the
/// edge that lies elements.margin_columns blocks before its near edge (0: the text's small region). Behind: the last
/// block of discs, once 2* has passed the edge as many blocks beyond its far one.
[[nodiscard]] std::optional<DueConversion> find_due_conversion(const SoilModel& model, const SoilState& soil,
                                                               const TyreEdges& tyre);

/// A disc that becomes part of an element's border.
struct Attachment {
    std::uint32_t position = 0;  ///< list position of the disc until now
    AttachedDisc disc;
    std::uint32_t from = 0, to = 0;  ///< nodes of its segment
};

/// Everything that a conversion changes.
struct ConversionEdit {
    ConversionKind kind = ConversionKind::to_discs;
    std::uint32_t block = 0;
    std::vector<Disc> add;              ///< discs to place
    std::vector<std::uint32_t> remove;  ///< list positions, ascending; the attached ones among them
    std::vector<Attachment> attach;
    ElementShape shape;                ///< stress-free shape of a new element
    double mass_kg = 0;                ///< of a new element
    std::array<Vec2, 4> position_m{};  ///< of the block's nodes afterwards
    std::array<Vec2, 4> velocity_m_s{};
    std::string refusal;  ///< why nothing can be done; empty: it can
};

/// Element → discs (5.1.2, 5.1.5): the block's pattern of discs, carried along by the area coordinates of the four
/// triangles between the element's corners and its centre (Eqs 5.1–5.3, Figs 5-2, 5-3). With stress handed over, the
/// pattern is first flattened or stretched upwards, by 3 % at most, until the mean σ_y of its contacts (Eq 5.10) is the
/// element's (a tenth of what the block's weight gives where the element has less or pulls), and its discs share the
/// element's mass in proportion to their own. Blocks that are discs from the beginning stand as prepared.
[[nodiscard]] ConversionEdit plan_to_discs(const SoilModel& model, const DemConstants& k, const SoilState& soil,
                                           std::uint32_t block);

/// Discs → element (5.1.3, 5.1.4). Nodes that neighbouring elements have stay where they are; a new one stands over
/// the node below it at the height of the discs' surface there: the mean of the middle two of four columns of width 2 R
/// (a thrown disc or a gap moves it little). Discs up to 3 R inside and R outside a border towards free discs are
/// attached, the rest of the block's are taken away. Refused where the four nodes do not make a sound quad. With stress
/// handed over, the new element's stress-free shape is such that it now has the mean stress of the discs' contacts, and
/// its mass is that of all discs taken away, attached ones included.
[[nodiscard]] ConversionEdit plan_to_element(const SoilModel& model, const DemConstants& k, const State& state,
                                             const SoilWorkspace& work, std::uint32_t block);

/// Carries an edit out: discs, lists, elements, skyline; springs of contacts that go on are kept. Not for refusals.
void apply_conversion(const ConversionEdit& edit, const SoilModel& model, const DemConstants& k, State& state,
                      DemWorkspace& dem, SoilWorkspace& work);

/// Height of a block's surface: between the top nodes of an element; of discs, the mean of the
/// middle two of the highest tops in four columns.
[[nodiscard]] double block_surface_m(const SoilModel& model, const State& state, std::uint32_t block);

}  // namespace ifedem
