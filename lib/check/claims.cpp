#include "check/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "check/claim_runs.hpp"
#include "check/csv.hpp"
#include "check/metrics.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

constexpr std::array<std::pair<std::string_view, Comparison>, 13> comparisons{{{"equal", Comparison::equal},
                                                                               {"above", Comparison::above},
                                                                               {"below", Comparison::below},
                                                                               {"at-most", Comparison::at_most},
                                                                               {"increasing", Comparison::increasing},
                                                                               {"decreasing", Comparison::decreasing},
                                                                               {"linear", Comparison::linear},
                                                                               {"exceeds", Comparison::exceeds},
                                                                               {"same", Comparison::same},
                                                                               {"steeper", Comparison::steeper},
                                                                               {"cross", Comparison::cross},
                                                                               {"not-cross", Comparison::not_cross},
                                                                               {"none", Comparison::none}}};

std::string known_comparisons() {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : comparisons) names.push_back(name);
    return fmt::format("{}", fmt::join(names, ", "));
}

std::optional<Comparison> parse_comparison(std::string_view text) {
    for (const auto& [name, value] : comparisons)
        if (name == text) return value;
    return std::nullopt;
}

bool is_known_metric(std::string name) {
    if (name.starts_with("measured:")) return name.size() > std::string_view("measured:").size();
    for (const std::string_view prefix : {"ratio:", "abs:"})
        if (name.starts_with(prefix)) name.erase(0, prefix.size());
    static const std::set<std::string> others{"gravity_ratio", "stiffness_N_mm"};
    return find_metric(name) != nullptr || others.contains(name);
}

/// One line on its way from cells to a claim; faults are collected, so that a user sees all of them at once.
class ClaimReader {
public:
    ClaimReader(const CsvTable& table, const CsvRow& row, const Ledger& ledger, std::vector<std::string>& faults)
        : table_(table), row_(row), ledger_(ledger), faults_(faults) {}

    Claim read() {
        claim_.line = row_.line;
        claim_.id = cell("id");
        claim_.metric = cell("metric");
        claim_.tolerance_origin = cell("tolerance_origin");
        claim_.evidence = cell("evidence");
        claim_.note = cell("note");
        if (!ledger_.contains(claim_.base_id()))
            fault(fmt::format("the id '{}' is not in the ledger. Use one of its ids?", claim_.id));
        read_choices();
        read_selection();
        if (claim_.comparison == Comparison::none) {
            if (claim_.note.empty()) fault("a row that is not computed needs its reason. Fill in the note?");
        } else {
            read_computed();
        }
        return claim_;
    }

private:
    [[nodiscard]] const std::string& cell(std::string_view column) const { return row_.cells[table_.require(column)]; }

    void fault(const std::string& what) { faults_.push_back(fmt::format("{}:{}: {}", table_.path, row_.line, what)); }

    void read_choices() {
        const auto comparison = parse_comparison(cell("compare"));
        if (!comparison)
            fault(fmt::format("compare '{}' is not known. Use one of {}?", cell("compare"), known_comparisons()));
        claim_.comparison = comparison.value_or(Comparison::none);
        const auto expected = parse_verdict(cell("expected"));
        if (!expected)
            fault(fmt::format(
                "expected verdict '{}' is not known. Use match, unresolved, differs-explained, not-reproduced or "
                "not-computable?",
                cell("expected")));
        claim_.expected = expected.value_or(Verdict::match);
    }

    void read_selection() {
        auto& s = claim_.selection;
        s.wheel = cell("wheel");
        if (!s.wheel.empty() && !cell("gravity").empty() && !cell("load_N").empty()) read_sides();
        const std::string& slip = cell("slip_percent");
        if (slip.empty()) return;
        const auto dots = slip.find("..");
        s.slip_from_percent = number(slip.substr(0, dots), "slip_percent");
        s.slip_to_percent =
            dots == std::string::npos ? s.slip_from_percent : number(slip.substr(dots + 2), "slip_percent");
    }

