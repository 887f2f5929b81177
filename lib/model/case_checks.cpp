#include "model/case_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/bitmath.hpp"

namespace ifedem {
namespace {

using Faults = std::vector<RuleFault>;

void check_soil(const Case& c, Faults& faults) {
    const SoilCase& soil = c.soil;
    if (soil.radii_m.size() != soil.radii_shares.size()) {
        faults.push_back(
            {{"soil.radii_m", "soil.radii_shares"},
             fmt::format("soil.radii_m has {} numbers and soil.radii_shares {} (each radius has its share). "
                         "Give both the same length?",
                         soil.radii_m.size(), soil.radii_shares.size())});
    }
    const double largest = *std::max_element(soil.radii_m.begin(), soil.radii_m.end());
    if (!(2 * largest < c.bed.length_m)) {
        faults.push_back({{"bed.length_m", "soil.radii_m"},
                          fmt::format("the largest disc does not fit into the bed (diameter {} m, bed.length_m = {}). "
                                      "Lengthen the bed?",
                                      2 * largest, c.bed.length_m)});
    }
    if (c.bed.levelled_count > c.bed.disc_count) {
        faults.push_back({{"bed.levelled_count", "bed.disc_count"},
                          fmt::format("levelling leaves {} discs of {} (it takes discs away). Lower "
                                      "bed.levelled_count?",
                                      c.bed.levelled_count, c.bed.disc_count)});
    }
}

/// Area of a block's discs over that of the block.
double fill_of_block(const Case& c) {
    double area = 0, shares = 0;
    for (std::size_t k = 0; k < std::min(c.soil.radii_m.size(), c.soil.radii_shares.size()); ++k)
        area += c.soil.radii_shares[k] * pi * c.soil.radii_m[k] * c.soil.radii_m[k], shares += c.soil.radii_shares[k];
    return static_cast<double>(c.elements.pattern_discs) * area / shares /
           (c.elements.block_length_m * c.elements.block_height_m);
}

void check_elements(const Case& c, Faults& faults) {
    const ElementsCase& e = c.elements;
    if (e.columns == 0) return;
    const double length = static_cast<double>(e.columns) * e.block_length_m;
    if (!(std::fabs(length - c.bed.length_m) <= 1e-9)) {
        faults.push_back({{"elements.columns", "elements.block_length_m", "bed.length_m"},
                          fmt::format("the blocks of soil elements do not end at the wall ({} of {} m are {} m, "
                                      "bed.length_m = {}). Change one of them?",
                                      e.columns, e.block_length_m, length, c.bed.length_m)});
    }
    if (c.bed.walls != WallKind::flat) {
        faults.push_back(
            {{"bed.walls", "elements.columns"},
             "walls of discs beside soil elements (they are as high as a bed that stands on the floor). Set "
             "bed.walls = \"flat\"?"});
    }
    if (e.disc_columns > 0 && e.rows < 2) {
        faults.push_back({{"elements.rows", "elements.disc_columns"},
                          "blocks of discs without elements below them (elements.rows = 1: floor and surface of the "
                          "elements would be one, and push twice). Give elements.rows = 2 or more?"});
    }
    if (e.disc_columns > 0 && c.bed.levelled_count > 0) {
        faults.push_back({{"bed.levelled_count", "elements.disc_columns"},
                          "levelling would take discs out of prepared blocks. Leave bed.levelled_count out?"});
    }
    if (!(e.first_disc_column + e.disc_columns <= e.columns)) {
        faults.push_back({{"elements.first_disc_column", "elements.disc_columns", "elements.columns"},
                          fmt::format("the blocks of discs leave the grid (columns {} to {} of {}). Move them?",
                                      e.first_disc_column, e.first_disc_column + e.disc_columns, e.columns)});
    }
    if (const double fraction = fill_of_block(c); e.disc_columns > 0 && !(fraction < 1)) {
        faults.push_back(
            {{"elements.pattern_discs", "elements.block_length_m", "elements.block_height_m", "soil.radii_m"},
             fmt::format("a block's discs do not fit into it ({} of them have {:.3g} times its area). Lower "
                         "elements.pattern_discs?",
                         e.pattern_discs, fraction)});
    }
    constexpr double least_steps = 2000;  // a thousand moves of the lid, and as many steps to rest under it
    const double step_s = c.time_step_s * std::sqrt(e.pattern_mass_factor);
    if (e.disc_columns > 0 && !(e.pattern_s / step_s >= least_steps)) {
        faults.push_back(
            {{"elements.pattern_s", "time_step_s", "elements.pattern_mass_factor"},
             fmt::format("a block's discs would be prepared in {:.0f} steps (elements.pattern_s = {} s; the "
                         "lid needs {:g} to come down). Raise it to {:.3g} s or more?",
                         e.pattern_s / step_s, e.pattern_s, least_steps, least_steps * step_s)});
    }
}

/// Without K_s the cap of the tangential spring, μ F_n / K_s, has no value.
void check_contact(const ContactCase& k, Faults& faults) {
    if (k.tangential_stiffness_N_m > 0) return;
    faults.push_back({{"contact.tangential_stiffness_N_m"},
                      "contact.tangential_stiffness_N_m is 0 (a spring that holds friction needs a stiffness). Set the "
                      "frictions to 0 to do without tangential forces?"});
}

void check_wheel(const WheelCase& wheel, Faults& faults) {
    const double inner = wheel.tread_radius_m - wheel.surface_thickness_m;
    if (!(wheel.rim_radius_m < inner)) {
        faults.push_back(
            {{"wheel.rim_radius_m", "wheel.tread_radius_m", "wheel.surface_thickness_m"},
             fmt::format("the rim leaves no room for the intermediate layer (wheel.rim_radius_m = {} must be "
                         "less than tread_radius_m - surface_thickness_m = {}). Make the rim smaller?",
                         wheel.rim_radius_m, inner)});
    }
    const double pair = 2 * wheel.lug_thickness_m + wheel.lug_gap_m;
    const double round = 2 * pi * wheel.tread_radius_m;
    if (!(pair * static_cast<double>(wheel.lug_pairs) < round)) {
        faults.push_back(
            {{"wheel.lug_pairs", "wheel.lug_thickness_m", "wheel.lug_gap_m", "wheel.tread_radius_m"},
             fmt::format("the lug pairs do not fit round the tread ({} pairs of 2 lug_thickness_m + lug_gap_m = "
                         "{:.4g} m, and {:.4g} m of tread). Use fewer or smaller lugs?",
                         wheel.lug_pairs, pair, round)});
    }
    constexpr double most_elements = 1e6;
    const auto columns = static_cast<double>(
        std::max((2 + wheel.gap_columns + wheel.pitch_columns) * std::max<std::int64_t>(wheel.lug_pairs, 12),
                 wheel.smooth_columns));
    const auto rings = static_cast<double>(wheel.rim_rings + wheel.intermediate_rings + wheel.surface_rings);
    if (!(columns * rings <= most_elements)) {
        faults.push_back(
            {{"wheel.gap_columns", "wheel.pitch_columns", "wheel.rim_rings", "wheel.intermediate_rings",
              "wheel.surface_rings", "wheel.lug_pairs", "wheel.smooth_columns"},
             fmt::format("the wheel would have {:.3g} elements (at most {:g}). Use fewer rings or columns?",
                         columns * rings, most_elements)});
    }
}

void check_travel(const Case& c, Faults& faults) {
    const double radius = outer_radius_m(c.wheel);
    if (!(c.travel.start_x_m - radius >= 0)) {
        faults.push_back(
            {{"travel.start_x_m", "wheel.tread_radius_m", "wheel.lug_height_m"},
             fmt::format("the wheel starts inside the left wall (travel.start_x_m = {} is less than its radius "
                         "over the lugs, {} m). Start further right?",
                         c.travel.start_x_m, radius)});
    }
    const double end = c.travel.start_x_m + way_of_travel_m(c.travel) + radius;
    if (!(end <= c.bed.length_m)) {
        faults.push_back(
            {{"travel.distance_m", "travel.start_x_m", "bed.length_m", "wheel.tread_radius_m",
              "travel.acceleration_time_s"},
             fmt::format("the wheel ends inside the right wall (its front comes to x = {} m, bed.length_m = {}). "
                         "Shorten travel.distance_m or the acceleration, or lengthen the bed?",
                         end, c.bed.length_m)});
    }
    if (c.record.stress_segments > 0 &&
        !(c.record.stress_from_x_m < end - radius && c.record.stress_to_x_m > c.travel.start_x_m)) {
        faults.push_back(
            {{"record.stress_from_x_m", "record.stress_to_x_m", "travel.start_x_m", "travel.distance_m"},
             fmt::format("the hub never comes where contact forces are averaged (x = {} m to {} m; it goes "
                         "from {} m to {} m). Move the one or the other?",
                         c.record.stress_from_x_m, c.record.stress_to_x_m, c.travel.start_x_m, end - radius)});
    }
}

void check_times(const Case& c, Faults& faults) {
    const std::pair<std::string_view, double> intervals[] = {
        {"record.series_interval_s", c.record.series_interval_s},
        {"record.frame_interval_s", c.record.frame_interval_s},
        {"record.checkpoint_interval_s", c.record.checkpoint_interval_s},
        {"record.energy_interval_s", c.record.energy_interval_s}};
    for (const auto& [key, interval] : intervals) {
        if (interval == 0 || interval >= c.time_step_s) continue;
        faults.push_back(
            {{key, "time_step_s"},
             fmt::format("{} = {} is less than time_step_s = {} (nothing happens between steps). Lengthen it?", key,
                         interval, c.time_step_s)});
    }
    if (c.record.stress_segments > 0 && !(c.record.stress_from_x_m < c.record.stress_to_x_m)) {
        faults.push_back({{"record.stress_from_x_m", "record.stress_to_x_m"},
                          fmt::format("contact forces are averaged from x = {} m to {} m (nothing). Exchange them?",
                                      c.record.stress_from_x_m, c.record.stress_to_x_m)});
    }
    constexpr double most_steps = 1e10;
    const double end_s = c.stages.consolidation_s + c.stages.sinkage_s + c.travel.acceleration_time_s +
                         c.travel.distance_m / travel_speed_m_s(c.travel);
    if (!(end_s / c.time_step_s <= most_steps)) {
        faults.push_back({{"time_step_s", "travel.speed_m_s", "travel.speed_of", "travel.distance_m",
                           "stages.consolidation_s", "stages.sinkage_s"},
                          fmt::format("the run would take {:.3g} steps (at most {:g}). Is time_step_s in seconds?",
                                      end_s / c.time_step_s, most_steps)});
    }
}

}  // namespace

std::optional<std::string> find_range_fault(const Key& key, double value) {
    const Range& r = key.range;
    const std::string unit = key.unit == "-" ? "" : fmt::format(" {}", key.unit);
    if (!std::isfinite(value)) {
        return fmt::format("{} is {} (it must be a finite number, {}{}). Correct the value?", key.name, value,
                           describe_range(key), unit);
    }
    const bool high_enough = r.low_included ? value >= r.low : value > r.low;
    const bool low_enough = r.high_included ? value <= r.high : value < r.high;
    if (high_enough && low_enough) return std::nullopt;
    return fmt::format("{} = {} is out of range (it must be {}{}). Correct the value?", key.name, value,
                       describe_range(key), unit);
}

std::optional<std::string> find_wheel_fault(const WheelCase& wheel) {
    Case c;
    c.wheel = wheel;
    for (const Key& key : case_keys()) {
        if (!std::string_view(key.name).starts_with("wheel.")) continue;
        const Slot slot = key.slot(c);
        std::optional<std::string> fault;
        if (const auto* number = std::get_if<double*>(&slot)) fault = find_range_fault(key, **number);
        if (const auto* whole = std::get_if<std::int64_t*>(&slot))
            fault = find_range_fault(key, static_cast<double>(**whole));
        if (fault) return fault;
    }
    Faults faults;
    check_wheel(wheel, faults);
    return faults.empty() ? std::nullopt : std::optional(faults.front().message);
}

std::vector<RuleFault> find_rule_faults(const Case& c) {
    Faults faults;
    check_soil(c, faults);
    check_contact(c.contact, faults);
    check_elements(c, faults);
    check_wheel(c.wheel, faults);
    check_travel(c, faults);
    check_times(c, faults);
    return faults;
}

}  // namespace ifedem
