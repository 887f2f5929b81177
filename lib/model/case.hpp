#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace ifedem {

// A case is what the user writes: plain values with the unit in the key. Defaults are chapter 3, B3, Earth.
// The table in case_keys.cpp is the one place that joins a key to its member, unit, range and sentence; the reader,
// the writer of resolved cases and `ifedem describe` are loops over it.

enum class Integrator { symplectic_euler, modified_euler_one, modified_euler_two };
enum class ContactEnd { no_attraction, attraction };  ///< force ends at F = 0, or at zero overlap (then it may pull)
enum class RollingScheme { limit, sign };             ///< a limit that can stop rotation, or the raw sign of Eq 2.18
enum class RollingChord { full, half };               ///< b of Eq 2.18
enum class WallKind { flat, discs };
enum class WheelShape { round, plate };              ///< a plate is a rigid rectangle that does not turn: soil tests
enum class WheelBody { rigid, rigid_rim, elastic };  ///< all rigid; elastic layers on a rigid rim; all elastic
enum class DampingFrame { rigid_motion, absolute };  ///< what c of Eq 2.3 multiplies: v − v_rigid, or v
enum class SlipRadius { tread, lug_tip };
enum class SpeedOf { hub, tread };  ///< what travel.speed_m_s is: V, or r ω of the unloaded radius
enum class ControlScheme { semi_implicit, explicit_, prescribed };  ///< two forms of the PID; or no loop at all
enum class PlaneState { stress, strain };
/// Which blocks are discs: by the place of the tyre's edges (section 5.1), or by what the soil does.
enum class RegionRule { position, adaptive };
enum class StressHandover { none, mean };  ///< at a conversion: nothing (section 5.1.3), or the mean stress
enum class FinalStress { skip, write };    ///< stress.csv: stress of every disc and soil element at the end of travel

struct SoilCase {
    std::vector<double> radii_m = {0.002, 0.0025, 0.003};
    std::vector<double> radii_shares = {3, 2, 1};  ///< by number
    double density_kg_m3 = 2600;
    double thickness_m = 0.1;
};

struct ContactCase {
    double normal_stiffness_N_m = 1e5;
    double tangential_stiffness_N_m = 2.5e4;
    double friction_soil = 0.6;
    double friction_wall = 0.4;
    double friction_wheel = 0.1;
    double friction_elements = 0.6;
    double consolidation_friction_soil = 0.0;
    double consolidation_friction_wall = 0.0;
    double damping_ratio = 0.2;  ///< ζ = C / (2 √(K m_eff)), both directions
    double rolling_factor = 1.0;
    RollingChord rolling_chord = RollingChord::full;
    RollingScheme rolling_scheme = RollingScheme::limit;
    ContactEnd contact_end = ContactEnd::no_attraction;
};

struct BedCase {
    double length_m = 1.5;
    std::int64_t disc_count = 19468;
    std::int64_t seed = 1;
    WallKind walls = WallKind::flat;
    std::int64_t levelled_count = 0;  ///< discs left when the surface is levelled after consolidation; 0 = all
};

/// One material of the wheel: WR, WI, WS or WL of Table 3-2.
struct MaterialCase {
    double young_Pa = 0;
    double poisson = 0.3;
    double density_kg_m3 = 1000;
    double damping_1_s = 0;  ///< per unit mass, Eq 2.3
};

