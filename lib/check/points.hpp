#pragma once
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "check/cost_error.hpp"
#include "check/ledger.hpp"
#include "check/run.hpp"
#include "check/statistics.hpp"

namespace ifedem {

/// What a point is about.
struct Quantity {
    std::string_view name;
    std::string_view unit;
    std::string_view symbol;
};
/// H, P_d, R, z, then the peaks of normal and tangential contact stress.
[[nodiscard]] std::span<const Quantity> point_quantities();

using Values = std::map<std::string, double, std::less<>>;  ///< by quantity

/// A model that has no runs, such as the semi-empirical wheel: one point under each condition.
struct ModelWithoutRuns {
    std::string variant;
    std::string changes;                         ///< what it is
    Work work;                                   ///< of what it needs before it can say anything
    std::function<Values(const Case&)> predict;  ///< for a case of the plain variant
};

/// What the chart of cost against error is made of.
struct PointsRequest {
    std::string references_path;  ///< quantity,wheel,gravity,load_N,slip_percent,id: the ledger rows to compare with
    std::vector<std::string> run_dirs;  ///< each named WHAT-…; WHAT is the variant
    std::string plain = "whole";        ///< the variant that the others differ from by one change
    std::string finest;                 ///< the variant that errors are measured against
    std::string out_dir;
    std::string title;
    std::string command;
    std::function<Values(const Run&)> measure_more;  ///< what else a run's directory tells; may be empty
    std::vector<ModelWithoutRuns> models;
};

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// One variant's cost and error in one quantity under one condition. Errors, scatter and value are in the quantity's
/// unit; what is not known is NaN.
struct Point {
    int chapter = 0;
    Condition condition;
    std::string quantity;  ///< a name of point_quantities()
    std::string variant;
    std::string changes;  ///< "time_step_s 4e-05 → 1e-05"
    std::size_t n = 0;
    Work work;  ///< of one run, mean over realisations
    double relative_cost = unknown;
    double error_fine = unknown;    ///< |mean difference to the finest's same realisations|
    double error_fine_U = unknown;  ///< its 95 % half-width, of the differences themselves; NaN for n = 1
    double error_text = unknown;    ///< |mean − the text's number|
    double scatter = unknown;       ///< standard deviation over realisations; NaN for n = 1
    double value = unknown;
    std::string stopped;  ///< why there is no value: a health check's words
};

/// One picture's worth of points: a quantity under one condition, against the finest or against the text.
enum class Against { finest, text };
struct Chart {
    Condition condition;
    std::string quantity;
    Against against = Against::finest;
    PooledScatter scatter;       ///< of what errors are made of, shared by all variants
    double reading_U = 0;        ///< of the text's number
    std::size_t n = 0;           ///< realisations of most points
    double reference = unknown;  ///< the finest's mean, or the text's number
    std::vector<Point> points;
    std::vector<std::size_t> front;  ///< of `points`, by cost
    /// The least error that scatter lets one see with so many realisations; NaN if it is not known.
    [[nodiscard]] double floor(std::size_t realisations) const;
    [[nodiscard]] double error_of(const Point& point) const {
        return against == Against::finest ? point.error_fine : point.error_text;
    }
};

/// Points and what they were made with.
struct PointSet {
    std::vector<Point> points;  ///< by condition, then quantity, then variant as given
    std::vector<Chart> charts;
    std::map<double, Work> fidelity;  ///< of the text's scene, by slip
};

/// Reads runs and measures them over their window (metrics.hpp, compared_window()); a directory with stopped.txt
/// instead of run.csv holds a run that a health check stopped. Each window of the plain variant's runs that ends sooner
/// or is half as long makes a point of its own, at the cost of a travel to its end.
/// Cost: discs × steps of all three stages × the median of the variant's own ns a disc-step, relative to the text's
/// scene. Throws Error(bad_input) if the finest or the plain variant lacks a realisation that another has.
[[nodiscard]] PointSet measure_points(const PointsRequest& request, const Ledger& ledger);

/// chapter,wheel,gravity,load_N,slip_percent,quantity,variant,n,relative_cost,error_fine,error_text,scatter and, beyond
/// these, error_fine_U,value,units,disc_steps,ns_per_disc_step,changes,stopped.
[[nodiscard]] std::string points_to_csv(const std::vector<Point>& points);

/// Writes points.csv, front.csv (the fronts against the finest), figures and index.html into the request's directory.
/// The script of the figures, speed.gp, stands beside the references.
void write_points(const PointsRequest& request);

}  // namespace ifedem
