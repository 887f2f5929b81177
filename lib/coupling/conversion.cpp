#include "coupling/conversion.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "coupling/stress_handover.hpp"
#include "dem/edit_discs.hpp"
#include "fem/corotation.hpp"

namespace ifedem {
namespace {

constexpr std::size_t bottom_left = 0, bottom_right = 1, top_right = 2, top_left = 3;

bool is_element(const SoilModel& model, const SoilState& soil, std::uint32_t i, std::uint32_t j) {
    return soil.kind[model.block(i, j)] == BlockKind::element;
}

/// The highest disc top in each of four columns, ascending; `lowest_m` for a column without discs. `column_of` a disc's
/// x is from 0 up to but without 4 in the columns.
template <class ColumnOf>
std::array<double, 4> find_column_tops_m(const std::vector<Disc>& discs, double lowest_m, ColumnOf&& column_of) {
    std::array<double, 4> top;
    top.fill(lowest_m);
    for (const Disc& d : discs) {
        const double at = column_of(d.x_m);
        if (!(at >= 0 && at < 4)) continue;
        double& t = top[static_cast<std::size_t>(at)];
        t = max_of(t, d.y_m + d.radius_m);
    }
    std::sort(top.begin(), top.end());
    return top;
}

/// The middle two of four columns of width 2 R about x; of the upper two beside a wall or an element.
double surface_height_m(const std::vector<Disc>& discs, double x_m, double radius_m, double lowest_m) {
    const auto top = find_column_tops_m(discs, lowest_m, [&](double x) { return (x - x_m) / (2 * radius_m) + 2; });
    const bool beside = top[0] <= lowest_m && top[1] <= lowest_m;
    return beside ? 0.5 * (top[2] + top[3]) : 0.5 * (top[1] + top[2]);
}

/// A border of a new element: a directed segment with the element on its left.
struct Border {
    std::uint32_t from = 0, to = 0;  ///< nodes
    Segment line;
    bool open = false;  ///< discs lie beyond it

