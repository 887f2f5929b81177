#include "app/stress_files.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "check/csv.hpp"
#include "core/bitmath.hpp"
#include "core/error.hpp"
#include "record/files.hpp"
#include "traction/contact_stress_curve.hpp"

namespace ifedem {
namespace {

struct SegmentColumn {
    const char* name;
    double SegmentSum::*member;
};
constexpr std::array<SegmentColumn, 8> segment_columns = {{{"radial_N", &SegmentSum::radial_N},
                                                           {"circumferential_N", &SegmentSum::circumferential_N},
                                                           {"normal_N", &SegmentSum::normal_N},
                                                           {"tangential_N", &SegmentSum::tangential_N},
                                                           {"force_x_N", &SegmentSum::fx_N},
                                                           {"force_y_N", &SegmentSum::fy_N},
                                                           {"moment_Nm", &SegmentSum::moment_Nm},
                                                           {"contacts", &SegmentSum::contacts}}};
struct BlockColumn {
    const char* name;
    double StressBlock::*member;
};
constexpr std::array<BlockColumn, 7> block_columns = {{{"steps", &StressBlock::steps},
                                                       {"drawbar_N", &StressBlock::drawbar_N},
                                                       {"torque_Nm", &StressBlock::torque_Nm},
                                                       {"effective_radius_m", &StressBlock::effective_radius_m},
                                                       {"impulse_x_Ns", &StressBlock::impulse_x_Ns},
                                                       {"impulse_y_Ns", &StressBlock::impulse_y_Ns},
                                                       {"spin_Nms", &StressBlock::spin_Nms}}};

std::string mean_table(const Case& c, const StressState& stress) {
    const ContactArc arc{c.wheel.width_m, c.wheel.tread_radius_m};
    const std::vector<MeanSegment> means = mean_segments(stress);
    if (means.empty()) return {};
    const StressCurve radial = make_stress_curve(means, arc, Decomposition::radial);
    const StressCurve surface = make_stress_curve(means, arc, Decomposition::surface);
    std::string text =
        "theta_deg,radial_Pa,circumferential_Pa,normal_Pa,tangential_Pa,force_x_N,force_y_N,moment_Nm,contacts\n";
    for (std::size_t k = 0; k < radial.angle_rad.size(); ++k) {
        const SegmentSum& m = means[k].mean;
        text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n",
                            means[k].angle_rad * 180 / pi, radial.normal_Pa[k], radial.tangential_Pa[k],
                            surface.normal_Pa[k], surface.tangential_Pa[k], m.fx_N, m.fy_N, m.moment_Nm, m.contacts);
    }
    return text;
}

std::string block_table(const StressState& stress) {
    std::string text = "block,segment";
    for (const SegmentColumn& column : segment_columns) text += fmt::format(",{}", column.name);
    text += "\n";
    const std::size_t stride = stress.segment.size() / stress.block.size();
    for (std::size_t n = 0; n < stress.segment.size(); ++n) {
        if (stress.segment[n].contacts == 0) continue;
        text += fmt::format("{},{}", n / stride, n % stride + 1);
        for (const SegmentColumn& column : segment_columns)
            text += fmt::format(",{}", stress.segment[n].*column.member);
        text += "\n";
    }
    return text;
}

std::string balance_table(const StressState& stress) {
    std::string text = "block";
    for (const BlockColumn& column : block_columns) text += fmt::format(",{}", column.name);
    text += "\n";
    for (std::size_t b = 0; b < stress.block.size(); ++b) {
        text += fmt::format("{}", b);
        for (const BlockColumn& column : block_columns) text += fmt::format(",{}", stress.block[b].*column.member);
        text += "\n";
    }
    return text;
}

/// A whole number from `first` up to but without `end`, counted from 0.
std::size_t index(const CsvTable& table, const CsvRow& row, const char* column, std::size_t first, std::size_t end) {
    const double value = number_of(table, row, column);
    if (!(value >= static_cast<double>(first) && value < static_cast<double>(end) && value == std::floor(value)))
        fail_input(fmt::format("{}:{}: {} = {} does not fit the case (it counts from {} to {}). Run it again?",
                               table.path, row.line, column, value, first, end - 1));
    return static_cast<std::size_t>(value) - first;
}

}  // namespace

void write_contact_stress(const std::string& directory, const Case& c, const StressState& stress) {
    if (stress.block.empty()) return;
    write_file_atomically(directory + "/contact_stress.csv", mean_table(c, stress));
    write_file_atomically(directory + "/contact_blocks.csv", block_table(stress));
    write_file_atomically(directory + "/contact_balance.csv", balance_table(stress));
}

StressState read_contact_stress(const std::string& directory, const Case& c) {
    const std::string path = directory + "/contact_blocks.csv";
    if (!std::filesystem::exists(path))
        fail_input(
            fmt::format("{}: there is no contact_blocks.csv (the run averaged no contact forces, or did not "
                        "reach the window). Set record.stress_segments and run the case?",
                        directory));
    const CsvTable blocks = read_csv(path), balance = read_csv(directory + "/contact_balance.csv");
    StressState stress;
    const auto stride = static_cast<std::size_t>(c.record.stress_segments + 1);
    stress.block.resize(static_cast<std::size_t>(c.record.stress_blocks));
    stress.segment.resize(stress.block.size() * stride);
    for (const CsvRow& row : blocks.rows) {
        const std::size_t block = index(blocks, row, "block", 0, stress.block.size());
        const std::size_t segment = index(blocks, row, "segment", 1, stride + 1);
        for (const SegmentColumn& column : segment_columns)
            stress.segment[block * stride + segment].*column.member = number_of(blocks, row, column.name);
    }
    for (const CsvRow& row : balance.rows)
        for (const BlockColumn& column : block_columns)
            stress.block[index(balance, row, "block", 0, stress.block.size())].*column.member =
                number_of(balance, row, column.name);
    return stress;
}

}  // namespace ifedem
