#include "model/case_changes.hpp"

#include <algorithm>
#include <cmath>

namespace ifedem {
namespace {

constexpr std::int64_t least_columns = 12;  ///< of a smooth tread: below, it is no circle

// Divided rather than multiplied by 1e-4: the nearest number to a short decimal, so that it is written short.
double in_tenths_mm(double length_m) { return std::round(length_m * 1e4) / 1e4; }

std::int64_t scale(std::int64_t count, double factor) { return std::llround(static_cast<double>(count) * factor); }

std::int64_t scale_to_one(std::int64_t count, double factor) { return std::max<std::int64_t>(1, scale(count, factor)); }

void scale_discs(BedCase& bed, double factor) {
    bed.disc_count = scale_to_one(bed.disc_count, factor);
    bed.levelled_count = scale(bed.levelled_count, factor);
}

/// The wheel's way and what is averaged over it begin elsewhere in the bin.
void shift_start(Case& c, double by_m) {
    c.travel.start_x_m = in_tenths_mm(c.travel.start_x_m + by_m);
    if (c.record.stress_segments == 0) return;
    c.record.stress_from_x_m = in_tenths_mm(c.record.stress_from_x_m + by_m);
    c.record.stress_to_x_m = in_tenths_mm(c.record.stress_to_x_m + by_m);
}

/// Takes soil off one end, with the discs that were there.
void cut_bed(Case& c, double by_m) {
    const double before_m = c.bed.length_m;
    c.bed.length_m = in_tenths_mm(before_m - by_m);
    scale_discs(c.bed, c.bed.length_m / before_m);
}

}  // namespace

Case make_realisation(const Case& c, int k) {
    const double golden_section = 0.5 * (std::sqrt(5.0) - 1);
    const WheelCase& wheel = c.wheel;
    const auto repeats = static_cast<double>(wheel.lug_pairs > 0 ? wheel.lug_pairs : smooth_tread_columns(wheel));
    const double turns = (k - 1) * golden_section;
    Case realisation = c;
    realisation.bed.seed = k;
    realisation.wheel.lug_phase_deg = std::round((turns - std::floor(turns)) * 360 / repeats * 1e3) / 1e3;
    return realisation;
}

Case with_depth(const Case& c, double factor) {
    Case changed = c;
    scale_discs(changed.bed, factor);
    changed.stages.consolidation_s *= std::max(1.0, factor);
    return changed;
}

Case with_length(const Case& c, double factor) {
    Case changed = c;
    changed.bed.length_m = in_tenths_mm(c.bed.length_m * factor);
    scale_discs(changed.bed, factor);
    shift_start(changed, (factor - 1) * c.travel.start_x_m);
    return changed;
}

Case with_soil_behind(const Case& c, double factor) {
    Case changed = c;
    const double less_m = in_tenths_mm((1 - factor) * (c.travel.start_x_m - outer_radius_m(c.wheel)));
    cut_bed(changed, less_m);
    shift_start(changed, -less_m);
    return changed;
}

Case with_soil_ahead(const Case& c, double factor) {
    Case changed = c;
    const double front_m = c.travel.start_x_m + way_of_travel_m(c.travel) + outer_radius_m(c.wheel);
    cut_bed(changed, in_tenths_mm((1 - factor) * (c.bed.length_m - front_m)));
    return changed;
}

Case with_region(const Case& c, double factor) {
    Case changed = c;
    ElementsCase& e = changed.elements;
    const std::int64_t more_behind = (scale_to_one(e.disc_columns, factor) - e.disc_columns) / 2;
    const std::int64_t first = std::max<std::int64_t>(0, e.first_disc_column - more_behind);
    const std::int64_t end = std::min(e.columns, e.first_disc_column + e.disc_columns + more_behind);
    e.first_disc_column = first;
    e.disc_columns = end - first;
    e.margin_columns = std::max<std::int64_t>(0, e.margin_columns + more_behind);
    return changed;
}

bool has_discs_only(const Case& c) { return c.elements.columns == 0; }

bool has_region(const Case& c) { return c.elements.columns > 0 && c.elements.disc_columns > 0; }

Case with_disc_radii(const Case& c, double factor) {
    Case changed = c;
    for (double& radius : changed.soil.radii_m) radius *= factor;
    scale_discs(changed.bed, 1 / (factor * factor));
    return changed;
}

Case with_mesh(const Case& c, double factor) {
    Case changed = c;
    WheelCase& wheel = changed.wheel;
    if (wheel.body == WheelBody::elastic) wheel.rim_rings = scale_to_one(wheel.rim_rings, factor);
    if (wheel.body != WheelBody::rigid) {
        wheel.intermediate_rings = scale_to_one(wheel.intermediate_rings, factor);
        wheel.surface_rings = scale_to_one(wheel.surface_rings, factor);
    }
    if (wheel.lug_pairs == 0) {
        const std::int64_t columns = smooth_tread_columns(wheel);
        const std::int64_t wanted = std::max(std::min(columns, least_columns), scale(columns, factor));
        if (wanted != columns) wheel.smooth_columns = wanted;
    } else {
        wheel.gap_columns = scale_to_one(wheel.gap_columns, factor);
        wheel.pitch_columns = scale_to_one(wheel.pitch_columns, factor);
    }
    return changed;
}

bool can_refine_mesh(const Case& c) { return c.wheel.shape == WheelShape::round && c.wheel.mesh_file.empty(); }

Case with_time_step(const Case& c, double factor) {
    Case changed = c;
    if (factor == 1) return changed;
    const double step_s = c.time_step_s * factor;
    // Three digits, rounded down: never beyond what was asked for.
    const double scale = std::pow(10, 2 - std::floor(std::log10(step_s)));
    changed.time_step_s = std::floor(step_s * scale * (1 + 1e-12)) / scale;
    return changed;
}

}  // namespace ifedem