    /// A cell's part of one side; a cell without '/' serves both.
    [[nodiscard]] std::vector<std::string> list_of(const char* column, std::size_t side) const {
        const auto parts = split(cell(column), '/');
        return split(parts[std::min(side, parts.size() - 1)], '+');
    }

    void read_sides() {
        std::size_t sides = 1;
        for (const char* column : {"wheel", "gravity", "load_N"})
            sides = std::max(sides, split(cell(column), '/').size());
        for (std::size_t side = 0; side < sides; ++side) {
            std::vector<Curve> curves;
            for (const auto& wheel : list_of("wheel", side))
                for (const auto& gravity : list_of("gravity", side))
                    for (const auto& load : list_of("load_N", side))
                        curves.push_back({wheel, gravity, number(load, "load_N")});
            claim_.selection.sides.push_back(std::move(curves));
        }
    }

    /// Two sides of equally many curves, one side, or one curve, as the comparison needs.
    void check_sides() {
        const auto& sides = claim_.selection.sides;
        const auto c = claim_.comparison;
        const bool is_ratio = claim_.metric.starts_with("ratio:");
        const bool needs_two =
            is_ratio || c == Comparison::exceeds || c == Comparison::same || c == Comparison::steeper;
        if (sides.size() > 2) {
            fault("there are more than two sides. Write one '/' in a cell at most?");
        } else if (c == Comparison::not_cross) {
            if (sides.size() != 2) fault("not-cross needs two sides. Write them as 170/50+70+100+130?");
        } else if (needs_two && (sides.size() != 2 || sides[0].size() != sides[1].size())) {
            fault(fmt::format(
                "{} needs two sides of equally many curves. Write them as B3/B6 or mars/earth and 64.4/170?",
                is_ratio ? "a " + claim_.metric : cell("compare")));
        } else if (!needs_two && sides.size() == 2) {
            fault(fmt::format("{} looks at one side. Leave '/' out?", cell("compare")));
        } else if (!is_about_curves(c) && !sides.empty() && sides[0].size() != 1) {
            fault(fmt::format("{} needs one wheel, planet and load. Leave '+' out?", cell("compare")));
        } else if (c == Comparison::cross && sides.size() == 1 && sides[0].size() < 2) {
            fault("one curve cannot cross itself. List several loads or wheels with '+'?");
        }
    }

    /// measured:NAME over slips is one curve of lines NAME_sSLIP, which can only be judged by itself.
    void check_measured_curve() {
        const auto c = claim_.comparison;
        if (!is_about_curves(c)) return;
        if (c != Comparison::increasing && c != Comparison::decreasing && c != Comparison::linear)
            fault(fmt::format("{} over slips cannot be judged by {}. Use increasing, decreasing or linear?",
                              claim_.metric, cell("compare")));
        if (cell("slip_percent").empty()) fault("the slips are not selected. Write them in slip_percent, as 7.5..55?");
    }

    double number(const std::string& text, const char* what) {
        const auto value = parse_number(text);
        if (!value) fault(fmt::format("{} '{}' is not a number. Write one?", what, text));
        return value.value_or(0);
    }

