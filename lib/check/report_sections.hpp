#pragma once
#include <string>
#include <vector>

#include "check/campaign.hpp"
#include "check/document.hpp"
#include "check/evaluate.hpp"

namespace ifedem {

// Words of one check, as all reports say them.

/// "99 ± 12 N", or the statistic of a trend.
[[nodiscard]] std::string computed_text(const Outcome& o);
/// What the text says, and where; a statement in words with the number that stands for it.
[[nodiscard]] std::string statement_text(const Outcome& o);
[[nodiscard]] Cell verdict_cell(const Outcome& o);

// The report's sections, each from outcomes and runs to blocks.

[[nodiscard]] Section summary_section(const std::vector<Outcome>& outcomes);
[[nodiscard]] Section numbers_section(const std::vector<Outcome>& outcomes, const std::vector<Figure>& figures);
[[nodiscard]] Section figures_section(const std::vector<Figure>& figures);
[[nodiscard]] Section slips_section(const Campaign& campaign);
[[nodiscard]] Section verdicts_section(const std::vector<Outcome>& outcomes);
/// What variations of the choices do, and readings of the text side by side where a variant has several realisations.
[[nodiscard]] Section effects_section(const std::vector<Outcome>& outcomes, const Campaign& campaign);
/// What more depth, length and fineness do.
[[nodiscard]] Section doubts_section(const Campaign& campaign);
[[nodiscard]] Section measurements_section(const Campaign& campaign);
/// `choices_path`: key,value,text_says,reason,sensitivity; the value that the runs used stands beside.
[[nodiscard]] Section choices_section(const std::string& choices_path, const Campaign& campaign);
[[nodiscard]] Section balances_section(const Campaign& campaign);
[[nodiscard]] Section provenance_section(const Campaign& campaign, const std::string& command);
[[nodiscard]] Section reading_section();

/// A line a run: condition, seed, phase, window means, then all of run.csv.
[[nodiscard]] std::string runs_to_csv(const Campaign& campaign);

}  // namespace ifedem
