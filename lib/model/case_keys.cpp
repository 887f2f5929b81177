#include "model/case_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ifedem {
namespace {

// The words of each choice, in the order of its enumerators.
using Words = std::span<const std::string_view>;
constexpr std::string_view integrator_words[] = {"symplectic-euler", "modified-euler-one", "modified-euler-two"};
constexpr std::string_view contact_end_words[] = {"no-attraction", "attraction"};
constexpr std::string_view rolling_scheme_words[] = {"limit", "sign"};
constexpr std::string_view rolling_chord_words[] = {"full", "half"};
constexpr std::string_view wall_words[] = {"flat", "discs"};
constexpr std::string_view shape_words[] = {"round", "plate"};
constexpr std::string_view body_words[] = {"rigid", "rigid-rim", "elastic"};
constexpr std::string_view damping_frame_words[] = {"rigid-motion", "absolute"};
constexpr std::string_view slip_radius_words[] = {"tread", "lug-tip"};
constexpr std::string_view speed_words[] = {"hub", "tread"};
constexpr std::string_view control_words[] = {"semi-implicit", "explicit", "prescribed"};
constexpr std::string_view plane_words[] = {"stress", "strain"};
constexpr std::string_view region_words[] = {"position", "adaptive"};
constexpr std::string_view handover_words[] = {"none", "mean"};
constexpr std::string_view final_stress_words[] = {"skip", "write"};

constexpr Words words_of(Integrator) { return integrator_words; }
constexpr Words words_of(ContactEnd) { return contact_end_words; }
constexpr Words words_of(RollingScheme) { return rolling_scheme_words; }
constexpr Words words_of(RollingChord) { return rolling_chord_words; }
constexpr Words words_of(WallKind) { return wall_words; }
constexpr Words words_of(WheelShape) { return shape_words; }
constexpr Words words_of(WheelBody) { return body_words; }
constexpr Words words_of(DampingFrame) { return damping_frame_words; }
constexpr Words words_of(SlipRadius) { return slip_radius_words; }
constexpr Words words_of(SpeedOf) { return speed_words; }
constexpr Words words_of(ControlScheme) { return control_words; }
constexpr Words words_of(PlaneState) { return plane_words; }
constexpr Words words_of(RegionRule) { return region_words; }
constexpr Words words_of(StressHandover) { return handover_words; }
constexpr Words words_of(FinalStress) { return final_stress_words; }

template <class T>
Slot slot_of(T& member) {
    if constexpr (std::is_enum_v<T>) {
        return ChoiceSlot{&member, [](const void* m) { return static_cast<int>(*static_cast<const T*>(m)); },
                          [](void* m, int index) { *static_cast<T*>(m) = static_cast<T>(index); }, words_of(T{})};
    } else {
        return &member;
    }
}

constexpr Range any{};  // words
constexpr Range above_zero(double high) { return {0, high, false, true}; }
constexpr Range from_zero(double high) { return {0, high, true, true}; }
constexpr Range whole(double low, double high) { return {low, high, true, true}; }
constexpr Range poisson{-1, 0.5, false, false};

// The one spelling of a key is its member's, so a macro: name and member cannot part.
// NOLINTBEGIN(bugprone-macro-parentheses): names of members cannot stand in parentheses
#define IFEDEM_NAMED_KEY(name, unit, range, meaning, member)                          \
    Key {                                                                             \
        name, unit, range, meaning, [](Case& c) -> Slot { return slot_of(c.member); } \
    }
#define IFEDEM_KEY(member, unit, range, meaning) IFEDEM_NAMED_KEY(#member, unit, range, meaning, member)
#define IFEDEM_MATERIAL(member, part)                                                   \
    IFEDEM_KEY(member.young_Pa, "Pa", above_zero(1e15), "Young's modulus of " part),    \
        IFEDEM_KEY(member.poisson, "-", poisson, "Poisson's ratio of " part),           \
        IFEDEM_KEY(member.density_kg_m3, "kg/m³", above_zero(1e6), "density of " part), \
        IFEDEM_KEY(member.damping_1_s, "1/s", from_zero(1e6), "damping per unit mass (Eq 2.3) of " part)
// NOLINTEND(bugprone-macro-parentheses)

constexpr std::array keys{
    IFEDEM_KEY(name, "", any, "names the case in reports"),
    IFEDEM_KEY(gravity_m_s2, "m/s²", from_zero(1e3), "gravity, downward"),
    IFEDEM_KEY(time_step_s, "s", above_zero(1), "step of all three stages"),
    IFEDEM_KEY(integrator, "", any, "how discs are moved; modified Euler is Eqs 2.9-2.12"),

    IFEDEM_KEY(soil.radii_m, "m", above_zero(10), "radii of the discs"),
    IFEDEM_KEY(soil.radii_shares, "-", above_zero(1e9), "how many discs of each radius, relative to each other"),
    IFEDEM_KEY(soil.density_kg_m3, "kg/m³", above_zero(1e6), "density of a disc"),
    IFEDEM_KEY(soil.thickness_m, "m", above_zero(1e3),
               "thickness of the soil across the plane; give wheel.width_m the same"),

    IFEDEM_KEY(contact.normal_stiffness_N_m, "N/m", above_zero(1e12), "normal spring K_n of Eq 2.17"),
    IFEDEM_KEY(contact.tangential_stiffness_N_m, "N/m", from_zero(1e12), "tangential spring K_s of Eq 2.17"),
    IFEDEM_KEY(contact.friction_soil, "-", from_zero(10), "friction between discs"),
    IFEDEM_KEY(contact.friction_wall, "-", from_zero(10), "friction between a disc and the walls"),
    IFEDEM_KEY(contact.friction_wheel, "-", from_zero(10), "friction between a disc and the wheel"),
    IFEDEM_KEY(contact.friction_elements, "-", from_zero(10), "friction between a disc and the soil's elements"),
    IFEDEM_KEY(contact.consolidation_friction_soil, "-", from_zero(10), "friction between discs while consolidating"),
    IFEDEM_KEY(contact.consolidation_friction_wall, "-", from_zero(10),
               "friction with walls and soil elements while consolidating"),
    IFEDEM_KEY(contact.damping_ratio, "-", from_zero(10), "C / (2 sqrt(K m_eff)) of both dashpots"),
    IFEDEM_KEY(contact.rolling_factor, "-", from_zero(100), "alpha of Eq 2.18; 0 = no rolling resistance"),
    IFEDEM_KEY(contact.rolling_chord, "", any, "b of Eq 2.18: the contact's chord, or half of it"),
    IFEDEM_KEY(contact.rolling_scheme, "", any,
               "rolling resistance: a limit that can stop rotation, or the bare sign of Eq 2.18"),
    IFEDEM_KEY(contact.contact_end, "", any,
               "no-attraction: a contact ends when its normal force does; attraction: at zero overlap"),

    IFEDEM_KEY(bed.length_m, "m", above_zero(1e3), "distance between the end walls"),
    IFEDEM_KEY(bed.disc_count, "-", whole(1, 1e7), "number of discs"),
    IFEDEM_KEY(bed.seed, "-", whole(0, 9e15), "seed of the packing; another seed is another realisation"),
    IFEDEM_KEY(bed.walls, "", any, "smooth walls, or walls of fixed discs"),
    IFEDEM_KEY(bed.levelled_count, "-", whole(0, 1e7),
               "discs left when the highest are taken away after consolidation; 0 = all stay"),

    IFEDEM_KEY(elements.columns, "-", whole(0, 1e4),
               "blocks of soil elements between the end walls; 0 = the soil is discs only"),
    IFEDEM_KEY(elements.rows, "-", whole(1, 1e3), "rows of such blocks, from the floor"),
    IFEDEM_KEY(elements.block_length_m, "m", above_zero(1e3), "length of a block"),
    IFEDEM_KEY(elements.block_height_m, "m", above_zero(1e3), "height of a block"),
    IFEDEM_KEY(elements.first_disc_column, "-", whole(0, 1e4), "first block of the top row that is discs"),
    IFEDEM_KEY(elements.disc_columns, "-", whole(0, 1e4),
               "how many blocks of the top row are discs at the start; 0 = the bed lies on the elements"),
    IFEDEM_KEY(elements.conversion_interval_steps, "-", whole(0, 1e9),
               "steps of travel between looks for blocks to convert; 0 = never"),
    IFEDEM_KEY(elements.margin_columns, "-", whole(0, 1e4),
               "blocks of discs in front of and behind the tyre's own; 0 = the text's small region"),
    IFEDEM_KEY(
        elements.region, "", any,
        "which blocks are discs: by the tyre's edges as in the text, or those that it comes near or that would yield"),
    IFEDEM_KEY(elements.friction_angle_deg, "°", from_zero(90),
               "adaptive: the block in front becomes discs when this angle of friction is mobilised in it"),
    IFEDEM_KEY(elements.pattern_discs, "-", whole(1, 1e7), "discs of a block"),
    IFEDEM_KEY(elements.pattern_s, "s", from_zero(1e3), "time for a block's discs to settle, and again under the lid"),
    IFEDEM_KEY(elements.pattern_mass_factor, "-", above_zero(1), "share of their mass that settles them"),
    IFEDEM_KEY(
        elements.stress_handover, "", any,
        "what a conversion hands over: nothing as in the text, or the mean stress and the mass of what it replaces"),
    IFEDEM_MATERIAL(elements.material, "the soil's elements (plane strain)"),

    IFEDEM_KEY(wheel.shape, "", any,
               "a wheel, or a plate for soil tests: rigid whatever wheel.body says, and not turning"),
    IFEDEM_KEY(wheel.plate_length_m, "m", above_zero(1e2), "length of a plate along the travel; it is half as high"),
    IFEDEM_KEY(wheel.body, "", any, "all rigid, elastic layers on a rigid rim, or all elastic"),
    IFEDEM_KEY(wheel.load_N, "N", from_zero(1e7), "vertical load W on the hub"),
    IFEDEM_KEY(wheel.width_m, "m", above_zero(1e3),
               "width of the wheel, for its mass, stiffness and pressures; give soil.thickness_m the same"),
    IFEDEM_KEY(wheel.rim_width_m, "m", from_zero(1e3), "width of the rim (WR); 0 = the wheel's"),
    IFEDEM_KEY(wheel.rim_radius_m, "m", above_zero(1e2), "radius of the rim, where the elastic layers begin"),
    IFEDEM_KEY(wheel.tread_radius_m, "m", above_zero(1e2), "radius of the tread, lugs excluded"),
    IFEDEM_KEY(wheel.surface_thickness_m, "m", above_zero(1e2), "thickness of the surface layer under the tread"),
    IFEDEM_KEY(wheel.lug_height_m, "m", above_zero(1e2), "height of a lug over the tread"),
    IFEDEM_KEY(wheel.lug_thickness_m, "m", above_zero(1e2), "length of a lug along the tread"),
    IFEDEM_KEY(wheel.lug_gap_m, "m", above_zero(1e2), "clear gap between the two lugs of a pair"),
    IFEDEM_KEY(wheel.lug_pairs, "-", whole(0, 1e3), "pairs of lugs round the wheel; 0 = a smooth tread"),
    IFEDEM_KEY(wheel.lug_phase_deg, "°", (Range{-360, 360}),
               "turns the lugs at the start; another phase is another realisation"),
    IFEDEM_KEY(wheel.rim_rings, "-", whole(1, 1e3), "rings of elements in the rim (elastic body only)"),
    IFEDEM_KEY(wheel.intermediate_rings, "-", whole(1, 1e3), "rings of elements in the intermediate layer"),
    IFEDEM_KEY(wheel.surface_rings, "-", whole(1, 1e3), "rings of elements in the surface layer"),
    IFEDEM_KEY(wheel.gap_columns, "-", whole(1, 1e3), "columns of elements between the lugs of a pair"),
    IFEDEM_KEY(wheel.pitch_columns, "-", whole(1, 1e3), "columns of elements between pairs"),
    IFEDEM_KEY(wheel.smooth_columns, "-", whole(0, 1e4),
               "columns of elements round a smooth tread; 0 = as many as twelve pairs of lugs have"),
    IFEDEM_KEY(wheel.plane, "", any, "plane stress or plane strain in the wheel"),
    IFEDEM_KEY(wheel.damping_frame, "", any,
               "wheel damping acts on the velocity less the wheel's own rigid motion, or on all of it"),
    IFEDEM_KEY(
        wheel.mesh_file, "", any,
        "Gmsh file (2.2 or 4.1, ASCII, metres, hub at 0, 0, parts by physical name) instead of rings and columns; "
        "relative to the case"),
    IFEDEM_KEY(wheel.mesh_checksum, "", any, "of that file: resolved cases have it, so that a changed mesh is noticed"),
    IFEDEM_MATERIAL(wheel.rim, "the rim (WR)"),
    IFEDEM_MATERIAL(wheel.intermediate, "the intermediate layer (WI)"),
    IFEDEM_MATERIAL(wheel.surface, "the surface layer (WS)"),
    IFEDEM_MATERIAL(wheel.lug, "the lugs (WL)"),

    IFEDEM_KEY(travel.slip_percent, "%", (Range{-100, 100, false, false}), "forced slip i = 1 - V/(r omega)"),
    IFEDEM_KEY(travel.speed_m_s, "m/s", above_zero(100), "speed after acceleration: see speed_of"),
    IFEDEM_KEY(travel.speed_of, "", any,
               "whose speed speed_m_s is: the hub's V, or r omega of the tread; V = (1 - i) r omega then"),
    IFEDEM_KEY(travel.acceleration_time_s, "s", from_zero(1e5), "time to reach that speed"),
    IFEDEM_KEY(travel.distance_m, "m", from_zero(1e3), "way of the hub; never less than the ramp of speed takes"),
    IFEDEM_KEY(travel.start_x_m, "m", from_zero(1e3), "hub's place at the start, from the left wall"),
    IFEDEM_KEY(travel.slip_radius, "", any, "radius r of the forced slip"),

    IFEDEM_KEY(control.scheme, "", any, "how the control loops are stepped"),
    IFEDEM_NAMED_KEY("control.drawbar.proportional_N_m", "N/m", from_zero(1e12), "K_p of the drawbar loop (Eq 3.2)",
                     control.drawbar.proportional),
    IFEDEM_NAMED_KEY("control.drawbar.integral_N_m_s", "N/(m s)", from_zero(1e12), "K_i of the drawbar loop (Eq 3.2)",
                     control.drawbar.integral),
    IFEDEM_NAMED_KEY("control.drawbar.derivative_N_s_m", "N s/m", from_zero(1e12), "K_d of the drawbar loop (Eq 3.2)",
                     control.drawbar.derivative),
    IFEDEM_NAMED_KEY("control.torque.proportional_Nm_rad", "N m/rad", from_zero(1e12),
                     "K_p of the torque loop (Eq 3.3)", control.torque.proportional),
    IFEDEM_NAMED_KEY("control.torque.integral_Nm_rad_s", "N m/(rad s)", from_zero(1e12),
                     "K_i of the torque loop (Eq 3.3)", control.torque.integral),
    IFEDEM_NAMED_KEY("control.torque.derivative_Nm_s_rad", "N m s/rad", from_zero(1e12),
                     "K_d of the torque loop (Eq 3.3)", control.torque.derivative),

    IFEDEM_KEY(stages.consolidation_s, "s", from_zero(1e5), "time for the bed to settle"),
    IFEDEM_KEY(stages.sinkage_s, "s", from_zero(1e5), "time for the wheel to sink freely"),
    IFEDEM_KEY(stages.load_ramp_s, "s", from_zero(1e5), "part of it over which the load grows; 0 = all at once"),

    IFEDEM_KEY(record.series_interval_s, "s", above_zero(1e5), "time between rows of series.csv"),
    IFEDEM_KEY(record.frame_interval_s, "s", from_zero(1e5), "time between frames; 0 = none"),
    IFEDEM_KEY(record.checkpoint_interval_s, "s", from_zero(1e5),
               "time between checkpoints; 0 = at the end of stages only"),
    IFEDEM_KEY(record.energy_interval_s, "s", from_zero(1e5),
               "time between samples of dissipation; 0 = no energy budget"),
    IFEDEM_KEY(record.stress_segments, "-", whole(0, 1e5),
               "virtual segments of the wheel's lower half that contact forces are summed on; 0 = none"),
    IFEDEM_KEY(record.stress_blocks, "-", whole(1, 1e3), "equal parts of the averaging window, summed apart"),
    IFEDEM_KEY(record.stress_from_x_m, "m", from_zero(1e3), "hub's place where the averaging of contact forces begins"),
    IFEDEM_KEY(record.stress_to_x_m, "m", from_zero(1e3), "hub's place where it ends"),
    IFEDEM_KEY(record.final_stress, "", any, "stress.csv: stress of every disc and soil element at the end of travel"),

    IFEDEM_KEY(health.overlap_limit, "-", above_zero(2),
               "stop when an overlap exceeds this share of the smaller radius"),
    IFEDEM_KEY(health.least_contacts, "-", from_zero(6),
               "stop when a disc has fewer contacts in the mean as sinkage begins; 0 = look away"),
    IFEDEM_KEY(health.drawbar_error_limit_m, "m", above_zero(1e3), "stop when the hub is this far from its target"),
    IFEDEM_KEY(health.torque_error_limit_rad, "rad", above_zero(1e3),
               "stop when the wheel is turned this far from its target"),

    IFEDEM_KEY(
        target.porosity, "-", (Range{0, 1}),
        "`ifedem calibrate` compares with these, and nothing else reads them; 0 = not known. Here: in the bulk of "
        "the bed"),
    IFEDEM_KEY(target.repose_angle_deg, "°", from_zero(90), "angle of repose"),
    IFEDEM_KEY(target.confined_modulus_Pa, "Pa", from_zero(1e15), "confined compression, secant modulus at 3 %"),
    IFEDEM_KEY(target.friction_angle_deg, "°", from_zero(90), "biaxial compression, friction angle at the peak"),
    IFEDEM_KEY(target.residual_angle_deg, "°", from_zero(90), "biaxial compression, friction angle at 12 to 15 %"),
    IFEDEM_KEY(target.dilatancy_angle_deg, "°", (Range{-90, 90}), "biaxial compression, dilatancy at the peak"),
    IFEDEM_KEY(target.secant_modulus_Pa, "Pa", from_zero(1e15), "biaxial compression, secant modulus at half the peak"),
    IFEDEM_KEY(target.shear_cohesion_Pa, "Pa", from_zero(1e9), "direct shear, cohesion c"),
    IFEDEM_KEY(target.shear_angle_deg, "°", from_zero(90), "direct shear, friction angle"),
    IFEDEM_KEY(target.shear_displacement_m, "m", from_zero(1e2), "direct shear, K of Janosi & Hanamoto"),
    IFEDEM_KEY(target.plate_pressure_Pa, "Pa", from_zero(1e9), "plate sinkage, p = k z^n at z = 1 cm"),
    IFEDEM_KEY(target.plate_exponent, "-", from_zero(10), "plate sinkage, n of p = k z^n"),
};

#undef IFEDEM_MATERIAL
#undef IFEDEM_KEY
#undef IFEDEM_NAMED_KEY

std::string write_number(double value) {
    std::string text = fmt::format("{}", value);
    // "4e-05" is a TOML float already; "170" and "-0" would be integers, and an integer has no −0.
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

std::string write_text(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + '"';
}

std::string join_words(Words words) {
    std::string joined;
    for (const std::string_view word : words) {
        if (!joined.empty()) joined += " | ";
        joined += word;
    }
    return joined;
}

std::string write_list(const std::vector<double>& values) {
    std::string list;
    for (const double value : values) list += (list.empty() ? "" : ", ") + write_number(value);
    return "[" + list + "]";
}

}  // namespace

std::span<const Key> case_keys() { return keys; }

const Key* find_key(std::string_view name) {
    const auto* const found =
        std::find_if(keys.begin(), keys.end(), [name](const Key& key) { return key.name == name; });
    return found == keys.end() ? nullptr : found;
}

bool is_table(std::string_view name) {
    return std::any_of(keys.begin(), keys.end(), [name](const Key& key) {
        return key.name.size() > name.size() && key.name.starts_with(name) && key.name[name.size()] == '.';
    });
}

std::string_view table_of(std::string_view key) {
    const std::size_t dot = key.rfind('.');
    return dot == std::string_view::npos ? std::string_view{} : key.substr(0, dot);
}

std::string_view leaf_of(std::string_view key) { return key.substr(key.rfind('.') + 1); }

std::string describe_range(const Key& key) {
    Case c;
    const Slot slot = key.slot(c);
    if (const auto* choice = std::get_if<ChoiceSlot>(&slot)) return join_words(choice->words);
    if (std::holds_alternative<std::string*>(slot)) return "text";
    const Range& r = key.range;
    const char* what = std::holds_alternative<std::int64_t*>(slot) ? "whole in"
                       : std::holds_alternative<double*>(slot)     ? "in"
                                                                   : "each in";
    return fmt::format("{} {}{:g}, {:g}{}", what, r.low_included ? '[' : '(', r.low, r.high,
                       r.high_included ? ']' : ')');
}

std::string write_value(const Slot& slot) {
    struct Writer {
        std::string operator()(const double* value) const { return write_number(*value); }
        std::string operator()(const std::int64_t* value) const { return fmt::format("{}", *value); }
        std::string operator()(const std::string* value) const { return write_text(*value); }
        std::string operator()(const std::vector<double>* values) const { return write_list(*values); }
        std::string operator()(const ChoiceSlot& choice) const {
            return write_text(choice.words[static_cast<std::size_t>(choice.get(choice.member))]);
        }
    };
    return std::visit(Writer{}, slot);
}

}  // namespace ifedem