    [[nodiscard]] double inside_m(Vec2 p) const { return -dot(p - line.from_m, line.normal); }
};

Border make_border(std::uint32_t from, std::uint32_t to, Vec2 from_m, Vec2 to_m, bool open) {
    Border b{from, to, {}, open};
    b.line.from_m = from_m, b.line.along_m = to_m - from_m;
    const double length = norm(b.line.along_m);
    b.line.inverse_length2 = 1.0 / (length * length);
    b.line.normal = {b.line.along_m.y / length, -b.line.along_m.x / length};
    return b;
}

std::vector<Border> find_borders(const SoilModel& model, const SoilState& soil, const ConversionEdit& edit) {
    const std::uint32_t i = edit.block % model.columns, j = edit.block / model.columns;
    const auto node = model.nodes_of(edit.block);
    const bool open_right = i + 1 < model.columns && !is_element(model, soil, i + 1, j);
    const bool open_left = i > 0 && !is_element(model, soil, i - 1, j);
    const auto border = [&](std::size_t from, std::size_t to, bool open) {
        return make_border(node[from], node[to], edit.position_m[from], edit.position_m[to], open);
    };
    return {border(bottom_right, top_right, open_right), border(top_right, top_left, true),
            border(top_left, bottom_left, open_left), border(bottom_left, bottom_right, false)};
}

/// The open border that lies nearest to a point.
const Border& nearest_open(const std::vector<Border>& borders, Vec2 p) {
    const Border* nearest = nullptr;
    for (const Border& b : borders)
        if (b.open && (nearest == nullptr || std::fabs(b.inside_m(p)) < std::fabs(nearest->inside_m(p)))) nearest = &b;
    return *nearest;  // the top is always open
}

/// Fig 5-4: which discs go, and which of them are attached.
void choose_discs(const DiscState& discs, const std::vector<Border>& borders, double radius_m, ConversionEdit& edit) {
    for (std::uint32_t p = 0; p < discs.disc.size(); ++p) {
        const Disc& d = discs.disc[p];
        const Vec2 centre{d.x_m, d.y_m};
        bool concerned = true;
        for (const Border& b : borders) {
            // Beyond a border shared with an element lies that element's own surface.
            concerned = concerned && b.inside_m(centre) > (b.open ? -radius_m : 0.0);
        }
        if (!concerned) continue;
        edit.remove.push_back(p);
        const Border& border = nearest_open(borders, centre);
        if (border.inside_m(centre) >= 3 * radius_m) continue;
        const double share = min_of(1.0, max_of(0.0, share_along(border.line, centre)));
        const Vec2 offset = centre - (border.line.from_m + share * border.line.along_m);
        edit.attach.push_back({p, {share, offset.x, offset.y, d.radius_m}, border.from, border.to});
    }
}

/// The new element's mass and velocities: new nodes move with the discs that they replace; at nodes that stay, the
/// momentum of old and new mass adds up.
void choose_motion(const SoilModel& model, const State& state, const SoilWorkspace& work,
                   const std::array<bool, 4>& is_new, ConversionEdit& edit) {
    Vec2 momentum;
    double mass = 0;
    for (const std::uint32_t p : edit.remove) {
        const Disc& d = state.discs.disc[p];
        momentum += (1.0 / d.inverse_mass_1_kg) * Vec2{d.vx_m_s, d.vy_m_s};
        mass += 1.0 / d.inverse_mass_1_kg;
    }
    const Vec2 mean = mass > 0 ? (1.0 / mass) * momentum : Vec2{};
    const double area = quad_area_m2(edit.position_m);
    const bool hand_over = model.c.stress_handover == StressHandover::mean;
    edit.mass_kg = hand_over ? mass : model.material.density_kg_m3 * model.thickness_m * area;
    const double quarter = 0.25 * edit.mass_kg;
    const auto node = model.nodes_of(edit.block);
    for (std::size_t a = 0; a < 4; ++a) {
        const double old = is_new[a] ? 0.0 : work.elements.mass_kg[node[a]];
        edit.velocity_m_s[a] = (1.0 / (old + quarter)) * (old * state.soil.velocity_m_s[node[a]] + quarter * mean);
    }
}

/// Springs between a disc that stays and one that is attached go on as contacts with the attached one; the sign of a
/// spring is the same seen from either disc.
std::vector<BoundaryContact> inherit_springs(const ConversionEdit& edit, const State& state, std::size_t first_new) {
    std::map<std::uint32_t, std::uint32_t> attached_at;
    for (std::size_t n = 0; n < edit.attach.size(); ++n)
        attached_at[edit.attach[n].position] = static_cast<std::uint32_t>(first_new + n);
    std::vector<char> removed(state.discs.disc.size(), 0);
    for (const std::uint32_t p : edit.remove) removed[p] = 1;
    std::vector<BoundaryContact> contacts;
    const PairState& pairs = state.pairs;
    for (std::size_t n = 0; n < pairs.inner.size(); ++n) {
        std::uint32_t stays = pairs.i[pairs.inner[n]], goes = pairs.j[pairs.inner[n]];
        if (removed[stays] != 0) std::swap(stays, goes);
        const auto at = attached_at.find(goes);
        if (removed[stays] != 0 || at == attached_at.end() || pairs.tangential_m[n] == 0) continue;
        contacts.push_back({state.discs.id[stays], at->second, pairs.tangential_m[n]});
    }
    return contacts;
}

/// Discs attached to a block that turns back into discs go with it.
void drop_attached(std::uint32_t block, SoilState& soil) {
    std::vector<std::uint32_t> new_number;
    std::uint32_t kept = 0;
    for (std::uint32_t n = 0; n < soil.attached.size(); ++n) {
        const bool stays = soil.attached_block[n] != block;
        new_number.push_back(stays ? kept : SurfaceEdge::none);
        if (!stays) continue;
        soil.attached[kept] = soil.attached[n];
        soil.attached_from[kept] = soil.attached_from[n], soil.attached_to[kept] = soil.attached_to[n];
        soil.attached_block[kept++] = soil.attached_block[n];
    }
    soil.attached.resize(kept);
    soil.attached_from.resize(kept), soil.attached_to.resize(kept), soil.attached_block.resize(kept);
    std::erase_if(soil.attached_contacts,
                  [&](const BoundaryContact& c) { return new_number[c.surface] == SurfaceEdge::none; });
    for (BoundaryContact& c : soil.attached_contacts) c.surface = new_number[c.surface];
}

/// Contacts with segments that are still there keep their springs under the segment's new number.
void renumber_contacts(const Surface& before, const Surface& after, std::vector<BoundaryContact>& contacts) {
    const auto number_of = [&](const SurfaceEdge& e) {
        for (std::uint32_t k = 0; k < after.size(); ++k)
            if (after[k].from == e.from && after[k].to == e.to) return k;
        return SurfaceEdge::none;
    };
    for (BoundaryContact& c : contacts) c.surface = number_of(before[c.surface]);
    std::erase_if(contacts, [](const BoundaryContact& c) { return c.surface == SurfaceEdge::none; });
}

}  // namespace

DiscColumns find_disc_columns(const SoilModel& model, const SoilState& soil) {
    const std::uint32_t j = model.rows - 1;
    std::uint32_t first = 0;
    while (first < model.columns && is_element(model, soil, first, j)) ++first;
    std::uint32_t last = first;
    while (last < model.columns && !is_element(model, soil, last, j)) ++last;
    return {first, last};
}

std::optional<DueConversion> find_due_conversion(const SoilModel& model, const SoilState& soil, const TyreEdges& tyre) {
    const std::uint32_t j = model.rows - 1;
    const auto [first, last] = find_disc_columns(model, soil);
    const double length = model.c.block_length_m;
    const auto margin = static_cast<double>(model.c.margin_columns);
    if (first == last) return std::nullopt;
    if (last < model.columns && tyre.front_x_m > (last - margin) * length)
        return DueConversion{ConversionKind::to_discs, model.block(last, j)};
    if (last - first > 1 && tyre.rear_x_m > (first + 1 + margin) * length)
        return DueConversion{ConversionKind::to_element, model.block(first, j)};
    return std::nullopt;
}

ConversionEdit plan_to_discs(const SoilModel& model, const DemConstants& k, const SoilState& soil,
                             std::uint32_t block) {
    ConversionEdit edit;
    edit.kind = ConversionKind::to_discs;
    edit.block = block;
    const BlockCorners corners = find_corners(model, soil, block);
    edit.position_m = corners.position_m, edit.velocity_m_s = corners.velocity_m_s;
    // Blocks that are discs from the beginning stand as prepared and have their own mass.
    const bool hand_over = model.c.stress_handover == StressHandover::mean && soil.kind[block] == BlockKind::element;
    const double squash = hand_over ? find_squash(model, k, soil, corners, wanted_stress_Pa(model, soil, block)) : 0.0;
    edit.add = place_pattern(model, soil, corners, squash);
    if (hand_over) share_mass(soil.mass_kg[block], edit.add);
    return edit;
}

ConversionEdit plan_to_element(const SoilModel& model, const DemConstants& k, const State& state,
                               const SoilWorkspace& work, std::uint32_t block) {
    const double largest_radius_m = k.largest_radius_m;
    ConversionEdit edit;
    edit.kind = ConversionKind::to_element;
    edit.block = block;
    const auto node = model.nodes_of(block);
    std::array<bool, 4> is_new{};
    for (std::size_t a = 0; a < 4; ++a) {
        is_new[a] = !(work.elements.mass_kg[node[a]] > 0);
        edit.position_m[a] = state.soil.position_m[node[a]];
    }
    for (const auto& [top, below] : {std::pair{top_right, bottom_right}, std::pair{top_left, bottom_left}}) {
        if (!is_new[top]) continue;
        const Vec2 foot = edit.position_m[below];
        edit.position_m[top] = {foot.x, surface_height_m(state.discs.disc, foot.x, largest_radius_m, foot.y)};
        if (!(edit.position_m[top].y - foot.y >= 0.25 * model.c.block_height_m))
            edit.refusal = "the rut leaves less than a quarter of the block's height";
    }
    const double whole = model.c.block_length_m * model.c.block_height_m;
    if (!(smallest_corner_jacobian_m2(edit.position_m) >= 0.25 * whole))
        edit.refusal = "the surface makes no sound quad (a corner has less than a quarter of the block's area)";
    if (!edit.refusal.empty()) return edit;
    edit.shape.corner_m = edit.position_m;  // stress-free where it stands (section 5.1.3)
    choose_discs(state.discs, find_borders(model, state.soil, edit), largest_radius_m, edit);
    choose_motion(model, state, work, is_new, edit);
    if (model.c.stress_handover == StressHandover::mean) {
        const double volume = quad_area_m2(edit.position_m) * model.thickness_m;
        edit.shape = relax(model.material, edit.position_m, mean_stress_Pa(k, state, edit.remove, volume));
    }
    return edit;
}

void apply_conversion(const ConversionEdit& edit, const SoilModel& model, const DemConstants& k, State& state,
                      DemWorkspace& dem, SoilWorkspace& work) {
    SoilState& soil = state.soil;
    const bool to_discs = edit.kind == ConversionKind::to_discs;
    const auto node = model.nodes_of(edit.block);
    for (std::size_t a = 0; a < 4; ++a) {
        soil.position_m[node[a]] = edit.position_m[a];
        soil.velocity_m_s[node[a]] = edit.velocity_m_s[a];
    }
    soil.kind[edit.block] = to_discs ? BlockKind::discs : BlockKind::element;
    if (to_discs) drop_attached(edit.block, soil);
    if (!soil.mass_kg.empty()) soil.mass_kg[edit.block] = to_discs ? 0 : edit.mass_kg;
    if (!to_discs) {
        soil.shape[edit.block] = edit.shape;
        const std::vector<BoundaryContact> springs = inherit_springs(edit, state, soil.attached.size());
        soil.attached_contacts.insert(soil.attached_contacts.end(), springs.begin(), springs.end());
        for (const Attachment& a : edit.attach) {
            soil.attached.push_back(a.disc);
            soil.attached_from.push_back(a.from), soil.attached_to.push_back(a.to);
            soil.attached_block.push_back(edit.block);
        }
    }
    const Surface before = work.edge;
    attach_soil_workspace(model, soil, work);
    renumber_contacts(before, work.edge, soil.contacts);
    edit_discs(k, edit.remove, edit.add, state, dem);  // sorts all contacts by the discs' new places
}

double block_surface_m(const SoilModel& model, const State& state, std::uint32_t block) {
    const std::array<Vec2, 4> corner = find_corners(model, state.soil, block).position_m;
    if (state.soil.kind[block] == BlockKind::element) return 0.5 * (corner[top_right].y + corner[top_left].y);
    const double left = corner[bottom_left].x, width = corner[bottom_right].x - left;
    const auto top = find_column_tops_m(state.discs.disc, 0, [&](double x) { return (x - left) / width * 4; });
    return 0.5 * (top[1] + top[2]);
}

}  // namespace ifedem
