#include "check/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/bitmath.hpp"
#include "core/error.hpp"
#include "core/random.hpp"

using namespace ifedem;

TEST(Mean, AndDeviationOfSmallNumbers) {
    const std::vector<double> v{2, 4, 4, 4, 5, 5, 7, 9};  // squares about 5 sum to 32
    EXPECT_DOUBLE_EQ(mean(v), 5);
    EXPECT_DOUBLE_EQ(standard_deviation(v), std::sqrt(32.0 / 7.0));
    EXPECT_DOUBLE_EQ(standard_deviation(std::vector<double>{3}), 0);
    EXPECT_THROW(static_cast<void>(mean(std::vector<double>{})), Error);
}

TEST(StudentT, ClosedFormsForOneAndTwoDegrees) {
    // ν = 1 is Cauchy: tan(π(p − 1/2)); ν = 2: (2p − 1) √(2 / (4p(1 − p))).
    EXPECT_NEAR(student_t_quantile(0.975, 1), std::tan(pi * 0.475), 1e-9);
    EXPECT_NEAR(student_t_quantile(0.975, 2), 0.95 * std::sqrt(2 / (4 * 0.975 * 0.025)), 1e-10);
}

TEST(StudentT, TableValues) {
    // Fisher & Yates, Statistical Tables, Table III, two-sided 5 %: ν = 3, 7, 10, 30.
    EXPECT_NEAR(student_t_quantile(0.975, 3), 3.182, 5e-4);
    EXPECT_NEAR(student_t_quantile(0.975, 7), 2.365, 5e-4);
    EXPECT_NEAR(student_t_quantile(0.975, 10), 2.228, 5e-4);
    EXPECT_NEAR(student_t_quantile(0.975, 30), 2.042, 5e-4);
    EXPECT_THROW(static_cast<void>(student_t_quantile(0.975, 0)), Error);
}

TEST(Uncertainty, IsThePredictionIntervalWithReadingError) {
    // n = 3, s = 1: t(0.975, 2)² (1 + 1/3) + u² with t² = 0.9025 · 2 / 0.0975.
    const std::vector<double> v{9, 10, 11};
    const double t_squared = 0.9025 * 2 / 0.0975;
    const Estimate e = estimate(v, 0.5);
    EXPECT_DOUBLE_EQ(e.mean, 10);
    EXPECT_DOUBLE_EQ(e.scatter, 1);
    EXPECT_EQ(e.n, 3U);
    EXPECT_FALSE(e.borrowed);
    EXPECT_NEAR(e.uncertainty, std::sqrt(t_squared * 4 / 3 + 0.25), 1e-10);
}

