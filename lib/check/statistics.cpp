#include "check/statistics.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.hpp"

namespace ifedem {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double two_sided_95 = 0.975;

}  // namespace

double mean(std::span<const double> values) {
    if (values.empty()) fail_input("The mean of no values was asked for. Check that the window holds samples?");
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double standard_deviation(std::span<const double> values) {
    if (values.size() < 2) return 0;
    const double m = mean(values);
    double squares = 0;
    for (const double v : values) squares += (v - m) * (v - m);
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

double student_t_quantile(double probability, double degrees_of_freedom) {
    gsl_set_error_handler_off();
    const double t = gsl_cdf_tdist_Pinv(probability, degrees_of_freedom);
    if (!std::isfinite(t))
        fail_input("Student's t has no such quantile. Give 0 < probability < 1 and at least 1 degree of freedom?");
    return t;
}

PooledScatter pool_scatter(std::span<const std::vector<double>> groups) {
    double squares = 0;
    double freedom = 0;
    for (const auto& group : groups) {
        if (group.size() < 2) continue;
        const double s = standard_deviation(group);
        const auto nu = static_cast<double>(group.size() - 1);
        squares += nu * s * s;
        freedom += nu;
    }
    return {freedom > 0 ? std::sqrt(squares / freedom) : 0, freedom};
}

double prediction_uncertainty(double scatter, double degrees_of_freedom, std::size_t n, double reading_uncertainty) {
    const double t = student_t_quantile(two_sided_95, degrees_of_freedom);
    return std::hypot(t * scatter * std::sqrt(1 + 1 / static_cast<double>(n)), reading_uncertainty);
}

Estimate estimate(std::span<const double> values, double reading_uncertainty, const PooledScatter& pooled) {
    Estimate e;
    e.n = values.size();
    e.mean = mean(values);
    e.scatter = standard_deviation(values);
    e.borrowed = e.n < 2;
    const double s = e.borrowed ? pooled.deviation : e.scatter;
    const double freedom = e.borrowed ? pooled.degrees_of_freedom : static_cast<double>(e.n - 1);
    if (freedom < 1) {
        e.uncertainty = infinity;
        return e;
    }
    e.uncertainty = prediction_uncertainty(s, freedom, e.n, reading_uncertainty);
    return e;
}

double ratio_uncertainty(double a, double uncertainty_a, double b, double uncertainty_b) {
    // Written without dividing by a, so that a = 0 keeps the part that a's own uncertainty brings.
    return std::hypot(uncertainty_a / b, a * uncertainty_b / (b * b));
}

namespace {

/// Number of permutations of n items with k inversions, for all k: each new item adds 0 … n − 1 inversions.
std::vector<double> count_inversions(std::size_t n) {
    std::vector<double> count{1};
    for (std::size_t m = 2; m <= n; ++m) {
        std::vector<double> next(count.size() + m - 1, 0.0);
        for (std::size_t k = 0; k < count.size(); ++k)
            for (std::size_t shift = 0; shift < m; ++shift) next[k + shift] += count[k];
        count = std::move(next);
    }
    return count;
}

}  // namespace

KendallResult kendall(std::span<const double> x, std::span<const double> y) {
    if (x.size() != y.size() || x.size() < 2)
        fail_input("Kendall's tau needs two lists of one length (at least 2). Check the points of the trend?");
    const std::size_t n = x.size();
    double score = 0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) {
            const double product = (x[j] - x[i]) * (y[j] - y[i]);
            score += product > 0 ? 1 : product < 0 ? -1 : 0;
        }
    const double pairs = 0.5 * static_cast<double>(n) * static_cast<double>(n - 1);
    const auto count = count_inversions(n);
    double favourable = 0;
    double all = 0;
    for (std::size_t k = 0; k < count.size(); ++k) {
        all += count[k];
        if (pairs - 2 * static_cast<double>(k) >= score) favourable += count[k];
    }
    return {score / pairs, favourable / all};
}

std::vector<double> isotonic_fit(std::span<const double> y, std::span<const double> weights) {
    struct Block {
        double sum, weight;
        std::size_t size;
        [[nodiscard]] double level() const { return sum / weight; }
    };
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < y.size(); ++i) {
        blocks.push_back({y[i] * weights[i], weights[i], 1});
        while (blocks.size() > 1 && blocks[blocks.size() - 2].level() > blocks.back().level()) {
            const Block last = blocks.back();
            blocks.pop_back();
            blocks.back().sum += last.sum;
            blocks.back().weight += last.weight;
            blocks.back().size += last.size;
        }
    }
    std::vector<double> fit;
    fit.reserve(y.size());
    for (const auto& block : blocks) fit.insert(fit.end(), block.size, block.level());
    return fit;
}

PairedDifference paired_difference(std::span<const double> a, std::span<const double> b) {
    if (a.size() != b.size() || a.empty())
        fail_input(
            "A paired difference needs the same realisations on both sides. Run both variants with the same seeds and "
            "phases?");
    std::vector<double> d(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) d[i] = b[i] - a[i];
    PairedDifference result{mean(d), infinity, d.size()};
    if (d.size() > 1) {
        const auto n = static_cast<double>(d.size());
        result.half_width = student_t_quantile(two_sided_95, n - 1) * standard_deviation(d) / std::sqrt(n);
    }
    return result;
}

bool is_within_scatter(const PairedDifference& difference, double tolerance) {
    return std::abs(difference.mean) <= difference.half_width && difference.half_width <= tolerance;
}

}  // namespace ifedem
