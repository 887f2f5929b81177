#include "app/calibrate_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "app/run_set.hpp"
#include "app/share.hpp"
#include "check/csv.hpp"
#include "check/document.hpp"
#include "check/gnuplot.hpp"
#include "check/statistics.hpp"
#include "check/targets.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

// ---- numbers --------------------------------------------------------------------------------------------------------

std::string number(double value, int digits = 3) {
    return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "–";
}

// ---- the table ------------------------------------------------------------------------------------------------------

struct KnobSource {
    std::string table, path;
    bool own = false;
};

KnobSource find_knobs(const CalibrateRequest& request) {
    const bool own = request.knobs == Knobs::turn;
    const std::string path = own ? request.directory + "/knobs.csv" : share_directory() + "/soil/knobs.csv";
    return {read_text(path), path, own};
}

Cell show(TargetVerdict verdict) {
    switch (verdict) {
        case TargetVerdict::within:
            return {"within U", "match"};
        case TargetVerdict::too_high:
            return {"too high", "not-reproduced"};
        case TargetVerdict::too_low:
            return {"too low", "not-reproduced"};
        default:
            return {"cannot tell: more realisations", "unresolved"};
    }
}

std::string join(const std::vector<std::string>& parts, const char* between) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : between) + part;
    return text;
}

std::vector<Cell> quantity_row(const SandVariant& sand, const SandQuantity& q, const KnobSource& knobs) {
    const std::vector<double> values = read_values(sand, q);
    const double s = standard_deviation(values), target = q.per_si * sand.c.target.*q.target;
    std::vector<Cell> row{{q.title, "strong"},
                          {q.test, ""},
                          {q.units, ""},
                          {number_within(mean(values), s), "num"},
                          {values.size() > 1 ? number(s, 2) : "–", "num"}};
    if (target == 0) {
        for (int k = 0; k < 3; ++k) row.push_back({"–", "num"});
        row.push_back({"no target", "muted"});
    } else {
        const TargetMatch m = match_target(values, target);
        row.push_back({number(target, 4), "num"});
        row.push_back({signed_within(m.off, s), "num"});
        row.push_back({number(m.uncertainty, 2), "num"});
        row.push_back(show(m.verdict));
    }
    const std::vector<std::string> lines = list_knobs(knobs.table, knobs.path, q.name);
    const bool tried = knobs.table.find("\n" + q.name + ",") != std::string::npos;
    row.push_back({!tried ? "not measured" : lines.empty() ? "none of those tried" : join(lines, "; "), "small"});
    return row;
}

Table list_quantities(const SandVariant& sand, const KnobSource& knobs) {
    Table table;
    table.style = "cards";
    table.data_file = "measurements.csv";
    table.header = {"quantity", "test", "units", "mean", "s", "target", "off", "U", "verdict", "keys that move it"};
    table.caption = fmt::format(
        "Mean and standard deviation s of {} realisations. off: mean less target. U: 95 % half-width of the mean (a "
        "laboratory's sample has so many grains that it is no realisation of this size); the target's own error is not "
        "in it. "
        "Within U counts only if U is no more than a tenth of the target. Last column: what a changed key of [contact] "
        "did to "
        "the quantity, paired by realisation, with the 95 % half-width of the mean difference, where that leaves out 0 "
        "(one in "
        "twenty does by chance); {}.",
        sand.tests.size(),
        knobs.own ? "measured on this sand"
                  : "measured on quick samples of chapter 3's sand (--knobs measures it on yours)");
    for (const SandQuantity& q : sand_quantities()) table.rows.push_back(quantity_row(sand, q, knobs));
    return table;
}

std::string count_targets(const SandVariant& sand) {
    int given = 0, within = 0, unknown = 0;
    for (const SandQuantity& q : sand_quantities()) {
        const double target = q.per_si * sand.c.target.*q.target;
        if (target == 0) continue;
        const TargetVerdict verdict = match_target(read_values(sand, q), target).verdict;
        ++given;
        within += verdict == TargetVerdict::within ? 1 : 0;
        unknown += verdict == TargetVerdict::cannot_tell ? 1 : 0;
    }
    return given == 0 ? "No targets given: [target] in the case says what a real sand measured."
                      : fmt::format("{} of {} targets within U, {} too uncertain to tell, {} off.", within, given,
                                    unknown, given - within - unknown);
}

// ---- figures --------------------------------------------------------------------------------------------------------

/// Points of one line, and the colour and key it goes under.
using AddCurve = std::function<void(const std::string& label, const std::vector<double>& x, double per_x,
                                    const std::vector<double>& y, double per_y)>;