TEST(Uncertainty, OfOneRunIsUnknownUnlessScatterIsBorrowed) {
    const std::vector<double> one{10};
    EXPECT_TRUE(std::isinf(estimate(one, 1).uncertainty));
    const std::vector<std::vector<double>> groups{{1, 3}, {5}, {2, 4}};  // variances 2 and 2, one degree each
    const PooledScatter pooled = pool_scatter(groups);
    EXPECT_DOUBLE_EQ(pooled.deviation, std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(pooled.degrees_of_freedom, 2);
    const Estimate e = estimate(one, 0, pooled);
    EXPECT_TRUE(e.borrowed);
    EXPECT_NEAR(e.uncertainty, std::sqrt(0.9025 * 2 / 0.0975 * 2 * 2), 1e-10);
}

TEST(Uncertainty, PoolingWeightsByDegreesOfFreedom) {
    const std::vector<std::vector<double>> groups{{0, 2}, {0, 3, 6}};  // variances 2 (ν 1) and 9 (ν 2)
    EXPECT_DOUBLE_EQ(pool_scatter(groups).deviation, std::sqrt(20.0 / 3.0));
}

TEST(Uncertainty, OfRatiosPropagates) {
    // 3-4-5: relative uncertainties 3 % and 4 % give 5 %.
    EXPECT_NEAR(ratio_uncertainty(10, 0.3, 20, 0.8), 0.5 * 0.05, 1e-15);
    EXPECT_NEAR(ratio_uncertainty(-10, 0.3, 20, 0.8), 0.5 * 0.05, 1e-15);
    EXPECT_NEAR(ratio_uncertainty(0, 0.3, 20, 0.8), 0.015, 1e-15);
}

TEST(Kendall, CountsConcordantPairs) {
    const std::vector<double> x{1, 2, 3, 4};
    EXPECT_DOUBLE_EQ(kendall(x, std::vector<double>{1, 2, 3, 4}).tau, 1);
    EXPECT_DOUBLE_EQ(kendall(x, std::vector<double>{4, 3, 2, 1}).tau, -1);
    EXPECT_DOUBLE_EQ(kendall(x, std::vector<double>{1, 3, 2, 4}).tau, 4.0 / 6.0);
}

TEST(Kendall, ExactProbabilitiesFromCountingPermutations) {
    const std::vector<double> x{1, 2, 3, 4};
    // Of 24 orders one has no inversion and three have one; all reach τ = −1.
    EXPECT_DOUBLE_EQ(kendall(x, std::vector<double>{1, 2, 3, 4}).probability, 1.0 / 24);
    EXPECT_DOUBLE_EQ(kendall(x, std::vector<double>{1, 3, 2, 4}).probability, 4.0 / 24);
    EXPECT_DOUBLE_EQ(kendall(x, std::vector<double>{4, 3, 2, 1}).probability, 1);
    const std::vector<double> eight{1, 2, 3, 4, 5, 6, 7, 8};
    const std::vector<double> five_inversions{4, 2, 1, 3, 5, 6, 8, 7};
    EXPECT_DOUBLE_EQ(kendall(eight, five_inversions).tau, (28.0 - 2 * 5) / 28);
    // n = 8, S = 16: Kendall, Rank Correlation Methods, appendix table 1 gives 0.031.
    EXPECT_NEAR(kendall(eight, std::vector<double>{4, 3, 1, 2, 5, 6, 8, 7}).probability, 0.031, 5e-4);
}

TEST(Isotonic, PoolsViolators) {
    const std::vector<double> equal(4, 1.0);
    const std::vector<double> fit = isotonic_fit(std::vector<double>{1, 3, 2, 4}, equal);
    EXPECT_EQ(fit, (std::vector<double>{1, 2.5, 2.5, 4}));
    const std::vector<double> weighted = isotonic_fit(std::vector<double>{3, 0}, std::vector<double>{2, 1});
    EXPECT_EQ(weighted, (std::vector<double>{2, 2}));
    EXPECT_EQ(isotonic_fit(std::vector<double>{4, 3, 2, 1}, equal), (std::vector<double>{2.5, 2.5, 2.5, 2.5}));
}

TEST(Isotonic, AgreesWithTheMaxMinFormula) {
    // fit_i = max over s ≤ i of min over t ≥ i of the weighted mean of s … t (Robertson, Wright & Dykstra 1988, 1.4.4).
    Random random{11};
    for (int trial = 0; trial < 50; ++trial) {
        const std::size_t n = 2 + random.below(8);
        std::vector<double> y(n), w(n);
        for (std::size_t k = 0; k < n; ++k) {
            y[k] = random.uniform();
            w[k] = 0.1 + random.uniform();
        }
        const auto fit = isotonic_fit(y, w);
        for (std::size_t i = 0; i < n; ++i) {
            double best = -1e300;
            for (std::size_t s = 0; s <= i; ++s) {
                double least = 1e300;
                for (std::size_t t = i; t < n; ++t) {
                    double sum = 0, weight = 0;
                    for (std::size_t k = s; k <= t; ++k) {
                        sum += w[k] * y[k];
                        weight += w[k];
                    }
                    least = std::min(least, sum / weight);
                }
                best = std::max(best, least);
            }
            EXPECT_NEAR(fit[i], best, 1e-12);
        }
    }
}

TEST(Fit, RecoversAParabola) {
    const std::vector<double> x{0, 1, 2, 3, 5}, w{1, 2, 3, 4, 5};
    std::vector<double> y;
    for (const double v : x) y.push_back(2 - 3 * v + 0.5 * v * v);
    const auto fit = fit_polynomial(x, y, w, 2);
    EXPECT_NEAR(fit.coefficients[0], 2, 1e-11);
    EXPECT_NEAR(fit.coefficients[1], -3, 1e-11);
    EXPECT_NEAR(fit.coefficients[2], 0.5, 1e-11);
    EXPECT_NEAR(fit.at(10), 22, 1e-9);
    EXPECT_THROW(static_cast<void>(fit_polynomial(std::vector<double>{1, 2}, std::vector<double>{1, 2},
                                                  std::vector<double>{1, 1}, 1)),
                 Error);
}

TEST(Fit, WeightedLineAgreesWithTheNormalEquations) {
    // Points (0,0), (1,1), (2,1) with weights 1, 1, 2: Σw 4, Σwx 5, Σwxx 9, Σwy 3, Σwxy 5: slope (4·5 − 5·3)/11 = 5/11.
    const auto fit =
        fit_polynomial(std::vector<double>{0, 1, 2}, std::vector<double>{0, 1, 1}, std::vector<double>{1, 1, 2}, 1);
    EXPECT_NEAR(fit.coefficients[1], 5.0 / 11, 1e-12);
    EXPECT_NEAR(fit.coefficients[0], (3 - 25.0 / 11) / 4, 1e-12);
    // Residuals −2/11, 4/11, −1/11: Σ w r² = (4 + 16 + 2)/121; one degree of freedom; Var(slope) = s² Σw / 11.
    EXPECT_NEAR(fit.chi_squared, 22.0 / 121, 1e-12);
    EXPECT_NEAR(fit.standard_errors[1], std::sqrt(22.0 / 121 * 4 / 11), 1e-12);
}

TEST(Curvature, FTestByOrthogonalPolynomials) {
    // At five equal steps the quadratic contrast is (2,−1,−2,−1,2)/√14 (Fisher & Yates, Table XXIII); what neither it
    // nor the linear one takes is the residual.
    const std::vector<double> x{-2, -1, 0, 1, 2}, w(5, 1.0), y{0, 1, 2, 5, 6};
    const double quadratic = (2 * 0 - 1 * 1 - 2 * 2 - 1 * 5 + 2 * 6) / std::sqrt(14.0);
    const double linear = (-2 * 0 - 1 * 1 + 1 * 5 + 2 * 6) / std::sqrt(10.0);
    const double total = 0 + 1 + 4 + 25 + 36 - 14.0 * 14.0 / 5;
    const double rest = total - linear * linear - quadratic * quadratic;
    const auto test = test_curvature(x, y, w);
    EXPECT_NEAR(test.f, quadratic * quadratic / (rest / 2), 1e-9);
    // F with (1, 2) degrees: P(F > f) = 1 − √(f / (f + 2)).
    EXPECT_NEAR(test.probability, 1 - std::sqrt(test.f / (test.f + 2)), 1e-12);
}

TEST(Curvature, SagittaIsTheParabolasDistanceFromItsChord) {
    // y = 10 x + x² on 0 … 4: chord rises 56, largest distance c L²/4 = 4; the alternating part keeps the fit's rest
    // above 0.
    std::vector<double> x, y, w;
    for (int k = 0; k <= 8; ++k) {
        x.push_back(0.5 * k);
        y.push_back(10 * x.back() + x.back() * x.back());
        w.push_back(1);
    }
    const auto exact = test_curvature(x, y, w);
    EXPECT_NEAR(exact.sagitta_share, 4.0 / 56, 1e-9);
    EXPECT_NEAR(exact.sagitta_uncertainty, 0, 1e-6);
    EXPECT_LT(exact.probability, 1e-9);
}

TEST(Paired, IntervalOfTheMeanDifference) {
    const std::vector<double> a{1, 2, 3}, b{2, 4, 6};  // differences 1, 2, 3: mean 2, s 1
    const auto d = paired_difference(a, b);
    EXPECT_DOUBLE_EQ(d.mean, 2);
    EXPECT_NEAR(d.half_width, 0.95 * std::sqrt(2 / 0.0975) / std::sqrt(3.0), 1e-9);
    EXPECT_TRUE(is_within_scatter(d, 3));
    EXPECT_FALSE(is_within_scatter(d, 2));
    EXPECT_FALSE(is_within_scatter({3, 2.5, 3}, 10));
    EXPECT_FALSE(is_within_scatter(paired_difference(std::vector<double>{1}, std::vector<double>{1}), 1e9));
    EXPECT_THROW(static_cast<void>(paired_difference(a, std::vector<double>{1})), Error);
}
