#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "check/csv.hpp"
#include "check/differences.hpp"
#include "check/report_sections.hpp"

namespace ifedem {
namespace {

constexpr std::size_t several = 3;  ///< realisations from which a variant stands as a reading of its own

std::string symbol_of(const std::string& metric) { return std::string(find_metric(metric)->symbol); }

enum class Sign { always, minus_only };

std::string with_width(double value, double half_width, Sign sign) {
    const int decimals = (std::isfinite(half_width) ? half_width : std::abs(value)) < 1.5 ? 2 : 1;
    const char* plus = sign == Sign::always && value >= 0 ? "+" : "";
    if (!std::isfinite(half_width)) return fmt::format("{}{:.{}f}", plus, value, decimals);
    return fmt::format("{}{:.{}f} ± {:.{}f}", plus, value, decimals, half_width, decimals);
}

/// One row a variant and condition; what leaves its interval is strong.
Table effects_table(const Campaign& campaign) {
    Table t;
    t.caption =
        "Each input changed alone, the rest as chosen: the difference to the same realisations of the default, with "
        "its "
        "95 % half-width. What is larger than that stands out.";
    t.style = "wide";
    t.header = {"Change", "Planet", "Slip [%]", "n", "ΔH [N]", "ΔP_d [N]", "ΔR [N]", "Δz [cm]"};
    using Key = std::tuple<std::string, std::string, double>;
    std::map<Key, std::size_t> row_of;
    for (const auto& e : campaign.effects) {
        const auto [found, is_new] = row_of.try_emplace({e.variant, e.gravity, e.slip_percent}, t.rows.size());
        if (is_new)
            t.rows.push_back({{e.changes, "id"},
                              {capitalised(e.gravity), ""},
                              {fmt::format("{:g}", e.slip_percent), "num"},
                              {std::to_string(e.n), "num"}});
        const bool stands_out = std::abs(e.effect) > e.half_width;
        t.rows[found->second].push_back(
            {with_width(e.effect, e.half_width, Sign::always), stands_out ? "num strong" : "num"});
    }
    return t;
}

const Outcome* find_text(const std::vector<Outcome>& outcomes, const Effect& e) {
    for (const auto& o : outcomes) {
        const auto& sides = o.claim.selection.sides;
        if (o.claim.comparison == Comparison::equal && o.claim.metric == e.metric && sides.size() == 1 &&
            sides[0][0].gravity == e.gravity && std::abs(sides[0][0].load_N - e.load_N) < 1e-9 &&
            std::abs(o.claim.selection.slip_from_percent - e.slip_percent) < 1e-9)
            return &o;
    }
    return nullptr;
}

/// The text's numbers against the default and against each variant that has several realisations.
Table readings_table(const std::vector<Outcome>& outcomes, const Campaign& campaign) {
    Table t;
    t.caption = "Readings of the text side by side: mean ± U over the same realisations";
    t.style = "cards";
    t.header = {"Reading", "Planet", "Slip [%]", "n", "Quantity", "Text", "Default ± U", "This reading ± U"};
    for (const auto& e : campaign.effects) {
        const Outcome* text = e.n >= several ? find_text(outcomes, e) : nullptr;
        if (text == nullptr) continue;
        t.rows.push_back({{e.changes, "id"},
                          {capitalised(e.gravity), ""},
                          {fmt::format("{:g}", e.slip_percent), "num"},
                          {std::to_string(e.n), "num"},
                          {symbol_of(e.metric), "symbol"},
                          {fmt::format("{} {}", text->reference_text, text->units), "num"},
                          {with_width(e.before, e.before_uncertainty, Sign::minus_only), "num"},
                          {with_width(e.after, e.after_uncertainty, Sign::minus_only), "num strong"}});
    }
    return t;
}

/// One row a variation; what moves is strong.
Table doubts_table(const Campaign& campaign) {
    Table t;
    t.caption =
        "More of one thing at a time (`ifedem doubt`): the difference to the same realisations, with its 95 % "
        "half-width. What moves, whatever its size, stands out; of twenty that do not, one will.";
    t.style = "wide";
    t.header = {"More", "What that is", "n", "Cost"};
    for (const Doubt& d : campaign.doubts) {
        if (d.variation == campaign.doubts.front().variation)
            t.header.push_back(fmt::format("Δ{} [{}]", parse_quantities(d.quantity).front().metric->symbol, d.units));
        if (t.rows.empty() || t.rows.back()[0].text != capitalised(d.variation))
            t.rows.push_back({{capitalised(d.variation), "id"},
                              {d.note.empty() ? d.changes : d.changes + ": " + d.note, ""},
                              {std::to_string(d.n), "num"},
                              {fmt::format("× {:.2g}", d.relative_cost), "num"}});
        if (d.n == 0)
            t.rows.back().push_back({"–", "num"});
        else
            t.rows.back().push_back({with_width(d.difference, d.half_width, Sign::always),
                                     std::abs(d.difference) > d.half_width ? "num strong" : "num"});
    }
    return t;
}

}  // namespace

Section doubts_section(const Campaign& campaign) {
    Section s{"doubt", "What more of everything would change", {}};
    if (!campaign.doubts.empty()) s.blocks.emplace_back(doubts_table(campaign));
    return s;
}

Section effects_section(const std::vector<Outcome>& outcomes, const Campaign& campaign) {
    Section s{"sensitivity", "How much the choices matter", {}};
    if (campaign.effects.empty()) return s;
    Table readings = readings_table(outcomes, campaign);
    if (!readings.rows.empty()) s.blocks.emplace_back(std::move(readings));
    s.blocks.emplace_back(effects_table(campaign));
    return s;
}

}  // namespace ifedem
