#include "check/claim_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/csv.hpp"

namespace ifedem {
namespace {

template <class Value>
void add_once(std::vector<Value>& list, const Value& value) {
    if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

}  // namespace

std::string without_prefix(const std::string& metric) { return metric.substr(metric.find(':') + 1); }

const MetricInfo& metric_of(const Claim& claim) { return *find_metric(without_prefix(claim.metric)); }

std::string wanted_runs(const Claim& claim, std::size_t side) {
    const auto& s = claim.selection;
    std::vector<std::string> wheels, planets, loads;
    for (const auto& curve : s.sides.at(side)) {
        add_once(wheels, curve.wheel);
        add_once(planets, capitalised(curve.gravity));
        add_once(loads, fmt::format("{:g}", curve.load_N));
    }
    const auto slip = s.slip_from_percent < s.slip_to_percent
                          ? fmt::format("{:g}–{:g}", s.slip_from_percent, s.slip_to_percent)
                          : fmt::format("{:g}", s.slip_from_percent);
    return fmt::format("{}, {}, {} N, slip {} %", fmt::join(wheels, " + "), fmt::join(planets, " + "),
                       fmt::join(loads, " + "), slip);
}

ValuesBySlip collect_curve(const Campaign& campaign, const Claim& claim, const Curve& curve) {
    auto values = collect(campaign, curve, metric_of(claim));
    if (claim.metric.starts_with("abs:"))
        for (auto& [slip, group] : values)
            for (double& v : group) v = std::abs(v);
    return values;
}

}  // namespace ifedem