struct SandFigure {
    const char *name, *title, *xlabel, *ylabel, *caption;
    void (*draw)(const SandVariant& sand, const AddCurve& add);
};

void draw_confined(const SandVariant& sand, const AddCurve& add) {
    for (const SandTests& t : sand.tests) add("discs", t.confined.strain, 100, t.confined.stress_Pa, 1e-3);
}
void draw_ratio(const SandVariant& sand, const AddCurve& add) {
    for (const SandTests& t : sand.tests) add("discs", t.biaxial.strain, 100, t.biaxial.ratio, 1);
}
void draw_volume(const SandVariant& sand, const AddCurve& add) {
    for (const SandTests& t : sand.tests) add("discs", t.biaxial.strain, 100, t.biaxial.volumetric, 100);
}
void draw_box(const SandVariant& sand, const AddCurve& add) {
    for (const SandTests& t : sand.tests) {
        const ShearStrength s = read_shear_strength(t);
        for (const ShearTest& test : t.box) {
            std::vector<double> fit;
            for (const double j : test.displacement_m) fit.push_back(shear_stress_Pa(s, test.normal_Pa, j));
            add("fit", test.displacement_m, 1e3, fit, 1e-3);  // first, so that it lies below
        }
    }
    const char* labels[] = {"low", "middle", "high"};
    for (std::size_t b = 0; b < 3; ++b)
        for (const SandTests& t : sand.tests) add(labels[b], t.box[b].displacement_m, 1e3, t.box[b].shear_Pa, 1e-3);
}
void draw_plate(const SandVariant& sand, const AddCurve& add) {
    for (const SandTests& t : sand.tests) {
        const PressureSinkage p = read_pressure_sinkage(t.plate);
        std::vector<double> fit;
        for (const double z : t.plate.sinkage_m) fit.push_back(p.modulus_Pa_mn * std::pow(z, p.exponent));
        add("fit", t.plate.sinkage_m, 1e3, fit, 1e-3);  // first, so that it lies below
    }
    for (const SandTests& t : sand.tests) add("discs", t.plate.sinkage_m, 1e3, t.plate.pressure_Pa, 1e-3);
}
/// Outlines of the surface are less than the discs: those of the first realisation, as centres.
void draw_heap(const SandVariant& sand, const AddCurve& add) {
    std::vector<double> x, y;
    for (const Disc& d : sand.tests.front().repose.discs) x.push_back(d.x_m), y.push_back(d.y_m);
    add("centres", x, 1e2, y, 1e2);
}

constexpr SandFigure sand_figures[] = {
    {"heap", "Heap", "x [cm]", "y [cm]", "First realisation: centres of the discs after the wall has been taken away.",
     draw_heap},
    {"confined", "Confined compression", "strain [%]", "stress [kPa]", "A line a realisation.", draw_confined},
    {"biaxial", "Biaxial compression", "axial strain [%]", "σ_1/σ_3", "A line a realisation.", draw_ratio},
    {"volume", "Volume in biaxial compression", "axial strain [%]", "volume lost [%]",
     "Compaction is positive, dilatancy makes the lines fall.", draw_volume},
    {"box", "Direct shear", "displacement [mm]", "shear stress [kPa]",
     "Under half, all and twice the stress; pale: (c + σ tan φ)(1 − exp(−j/K)).", draw_box},
    {"plate", "Plate sinkage", "sinkage [mm]", "pressure [kPa]", "A line a realisation; pale: p = k zⁿ.", draw_plate}};

FigureGroup draw_figures(const CalibrateRequest& request, const SandVariant& sand) {
    FigureGroup group;
    const std::string share = share_directory();
    for (const SandFigure& f : sand_figures) {
        const std::string base = fmt::format("figures/{}", f.name),
                          data = fmt::format("{}/{}", request.directory, base);
        std::string text = "curve,x,y\n";
        std::vector<std::string> curves;
        f.draw(sand, [&](const std::string& label, const std::vector<double>& x, double per_x,
                         const std::vector<double>& y, double per_y) {
            for (std::size_t k = 0; k < std::min(x.size(), y.size()); ++k)
                text += fmt::format("{},{:.5g},{}\n", label, per_x * x[k],
                                    std::isfinite(y[k]) ? fmt::format("{:.5g}", per_y * y[k]) : "NaN");
            text += "\n";  // gnuplot: the line ends here
            if (std::ranges::find(curves, label) == curves.end()) curves.push_back(label);
        });
        write_text(data + ".csv", text);
        run_gnuplot(share + "/soil/soil.gp",
                    {{"style", share + "/style.gp"},
                     {"data", data + ".csv"},
                     {"xlabel", f.xlabel},
                     {"ylabel", f.ylabel},
                     {"curves", join(curves, " ")}},
                    data + ".svg");
        group.figures.push_back({f.name, f.title, f.caption, base + ".svg", base + ".csv", ""});
    }
    return group;
}