struct WheelCase {
    WheelShape shape = WheelShape::round;
    double plate_length_m = 0.15;  ///< of a plate, along the travel; it is half as high
    WheelBody body = WheelBody::rigid_rim;
    double load_N = 170;
    double width_m = 0.1;
    double rim_width_m = 0;  ///< of WR; 0 = width_m
    double rim_radius_m = 0.09;
    double tread_radius_m = 0.15;
    double surface_thickness_m = 0.0198;  ///< gives B3 the text's radial stiffness of 15.9 N/mm (section 3.2.2)
    double lug_height_m = 0.008;
    double lug_thickness_m = 0.006;
    double lug_gap_m = 0.02;  ///< clear gap between the two lugs of a pair
    std::int64_t lug_pairs = 12;
    double lug_phase_deg = 0;
    std::int64_t rim_rings = 2;
    std::int64_t intermediate_rings = 4;
    std::int64_t surface_rings = 2;
    std::int64_t gap_columns = 1;     ///< columns of elements between the lugs of a pair
    std::int64_t pitch_columns = 1;   ///< columns of elements between pairs
    std::int64_t smooth_columns = 0;  ///< columns round a smooth tread; 0 = as many as twelve pairs would have
    PlaneState plane = PlaneState::stress;
    DampingFrame damping_frame = DampingFrame::rigid_motion;
    MaterialCase rim{200e6, 0.3, 3000, 1};
    MaterialCase intermediate{0.05e6, 0.3, 1000, 1};
    MaterialCase surface{4e6, 0.49, 1000, 10};
    MaterialCase lug{4e6, 0.49, 5000, 10};
    std::string mesh_file;      ///< Gmsh file instead of rings and columns; absolute once the case is read
    std::string mesh_checksum;  ///< of that file when the case was read
};

struct TravelCase {
    double slip_percent = 60;
    double speed_m_s = 0.1;
    SpeedOf speed_of = SpeedOf::hub;
    double acceleration_time_s = 1;
    double distance_m = 0.8;
    double start_x_m = 0.3;
    SlipRadius slip_radius = SlipRadius::tread;
};

struct GainsCase {
    double proportional = 0;
    double integral = 0;
    double derivative = 0;
};

struct ControlCase {
    ControlScheme scheme = ControlScheme::semi_implicit;
    GainsCase drawbar{1e4, 1e4, 1e4};  ///< N/m, N/(m s), N s/m
    GainsCase torque{1e3, 1e3, 1e3};   ///< N m/rad, N m/(rad s), N m s/rad
};

/// Soil made of elements (chapter 5); none by default.
struct ElementsCase {
    std::int64_t columns = 0;  ///< blocks between the side walls; 0 = no soil elements
    std::int64_t rows = 2;
    double block_length_m = 0.15;
    double block_height_m = 0.2;
    std::int64_t first_disc_column = 0;
    std::int64_t disc_columns = 0;
    std::int64_t conversion_interval_steps = 0;  ///< 0 = blocks stay what they are
    std::int64_t margin_columns = 0;
    RegionRule region = RegionRule::position;
    double friction_angle_deg = 52.8;   ///< `ifedem calibrate` on chapter 5's discs: end of biaxial compression
    std::int64_t pattern_discs = 1451;  ///< Table 5-5: 7255 = 5 × 1451
    double pattern_s = 0.5;
    double pattern_mass_factor = 0.01;
    StressHandover stress_handover = StressHandover::none;
    MaterialCase material{1.7e6, 0.3, 2200, 10};
};

struct StagesCase {
    double consolidation_s = 1;
    double sinkage_s = 2;
    double load_ramp_s = 0;  ///< the load grows over this part of the sinkage; 0: at once
};

struct RecordCase {
    double series_interval_s = 0.002;
    double frame_interval_s = 0.25;
    double checkpoint_interval_s = 1;
    double energy_interval_s = 0.004;  ///< sampling of dissipation; 0 = no energy budget
    std::int64_t stress_segments = 0;  ///< virtual segments of the lower half (section 4.2.2); 0 = no contact stress
    std::int64_t stress_blocks = 10;   ///< parts of the window that are summed apart, for intervals of confidence
    double stress_from_x_m = 0.9;      ///< averaging window: places of the hub
    double stress_to_x_m = 1.2;
    FinalStress final_stress = FinalStress::skip;
};

struct HealthCase {
    double overlap_limit =
        0.8;  ///< largest overlap as a share of the smaller radius; at 1 a disc's centre passes a surface
    double least_contacts = 2;  ///< mean a disc when sinkage begins; fewer: the bed does not carry yet
    double drawbar_error_limit_m = 0.02;
    double torque_error_limit_rad = 0.1;
};