    void read_computed() {
        if (!is_known_metric(claim_.metric))
            fault(
                fmt::format("metric '{}' is not known. Use a column of runs.csv, ratio: or abs: of one, measured:NAME, "
                            "gravity_ratio or stiffness_N_mm?",
                            claim_.metric));
        if (claim_.tolerance_origin.empty())
            fault(fmt::format("the tolerance '{}' has no origin. Say in tolerance_origin where it comes from?",
                              cell("tolerance")));
        const bool needs_runs = claim_.metric != "gravity_ratio" && claim_.metric != "stiffness_N_mm" &&
                                !claim_.metric.starts_with("measured:");
        if (needs_runs && (claim_.selection.sides.empty() || cell("slip_percent").empty()))
            fault("the runs are not selected. Fill in wheel, gravity, load_N and slip_percent?");
        else if (needs_runs)
            check_sides();
        if (claim_.metric.starts_with("measured:"))
            check_measured_curve();
        else if (is_about_curves(claim_.comparison) && find_metric(without_prefix(claim_.metric)) == nullptr)
            fault(fmt::format("{} has no curve over slip. Use a column of runs.csv?", claim_.metric));
        check_window();
        read_units();
        if (cell("tolerance") != "U") claim_.tolerance = number(cell("tolerance"), "tolerance");
        const auto c = claim_.comparison;
        const bool needs_tolerance =
            c == Comparison::linear || c == Comparison::same || c == Comparison::cross || c == Comparison::not_cross;
        if (needs_tolerance && !claim_.tolerance)
            fault(fmt::format("{} needs a number as tolerance. Write one with its origin?", cell("compare")));
        read_reference();
    }

    /// A number can only be compared with one of the same unit.
    void read_units() {
        const auto* info = find_metric(claim_.metric);
        const auto row = ledger_.find(claim_.base_id());
        if (!info || row == ledger_.end() || claim_.comparison != Comparison::equal) return;
        if (info->unit != row->second.units)
            fault(fmt::format("{} is in {} but the ledger row in {}. Use a metric of that unit?", claim_.metric,
                              info->unit, row->second.units));
    }

    void check_window() {
        if (const std::string& window = cell("window"); !window.empty() && window != "text")
            fault(fmt::format("window '{}' is not one (numbers are means over the text's). Write text?", window));
    }

    /// Empty: the row's own number. An id: that row's number. "=1": the number 1.
    void read_reference() {
        const std::string& text = cell("reference");
        if (text.starts_with('=')) {
            claim_.reference = number(text.substr(1), "reference");
            return;
        }
        claim_.reference_id = text.empty() ? claim_.base_id() : text;
        const auto row = ledger_.find(claim_.reference_id);
        if (row == ledger_.end()) {
            fault(fmt::format("reference '{}' is not in the ledger. Use one of its ids, or =NUMBER?",
                              claim_.reference_id));
            return;
        }
        claim_.reference = row->second.number();
        const bool needs_number = claim_.comparison == Comparison::equal || claim_.comparison == Comparison::above ||
                                  claim_.comparison == Comparison::below || claim_.comparison == Comparison::at_most;
        if (needs_number && !claim_.reference)
            fault(fmt::format("the ledger row {} holds no number to compare with. Name a reference?",
                              claim_.reference_id));
    }

    const CsvTable& table_;
    const CsvRow& row_;
    const Ledger& ledger_;
    std::vector<std::string>& faults_;
    Claim claim_;
};

}  // namespace

bool is_about_curves(Comparison comparison) {
    switch (comparison) {
        case Comparison::increasing:
        case Comparison::decreasing:
        case Comparison::linear:
        case Comparison::exceeds:
        case Comparison::same:
        case Comparison::steeper:
        case Comparison::cross:
        case Comparison::not_cross:
            return true;
        default:
            return false;
    }
}

std::vector<Claim> read_claims(const std::string& path, const Ledger& ledger) {
    const CsvTable table = read_csv(path);
    for (const char* name : {"id", "metric", "window", "wheel", "gravity", "load_N", "slip_percent", "compare",
                             "reference", "tolerance", "tolerance_origin", "expected", "evidence", "note"})
        static_cast<void>(table.require(name));
    std::vector<std::string> faults;
    std::vector<Claim> claims;
    std::set<std::string> seen;
    for (const auto& row : table.rows) {
        claims.push_back(ClaimReader(table, row, ledger, faults).read());
        if (!seen.insert(claims.back().id).second)
            faults.push_back(fmt::format("{}:{}: the id {} stands twice. Add a suffix such as -b.", path, row.line,
                                         claims.back().id));
    }
    if (!faults.empty()) fail_input(fmt::format("{}", fmt::join(faults, "\n")));
    return claims;
}

}  // namespace ifedem
