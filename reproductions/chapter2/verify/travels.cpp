// What the travels of travel.mk say: the method before the PID beside the PID, walls of discs, light rim and lugs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "check/csv.hpp"
#include "check/metrics.hpp"
#include "check/statistics.hpp"
#include "core/error.hpp"
#include "sand.hpp"
#include "topics.hpp"

namespace ifedem::chapter2 {
namespace {

constexpr Window window{0.10, 0.22};

/// Results by method, slip and realisation: all that stand in the directory.
using Results = std::map<std::string, std::map<int, std::map<int, RunMetrics>>>;

Results read_results(const std::string& directory) {
    Results results;
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
        if (!std::filesystem::exists(entry.path() / "run.csv")) continue;
        const auto words = split(entry.path().filename().string(), '-');
        if (words.size() != 3) continue;
        const auto slip = parse_number(words[1].substr(1)), realisation = parse_number(words[2].substr(1));
        if (!slip || !realisation) continue;
        results[words[0]][static_cast<int>(*slip)][static_cast<int>(*realisation)] =
            measure(read_run(entry.path().string()), window);
    }
    if (results.empty()) fail_input(fmt::format("{}: no travel stands there. Run travel.mk first?", directory));
    return results;
}

std::vector<double> values_of(const std::map<int, RunMetrics>& runs, double RunMetrics::*member) {
    std::vector<double> values;
    for (const auto& [realisation, m] : runs) values.push_back(m.*member);
    return values;
}

/// b − a of the realisations that both have.
std::vector<double> difference(const std::map<int, RunMetrics>& a, const std::map<int, RunMetrics>& b,
                               double RunMetrics::*member) {
    std::vector<double> values;
    for (const auto& [realisation, m] : a)
        if (const auto other = b.find(realisation); other != b.end())
            values.push_back(other->second.*member - m.*member);
    return values;
}

/// Change of |R| from the lowest to the highest slip over the load; R < 0.
std::vector<double> change_of_resistance(const std::map<int, std::map<int, RunMetrics>>& by_slip,
                                         double RunMetrics::*member) {
    constexpr double load_N = 170;
    std::vector<double> change = difference(by_slip.begin()->second, by_slip.rbegin()->second, member);
    for (double& c : change) c /= -load_N;
    return change;
}

void compare_methods(Output& out, const Results& results) {
    std::vector<std::vector<std::string>> rows;
    struct Quantity {
        const char* name;
        double RunMetrics::*member;
    };
    for (const char* method : {"pid", "prescribed"}) {
        const auto by_slip = results.find(method);
        if (by_slip == results.end()) continue;
        for (const auto& [slip, runs] : by_slip->second)
            for (const Quantity& q : {Quantity{"thrust", &RunMetrics::direct_thrust_N},
                                      {"resistance", &RunMetrics::direct_resistance_N},
                                      {"effort", &RunMetrics::gross_tractive_effort_N},
                                      {"motion_resistance", &RunMetrics::motion_resistance_N},
                                      {"net", &RunMetrics::net_traction_N},
                                      {"sinkage_cm", &RunMetrics::sinkage_cm}}) {
                const std::vector<double> values = values_of(runs, q.member);
                rows.push_back({method, q.name, std::to_string(slip), number(mean(values)),
                                number(standard_deviation(values)), std::to_string(values.size())});
            }
        const std::string note = "|R|/W at the highest slip less that at the lowest, by realisation";
        out.add_difference(std::string("resistance_change_sum_") + method,
                           change_of_resistance(by_slip->second, &RunMetrics::direct_resistance_N), "-",
                           "R = Σf_x⁻ (Eq 2.14): " + note);
        out.add_difference(std::string("resistance_change_torque_") + method,
                           change_of_resistance(by_slip->second, &RunMetrics::motion_resistance_N), "-",
                           "R = P_d − T/r_e (Eqs 3.5–3.7): " + note);
    }
    out.write_table("methods.csv", "method,quantity,slip_percent,mean,scatter,n", rows);
    const auto &pid = results.at("pid").rbegin()->second, &prescribed = results.at("prescribed").rbegin()->second;
    out.add_difference("prescribed_less_pid_H", difference(pid, prescribed, &RunMetrics::gross_tractive_effort_N), "N",
                       "H, slip 60 %, paired");
    out.add_difference("prescribed_less_pid_Pd", difference(pid, prescribed, &RunMetrics::net_traction_N), "N",
                       "P_d, slip 60 %, paired");
}

void compare_variants(Output& out, const Results& results) {
    const auto& base = results.at("pid").at(60);
    std::vector<std::vector<std::string>> rows;
    for (const char* variant : {"pid", "walls", "light"}) {
        const auto found = results.find(variant);
        if (found == results.end()) continue;
        for (const auto& [realisation, m] : found->second.at(60))
            rows.push_back({variant, std::to_string(realisation), number(m.gross_tractive_effort_N),
                            number(m.net_traction_N), number(m.motion_resistance_N), number(m.sinkage_cm),
                            number(m.bounce_N), number(m.bounce_Hz)});
    }
    out.write_table("variants.csv", "variant,realisation,H_N,P_d_N,R_N,z_cm,bounce_N,bounce_Hz", rows);
    for (const char* variant : {"walls", "light"}) {
        const auto found = results.find(variant);
        if (found == results.end()) continue;
        const auto& runs = found->second.at(60);
        const std::string less = std::string(variant) + "_less_base_";
        out.add_difference(less + "H", difference(base, runs, &RunMetrics::gross_tractive_effort_N), "N",
                           "slip 60 %, paired");
        out.add_difference(less + "Pd", difference(base, runs, &RunMetrics::net_traction_N), "N", "slip 60 %, paired");
        out.add_difference(less + "bounce", difference(base, runs, &RunMetrics::bounce_N), "N", "slip 60 %, paired");
        out.add_difference(less + "z", difference(base, runs, &RunMetrics::sinkage_cm), "cm", "slip 60 %, paired");
    }
    out.add("base_H", values_of(base, &RunMetrics::gross_tractive_effort_N), "N", "small bin, PID, slip 60 %");
}

}  // namespace

void measure_travels(Output& out, const std::string& runs_directory) {
    const Results results = read_results(runs_directory);
    compare_methods(out, results);
    compare_variants(out, results);
}

}  // namespace ifedem::chapter2
