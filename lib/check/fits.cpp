#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_poly.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "check/statistics.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

struct Free {
    void operator()(gsl_matrix* m) const { gsl_matrix_free(m); }
    void operator()(gsl_vector* v) const { gsl_vector_free(v); }
    void operator()(gsl_multifit_linear_workspace* w) const { gsl_multifit_linear_free(w); }
};
using Matrix = std::unique_ptr<gsl_matrix, Free>;
using Vector = std::unique_ptr<gsl_vector, Free>;
using Workspace = std::unique_ptr<gsl_multifit_linear_workspace, Free>;

}  // namespace

double PolynomialFit::at(double x) const {
    return gsl_poly_eval(coefficients.data(), static_cast<int>(coefficients.size()), x);
}

PolynomialFit fit_polynomial(std::span<const double> x, std::span<const double> y, std::span<const double> weights,
                             std::size_t degree) {
    const std::size_t n = x.size();
    const std::size_t terms = degree + 1;
    if (n < terms + 1 || y.size() != n || weights.size() != n)
        fail_input("Too few points for a fit (it needs one more than it has coefficients). Run more slips?");
    gsl_set_error_handler_off();
    const Matrix design(gsl_matrix_alloc(n, terms));
    const Matrix covariance(gsl_matrix_alloc(terms, terms));
    const Vector values(gsl_vector_alloc(n));
    const Vector weight(gsl_vector_alloc(n));
    const Vector solution(gsl_vector_alloc(terms));
    const Workspace workspace(gsl_multifit_linear_alloc(n, terms));
    for (std::size_t i = 0; i < n; ++i) {
        double power = 1;
        for (std::size_t k = 0; k < terms; ++k, power *= x[i]) gsl_matrix_set(design.get(), i, k, power);
        gsl_vector_set(values.get(), i, y[i]);
        gsl_vector_set(weight.get(), i, weights[i]);
    }
    PolynomialFit fit;
    const int status = gsl_multifit_wlinear(design.get(), weight.get(), values.get(), solution.get(), covariance.get(),
                                            &fit.chi_squared, workspace.get());
    if (status != GSL_SUCCESS)
        fail_input("A polynomial fit failed (the points may coincide). Check the slips of the runs?");
    fit.degrees_of_freedom = static_cast<double>(n - terms);
    const double scale = fit.chi_squared / fit.degrees_of_freedom;
    for (std::size_t k = 0; k < terms; ++k) {
        fit.coefficients.push_back(gsl_vector_get(solution.get(), k));
        const double variance = std::max(0.0, gsl_matrix_get(covariance.get(), k, k));
        fit.standard_errors.push_back(std::sqrt(variance * scale));
        fit.run_errors.push_back(std::sqrt(variance));
    }
    return fit;
}

CurvatureTest test_curvature(std::span<const double> x, std::span<const double> y, std::span<const double> weights,
                             double run_freedom) {
    CurvatureTest test;
    test.linear = fit_polynomial(x, y, weights, 1);
    test.quadratic = fit_polynomial(x, y, weights, 2);
    const bool is_known = run_freedom >= 1;
    const double freedom = is_known ? run_freedom : test.quadratic.degrees_of_freedom;
    const double gain = std::max(0.0, test.linear.chi_squared - test.quadratic.chi_squared);
    const double rest = is_known ? 1 : test.quadratic.chi_squared / freedom;
    test.f = rest > 0 ? gain / rest : gain > 0 ? std::numeric_limits<double>::infinity() : 0;
    test.probability = std::isinf(test.f) ? 0 : gsl_cdf_fdist_Q(test.f, 1, freedom);

    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    const double span = *high - *low;
    const double rise = std::abs(test.quadratic.at(*high) - test.quadratic.at(*low));
    // A parabola a + b x + c x² lies |c| L²/4 off its chord of length L, in the middle.
    const double per_curvature = span * span / 4 / rise;
    test.sagitta_share = std::abs(test.quadratic.coefficients[2]) * per_curvature;
    const auto& errors = is_known ? test.quadratic.run_errors : test.quadratic.standard_errors;
    test.sagitta_uncertainty = student_t_quantile(0.975, freedom) * errors[2] * per_curvature;
    return test;
}

}  // namespace ifedem
