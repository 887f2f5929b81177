#pragma once
#include <optional>
#include <string>
#include <vector>

#include "check/campaign.hpp"
#include "check/ledger.hpp"
#include "check/verdict.hpp"

namespace ifedem {

/// How a claim compares what was computed with what the text says.
enum class Comparison {
    equal,       ///< a number, within tolerance
    above,       ///< greater than the reference by more than U
    below,       ///< less than the reference by more than U
    at_most,     ///< not greater; for bounds that carry no scatter
    increasing,  ///< over slip, every curve
    decreasing,  ///< over slip, every curve
    linear,      ///< over slip: no curvature worth the name, every curve
    exceeds,     ///< the first side's curves lie above the second's over the slips
    same,        ///< both sides agree at each slip within the tolerance
    steeper,     ///< the first side changes more over slip than the second
    cross,       ///< the curves of one side cross each other within the tolerance of one slip
    not_cross,   ///< those of the first side do not cross those of the second so
    none,        ///< not computable; the note says why
};

/// Selects runs. '+' lists several wheels, planets or loads, each combination a curve; after '/' stands the second
/// side: the denominator of a ratio, or what the first is compared with, curve by curve.
struct Selection {
    std::string wheel;                      ///< as written
    std::vector<std::vector<Curve>> sides;  ///< empty, one, or two
    double slip_from_percent = 0;
    double slip_to_percent = 0;
};

/// One line of claims.csv.
struct Claim {
    std::size_t line = 0;
    std::string id;      ///< of the ledger, with a suffix such as -b where one row needs several checks
    std::string metric;  ///< a window mean (metrics.hpp), "ratio:" of one, "abs:" of one, "measured:" and a name of a
                         ///< measurements.csv, or gravity_ratio, stiffness_N_mm
    Selection selection;
    Comparison comparison = Comparison::none;
    std::optional<double> reference;  ///< where it is not the ledger row's own number
    std::string reference_id;         ///< the ledger row that the reference comes from
    std::optional<double> tolerance;  ///< empty: U
    std::string tolerance_origin;
    Verdict expected = Verdict::match;
    std::string evidence;  ///< a file, from the project's root
    std::string note;

    /// The planet of a claim about one curve, "" if no runs are selected.
    [[nodiscard]] std::string first_gravity() const {
        return selection.sides.empty() ? std::string() : selection.sides[0][0].gravity;
    }
    [[nodiscard]] std::string base_id() const { return id.substr(0, id.find('-')); }
};

/// Does the comparison look at curves over slip, not at one number?
[[nodiscard]] bool is_about_curves(Comparison comparison);

/// Reads and judges every line; throws Error(bad_input) with all faults, each "file:line: what is wrong. What to do?".
[[nodiscard]] std::vector<Claim> read_claims(const std::string& path, const Ledger& ledger);

}  // namespace ifedem
