#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/csv.hpp"
#include "check/report_sections.hpp"
#include "model/case.hpp"

namespace ifedem {
namespace {

std::string number_or_dash(double value, int decimals) {
    if (!std::isfinite(value)) return "–";
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);  // no −0.00
    return text;
}

/// Names of run.csv, in the order in which they first appear.
std::vector<std::string> value_names(const Campaign& campaign) {
    std::vector<std::string> names;
    for (const auto& run : campaign.runs)
        for (const auto& v : run.run.values)
            if (std::find(names.begin(), names.end(), v.name) == names.end()) names.push_back(v.name);
    return names;
}

std::string value_of_key(const Case& c, const std::string& key) {
    const std::string line = to_toml_subset(c, {key});
    const auto equals = line.find(" = ");
    return equals == std::string::npos ? "" : line.substr(equals + 3, line.find('\n') - equals - 3);
}

/// What the runs used, each value once: "60", or "9.81 / 3.71".
std::string values_used(const Campaign& campaign, const std::string& keys) {
    std::string text;
    for (const auto& key : split(keys, ' ')) {
        std::vector<std::string> used;
        for (const auto& run : campaign.runs) {
            std::string value = value_of_key(run.run.c, key);
            std::erase(value, '"');
            if (std::find(used.begin(), used.end(), value) == used.end()) used.push_back(value);
        }
        if (!text.empty()) text += "; ";
        text += fmt::format("{}", fmt::join(used, " / "));
    }
    return text;
}

/// "work_torque_J" reads better as "work torque".
std::string heading_of(std::string name) {
    if (name.ends_with("_J")) name.erase(name.size() - 2);
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

Table momentum_table(const Campaign& campaign) {
    Table t;
    t.caption = "Momentum over the averaging window: what the soil does to the wheel against what holds it";
    t.style = "wide";
    t.header = {"Run",   "ΣF_x [N]",          "P_d [N]",  "ΣF_x − P_d [N]",  "ΣF_y [N]",
                "W [N]", "ΔF = ΣF_y − W [N]", "ΔF/W [%]", "wheel's ṗ_y [N]", "(ΔF − ṗ_y)/W [%]"};
    for (const auto& run : campaign.runs) {
        const auto& m = run.metrics;
        const double load = run.condition.load_N;
        t.rows.push_back({{run.run.name, "id"},
                          {number_or_dash(m.direct_thrust_N + m.direct_resistance_N, 2), "num"},
                          {number_or_dash(m.net_traction_N, 2), "num"},
                          {number_or_dash(m.horizontal_imbalance_N, 2), "num"},
                          {number_or_dash(m.vertical_force_N, 2), "num"},
                          {fmt::format("{:g}", load), "num"},
                          {number_or_dash(m.vertical_force_N - load, 2), "num"},
                          {number_or_dash(100 * (m.vertical_force_N - load) / load, 2), "num"},
                          {number_or_dash(m.vertical_inertia_N, 2), "num"},
                          {number_or_dash(100 * m.vertical_imbalance_N / load, 2), "num"}});
    }
    return t;
}

/// What comes in less what is lost less what is stored more than before: 0 if the account closes.
double energy_residual_J(const std::map<std::string, double>& growth) {
    double residual = 0;
    for (const auto& [name, joules] : growth) residual += name.starts_with("work_") ? joules : -joules;
    return residual;
}

Table energy_table(const Campaign& campaign) {
    Table t;
    t.caption =
        "Energy over the averaging window [J]: work in, losses, growth of what is stored (motion, springs, strain, "
        "height "
        "of soil and load), and what is left over";
    t.style = "wide";
    const auto& first = campaign.runs.front().metrics.energy_J;
    std::vector<std::string> names;
    for (const char* kind : {"work_", "lost_", "stored_"})
        for (const auto& [name, joules] : first)
            if (name.starts_with(kind)) names.push_back(name);
    t.header = {"Run"};
    for (const auto& name : names) t.header.push_back(heading_of(name));
    t.header.insert(t.header.end(), {"left over", "left over / work in [%]"});
    for (const auto& run : campaign.runs) {
        const auto& growth = run.metrics.energy_J;
        std::vector<Cell> cells{{run.run.name, "id"}};
        for (const auto& name : names)
            cells.push_back({growth.contains(name) ? number_or_dash(growth.at(name), 3) : "–", "num"});
        const double residual = growth.empty() ? std::nan("") : energy_residual_J(growth);
        const double work = growth.contains("work_torque_J") ? growth.at("work_torque_J") : std::nan("");
        cells.push_back({number_or_dash(residual, 3), "num"});
        cells.push_back({number_or_dash(100 * residual / work, 2), "num"});
        t.rows.push_back(std::move(cells));
    }
    return t;
}

void add_unusable(Section& section, const Campaign& campaign) {
    BulletList list{campaign.unusable};
    for (const auto& run : campaign.runs)
        if (!run.shortfall.empty()) list.items.push_back(run.shortfall);
    if (list.items.empty()) return;
    section.blocks.emplace_back(Paragraph{"Runs that no verdict rests on", "lead not-computable"});
    section.blocks.emplace_back(std::move(list));
}

}  // namespace

Section slips_section(const Campaign& campaign) {
    Section s{"slips", "Window means by slip", {}};
    if (campaign.runs.empty()) return s;
    Table t;
    t.caption =
        "Each run on its own. H is ⟨T⟩/⟨r_e⟩; the two other readings of H, and the sums of the forward and backward "
        "forces on the "
        "wheel’s segments (Eq 2.13), stand beside it. z counts from the first touch, deflection included.";
    t.style = "wide";
    t.data_file = "runs.csv";
    t.header = {"Run",     "i set [%]", "i measured [%]", "H [N]",  "⟨T/r_e⟩", "⟨T⟩/min r_e", "ΣF_x⁺",
                "P_d [N]", "R [N]",     "ΣF_x⁻",          "z [cm]", "δ [mm]",  "r_e [mm]",    "window [cm]"};
    for (const auto& run : campaign.runs) {
        const auto& m = run.metrics;
        t.rows.push_back({{run.run.name, "id"},
                          {fmt::format("{:g}", run.condition.slip_percent), "num"},
                          {number_or_dash(m.measured_slip_percent, 1), "num"},
                          {number_or_dash(m.gross_tractive_effort_N, 1), "num"},
                          {number_or_dash(m.gross_tractive_effort_instant_N, 1), "num muted"},
                          {number_or_dash(m.gross_tractive_effort_minimum_N, 1), "num muted"},
                          {number_or_dash(m.direct_thrust_N, 1), "num muted"},
                          {number_or_dash(m.net_traction_N, 1), "num"},
                          {number_or_dash(m.motion_resistance_N, 1), "num"},
                          {number_or_dash(m.direct_resistance_N, 1), "num muted"},
                          {number_or_dash(m.sinkage_cm, 2), "num"},
                          {number_or_dash(m.deflection_mm, 2), "num"},
                          {number_or_dash(1e3 * m.effective_radius_m, 1), "num"},
                          {fmt::format("{:.1f}–{:.1f}", 100 * m.window.from_m, 100 * m.window.to_m), "num"}});
    }
    s.blocks.emplace_back(std::move(t));
    return s;
}

Section measurements_section(const Campaign& campaign) {
    Section s{"measurements", "Measured otherwise", {}};
    Table t;
    t.caption = "Numbers that tests and tools measured; scatter is the standard deviation over n realisations.";
    t.style = "cards";
    t.header = {"Name", "Value", "Units", "Scatter", "n", "Note"};
    for (const auto& m : campaign.measurements) {
        if (m.name.find(':') != std::string::npos) continue;  // an effect: it has its own table
        t.rows.push_back({{m.name, "id"},
                          {format_number(m.value), "num"},
                          {m.units, ""},
                          {m.n > 1 ? format_number(m.scatter) : "–", "num"},
                          {std::to_string(m.n), "num"},
                          {m.note, "small"}});
    }
    if (t.rows.empty()) return s;
    s.blocks.emplace_back(std::move(t));
    return s;
}

Section choices_section(const std::string& choices_path, const Campaign& campaign) {
    Section s{"choices", "What the text leaves open, and what was chosen", {}};
    const CsvTable choices = read_csv(choices_path);
    s.blocks.emplace_back(
        Paragraph{"The dissertation does not print everything that a program needs. Each gap below was closed before "
                  "the campaign that is judged, "
                  "for the reason given; what it does to the results stands in the last column.",
                  ""});
    Table t;
    t.style = "cards";
    t.header = {"Key", "Chosen", "Used by the runs", "The text says", "Why", "How much it matters"};
    for (const auto& row : choices.rows) {
        const auto cell = [&](const char* name) { return row.cells[choices.require(name)]; };
        const bool is_key = !cell("key").starts_with('(');
        t.rows.push_back({{cell("key"), "id"},
                          {cell("value"), ""},
                          {is_key && !campaign.runs.empty() ? values_used(campaign, cell("key")) : "–", ""},
                          {cell("text_says"), ""},
                          {cell("reason"), ""},
                          {cell("sensitivity"), "small"}});
    }
    s.blocks.emplace_back(std::move(t));
    return s;
}

Section balances_section(const Campaign& campaign) {
    Section s{"balances", "Momentum and energy", {}};
    if (campaign.runs.empty()) return s;
    s.blocks.emplace_back(momentum_table(campaign));
    if (!campaign.runs.front().metrics.energy_J.empty()) s.blocks.emplace_back(energy_table(campaign));
    return s;
}

Section provenance_section(const Campaign& campaign, const std::string& command) {
    Section s{"provenance", "Provenance", {}};
    if (!command.empty()) s.blocks.emplace_back(Paragraph{"This report: " + command, "code"});
    add_unusable(s, campaign);
    if (campaign.runs.empty()) return s;
    Table t;
    t.caption = "Same command and same results version: same hash, on any machine and with any number of threads.";
    t.style = "wide";
    t.header = {"Run",     "State hash", "Results version", "Program",  "Compiler",
                "Threads", "Steps",      "CPU [s]",         "Wall [s]", "ns per particle and step"};
    for (const auto& run : campaign.runs) {
        const auto text = [&](const char* name) {
            return run.run.text(name).empty() ? std::string("–") : run.run.text(name);
        };
        t.rows.push_back({{run.run.name, "id"},
                          {text("state_hash"), "id"},
                          {text("results_version"), "num"},
                          {text("version"), ""},
                          {text("compiler"), "small"},
                          {text("threads"), "num"},
                          {text("steps"), "num"},
                          {text("cpu_s"), "num"},
                          {text("wall_s"), "num"},
                          {text("ns_per_particle_step"), "num"}});
    }
    s.blocks.emplace_back(std::move(t));
    return s;
}

Section reading_section() {
    Section s{"reading", "How to read this report", {}};
    s.blocks.emplace_back(BulletList{{
        "Verdicts are computed from the runs, never typed in. match: the error is within U and U is small enough to "
        "tell (10 % of the "
        "value, or 5 % of the load for a force). unresolved: within, but U is too large. differs-explained: outside, "
        "and a file shows the "
        "cause. not-reproduced: outside. not-computable: the reason is given.",
        "A realisation is a packing of the bed together with a position of the lugs. A computed value is the mean over "
        "n realisations of "
        "the mean over the text's averaging window: in chapter 3 40–80 cm of travel, 60–80 cm at 70 % slip, cut to "
        "whole lug-pair pitches; in chapter 4 from x = 0.9 to 1.2 m; in chapter 5 the last 0.3 m of travel.",
        "U = √(t² s² (1 + 1/n) + u_read²) with Student’s t at 95 % and the standard deviation s of the realisations; "
        "u_read is how well "
        "the text’s own number can be known (1 N on Earth, 0.5 N on Mars, 0.125 cm). Where n = 1, s is borrowed from "
        "the slips with "
        "several realisations. Ratios carry the U of both sides.",
        "Signs: H + R = P_d with R < 0; sinkage z < 0 downward. Error bars in the figures are U without u_read.",
        "At 95 %, one number in twenty may miss by chance alone.",
    }});
    return s;
}

std::string runs_to_csv(const Campaign& campaign) {
    const auto names = value_names(campaign);
    std::vector<std::string> header{"run",  "wheel",         "gravity",       "load_N",     "slip_percent",
                                    "seed", "lug_phase_deg", "window_from_m", "window_to_m"};
    for (const auto& info : metric_table()) header.emplace_back(info.name);
    header.insert(header.end(), names.begin(), names.end());
    std::string text = csv_line(header);
    for (const auto& run : campaign.runs) {
        const auto& c = run.condition;
        std::vector<std::string> cells{run.run.name,
                                       c.wheel,
                                       c.gravity,
                                       format_number(c.load_N),
                                       format_number(c.slip_percent),
                                       std::to_string(run.run.c.bed.seed),
                                       format_number(run.run.c.wheel.lug_phase_deg),
                                       format_number(run.metrics.window.from_m),
                                       format_number(run.metrics.window.to_m)};
        for (const auto& info : metric_table()) cells.push_back(format_number(run.metrics.*info.member));
        for (const auto& name : names) cells.push_back(run.run.text(name));
        text += csv_line(cells);
    }
    return text;
}

}  // namespace ifedem
