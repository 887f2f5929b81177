#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace ifedem {

/// Arithmetic mean. Needs at least one value.
[[nodiscard]] double mean(std::span<const double> values);

/// Standard deviation with n − 1; 0 for fewer than two values.
[[nodiscard]] double standard_deviation(std::span<const double> values);

/// Quantile of Student's t: P(T ≤ result) = probability. Degrees of freedom ≥ 1.
[[nodiscard]] double student_t_quantile(double probability, double degrees_of_freedom);

/// Scatter that several conditions share: s² is the mean of their variances, weighted by n − 1.
struct PooledScatter {
    double deviation = 0;
    double degrees_of_freedom = 0;  ///< 0: no condition has two realisations, the scatter is unknown
};
[[nodiscard]] PooledScatter pool_scatter(std::span<const std::vector<double>> groups);

/// U = √(t²(0.975, ν) s² (1 + 1/n) + u_read²): a prediction interval, since the reference is itself one realisation,
/// with the reading uncertainty of the reference added. Needs ν ≥ 1.
[[nodiscard]] double prediction_uncertainty(double scatter, double degrees_of_freedom, std::size_t n,
                                            double reading_uncertainty);

/// Mean over realisations with its U.
struct Estimate {
    double mean = 0;
    double scatter = 0;      ///< standard deviation of the realisations; 0 if n = 1
    double uncertainty = 0;  ///< U; infinite if nothing tells the scatter
    std::size_t n = 0;
    bool borrowed = false;  ///< n = 1: the scatter is that of other conditions
};
/// With one value the scatter is taken from `pooled`.
[[nodiscard]] Estimate estimate(std::span<const double> values, double reading_uncertainty,
                                const PooledScatter& pooled = {});

/// U of a / b for independent a and b: |a/b| √((U_a/a)² + (U_b/b)²).
[[nodiscard]] double ratio_uncertainty(double a, double uncertainty_a, double b, double uncertainty_b);

/// Kendall's rank correlation (τ-a: a tie counts for neither side) and the exact probability that independent data give
/// at least this value (one-sided; Kendall 1938, Biometrika 30:81).
struct KendallResult {
    double tau = 0;
    double probability = 1;
};
[[nodiscard]] KendallResult kendall(std::span<const double> x, std::span<const double> y);

/// Non-decreasing fit with the least weighted squares, by pooling adjacent violators (Barlow et al. 1972).
[[nodiscard]] std::vector<double> isotonic_fit(std::span<const double> y, std::span<const double> weights);

/// y ≈ Σ c_k x^k with weights 1/σ².
struct PolynomialFit {
    std::vector<double> coefficients;     ///< lowest power first
    std::vector<double> standard_errors;  ///< of the coefficients, scaled by the scatter about the fit
    std::vector<double> run_errors;       ///< the same from the weights alone, right if these are 1/σ²
    double chi_squared = 0;               ///< Σ w (y − fit)²
    double degrees_of_freedom = 0;        ///< points − coefficients
    [[nodiscard]] double at(double x) const;
};
/// Throws Error(bad_input) for fewer points than coefficients + 1.
[[nodiscard]] PolynomialFit fit_polynomial(std::span<const double> x, std::span<const double> y,
                                           std::span<const double> weights, std::size_t degree);

/// Does the quadratic term pay? With run errors of ν degrees of freedom (weights 1/σ²): F(1, ν) = χ²_linear −
/// χ²_quadratic. Without: F(1, n − 3) = (χ²_linear − χ²_quadratic) / (χ²_quadratic / (n − 3)).
struct CurvatureTest {
    PolynomialFit linear;
    PolynomialFit quadratic;
    double f = 0;
    double probability = 1;          ///< of at least this F if the truth is linear
    double sagitta_share = 0;        ///< largest distance of the parabola from its chord, over the rise of the chord
    double sagitta_uncertainty = 0;  ///< 95 % half-width of the share
};
/// Needs at least four points. `run_freedom`: ν of the errors in the weights, 0 if these are relative only.
[[nodiscard]] CurvatureTest test_curvature(std::span<const double> x, std::span<const double> y,
                                           std::span<const double> weights, double run_freedom = 0);

/// Mean of b − a over realisations that share seed and lug phase, with its 95 % interval.
struct PairedDifference {
    double mean = 0;
    double half_width = 0;  ///< infinite for one pair
    std::size_t n = 0;
};
[[nodiscard]] PairedDifference paired_difference(std::span<const double> a, std::span<const double> b);

/// "Within scatter": the interval contains 0 and is narrower than the tolerance.
[[nodiscard]] bool is_within_scatter(const PairedDifference& difference, double tolerance);

}  // namespace ifedem
