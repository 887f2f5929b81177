#pragma once
#include <string>
#include <vector>

#include "check/campaign.hpp"
#include "check/document.hpp"
#include "check/evaluate.hpp"

namespace ifedem {

/// Where a report's parts come from and go to.
struct ReportPaths {
    std::string chapter;    ///< the folder of claims.csv: figures.csv, choices.csv and the gnuplot scripts
    std::string style;      ///< reports/style.gp
    std::string templates;  ///< reports/templates
    std::string out;        ///< the report's directory
};

/// Draws every line of figures.csv whose runs exist into out/figures, with its data as CSV beside it.
/// The same for figures.csv in folders of the chapter's, whose scripts stand there.
/// A line: name, script, data, metric, series, title, ylabel, caption, style.
///   data "slip": `metric` against slip for each "wheel gravity load" of `series` (separated by |; without a wheel B3),
///   with the text's numbers; "measured-slip": the same against the slip of Eq 3.8, which the effective radius makes
///   data "series": torque, net traction and sinkage of the first run of "gravity load slip" against travel
///   data "snapshot": the picture named `script` that a run of "gravity load slip" left in its directory
///   data "file": the CSV (or .png) at the path `series` in the first directory of the report that holds it; `metric`
///   names the directory (its last part) where several do
///   data "effects": what variations do to H, P_d, R and z under "gravity load slip"
///   data "stiffness": load against deflection;   data "agreement": error over tolerance of all numbers
[[nodiscard]] std::vector<Figure> draw_figures(const ReportPaths& paths, const Campaign& campaign,
                                               const std::vector<Outcome>& outcomes);

}  // namespace ifedem