// ---- the whole ------------------------------------------------------------------------------------------------------

BulletList explain(const CalibrateRequest& request, const SandVariant& sand) {
    return {
        {fmt::format("Command: ifedem calibrate {} -o {} --n {} --stress {}{}{}{}", request.case_path,
                     request.directory, request.realisations, request.stress_kPa,
                     request.effort == Effort::quick ? " --quick" : "", request.knobs == Knobs::turn ? " --knobs" : "",
                     show_settings(request.overrides)),
         fmt::format(
             "Realisations are packing seeds {} to {}. Discs in two dimensions; stresses are over {:g} m of thickness.",
             sand.c.bed.seed, sand.c.bed.seed + request.realisations - 1, sand.c.soil.thickness_m),
         "Nothing is fitted for you: turn the keys of [contact] until the quantities that matter are within U. Several "
         "keys move one quantity, and not all targets can be met at once: decide first what has to be right.",
         "A way to go: porosity by the friction of consolidation, moduli by both stiffnesses, angles by friction and "
         "rolling factor together; then look at all of it again.",
         "The bed settles as in a run, with the friction of consolidation. Compression: smooth flat walls, no gravity, "
         "0.05 (confined) and 0.1 of strain a second. Direct shear: walls of discs, no gravity, a twentieth of the "
         "length a second.",
         fmt::format("Springs: σ t/K_n = {:.2g} at the stress above, about the mean overlap over a disc's diameter. "
                     "Where it is more than a few hundredths, the springs are too soft for this stress.",
                     1e3 * request.stress_kPa * sand.c.soil.thickness_m / sand.c.contact.normal_stiffness_N_m),
         fmt::format("The plate is {:.3g} mm wide, in a bin five times as wide, and goes a quarter of its width deep. "
                     "k depends on the width: compare with a plate of about this one.",
                     1e3 * sand.tests.front().plate.width_m),
         "Discs in a plane are no grains: µ, α and k are those with which discs answer alike, not properties of the "
         "sand. "
         "Compare with plane-strain numbers where there are any."}};
}

}  // namespace

std::vector<double> read_values(const SandVariant& variant, const SandQuantity& quantity) {
    std::vector<double> values;
    for (const SandTests& t : variant.tests) values.push_back(quantity.per_si * quantity.read(t));
    return values;
}

std::string knob_table(const std::vector<SandVariant>& variants) {
    std::string text = csv_line({"name", "key", "change", "before", "after", "difference", "half_width", "units", "n"});
    for (const SandQuantity& q : sand_quantities()) {
        const std::vector<double> before = read_values(variants.front(), q);
        for (std::size_t v = 1; v < variants.size(); ++v) {
            const std::vector<double> after = read_values(variants[v], q);
            const PairedDifference d = paired_difference(before, after);
            text += csv_line({q.name, variants[v].key, variants[v].change, format_number(mean(before)),
                              format_number(mean(after)), format_number(d.mean), format_number(d.half_width), q.units,
                              std::to_string(d.n)});
        }
    }
    return text;
}

void write_calibration_report(const CalibrateRequest& request, const std::vector<SandVariant>& variants) {
    const SandVariant& sand = variants.front();
    const KnobSource knobs = find_knobs(request);
    Document d;
    d.title = fmt::format("Soil tests: {}", sand.c.name);
    d.subtitle =
        fmt::format("µ = {:g}, α = {:g}, K_n = {:g} N/m, K_s = {:g} N/m, stress {:g} kPa", sand.c.contact.friction_soil,
                    sand.c.contact.rolling_factor, sand.c.contact.normal_stiffness_N_m,
                    sand.c.contact.tangential_stiffness_N_m, request.stress_kPa);
    d.first_line = count_targets(sand);
    d.sections.push_back({"numbers", "What this sand is", {list_quantities(sand, knobs)}});
    d.sections.push_back({"curves", "Curves", {draw_figures(request, sand)}});
    d.sections.push_back({"how", "How this was made, and how to use it", {explain(request, sand)}});
    write_html(d, request.directory, share_directory() + "/templates");
    write_text(request.directory + "/report.md", to_markdown(d));
}

}  // namespace ifedem