/// What a real sand measured in the tests of `ifedem calibrate`, which alone reads it; 0 = not known.
struct TargetCase {
    double porosity = 0;
    double repose_angle_deg = 0;
    double confined_modulus_Pa = 0;
    double friction_angle_deg = 0;
    double residual_angle_deg = 0;
    double dilatancy_angle_deg = 0;
    double secant_modulus_Pa = 0;
    double shear_cohesion_Pa = 0;
    double shear_angle_deg = 0;
    double shear_displacement_m = 0;
    double plate_pressure_Pa = 0;
    double plate_exponent = 0;
};

struct Case {
    std::string name = "chapter3";
    double gravity_m_s2 = 9.81;
    double time_step_s = 4e-5;
    Integrator integrator = Integrator::symplectic_euler;
    SoilCase soil;
    ContactCase contact;
    BedCase bed;
    ElementsCase elements;
    WheelCase wheel;
    TravelCase travel;
    ControlCase control;
    StagesCase stages;
    RecordCase record;
    HealthCase health;
    TargetCase target;
};

/// Discs that are planned for the beginning of travel.
[[nodiscard]] inline std::int64_t planned_discs(const Case& c) {
    if (c.elements.columns > 0 && c.elements.disc_columns > 0)
        return c.elements.disc_columns * c.elements.pattern_discs;
    return c.bed.levelled_count > 0 ? c.bed.levelled_count : c.bed.disc_count;
}

/// From the hub to the tips of the lugs; half the length of a plate.
[[nodiscard]] inline double outer_radius_m(const WheelCase& wheel) {
    if (wheel.shape == WheelShape::plate) return 0.5 * wheel.plate_length_m;
    return wheel.tread_radius_m + (wheel.lug_pairs > 0 ? wheel.lug_height_m : 0.0);
}

/// Columns of elements round a tread without lugs: as many as twelve pairs would have, unless given.
[[nodiscard]] inline std::int64_t smooth_tread_columns(const WheelCase& wheel) {
    return wheel.smooth_columns > 0 ? wheel.smooth_columns : 12 * (2 + wheel.gap_columns + wheel.pitch_columns);
}

/// V after acceleration.
[[nodiscard]] inline double travel_speed_m_s(const TravelCase& travel) {
    return travel.speed_of == SpeedOf::tread ? (1.0 - travel.slip_percent / 100.0) * travel.speed_m_s
                                             : travel.speed_m_s;
}

/// What the hub goes while it accelerates.
[[nodiscard]] inline double ramp_way_m(const TravelCase& travel) {
    return 0.5 * travel.acceleration_time_s * travel_speed_m_s(travel);
}

/// The hub's way: never less than the ramp takes.
[[nodiscard]] inline double way_of_travel_m(const TravelCase& travel) {
    return std::max(travel.distance_m, ramp_way_m(travel));
}

/// An assignment from the command line, `--set table.key=value`.
struct Override {
    std::string key;
    std::string value;
};

/// Reads a TOML case. Throws Error(bad_input) with every fault found, one a line: "file:line:column: what is wrong.
/// What to do?".
[[nodiscard]] Case read_case(const std::string& path, const std::vector<Override>& overrides = {});

/// The same from text; `name` stands for the file in messages.
[[nodiscard]] Case parse_case(const std::string& text, const std::string& name,
                              const std::vector<Override>& overrides = {});

/// The case as TOML with every key written out; reads back to the same values to the last bit.
[[nodiscard]] std::string to_toml(const Case& c);

/// What `to` sets otherwise than `from`: key and TOML value, in the order in which a case is written.
[[nodiscard]] std::vector<Override> list_changes(const Case& from, const Case& to);

/// The manual of keys: name, unit, default, range, what it means.
[[nodiscard]] std::string describe_keys();

/// "key = value" lines of the keys of the given tables ("" = top level), for hashing a stage's inputs.
[[nodiscard]] std::string to_toml_subset(const Case& c, const std::vector<std::string>& keys_or_tables);

}  // namespace ifedem
