#pragma once
#include <string>
#include <vector>

#include "app/run_set.hpp"
#include "model/case.hpp"

namespace ifedem {

struct FitRequest {
    std::string case_path;
    std::string output;  ///< SMALLER.toml
    std::vector<Override> overrides;
    std::string quantities = "H,Pd,R,z";
    std::string tolerance = "5%";
    std::string evidence = "shown";                                  ///< or "mean": enum DifferenceEvidence
    std::string reductions = "step,depth,behind,ahead,region,mesh";  ///< what may be less, in this order
    int realisations = 3;
    RunSetOptions options;
};

/// Finds the least model of a scene: one thing after another it raises time_step_s and takes away depth, soil behind
/// the wheel at the start, soil ahead of it at the end, blocks of discs between soil elements, and elements of the
/// wheel. Discs and stages stay as they are.
///
/// Each thing is halved (the step doubled) as long as every quantity of the trial, in all realisations, stays as close
/// to the *original* case as `evidence` asks (is_small()), a quarter is taken off after the first refusal, and it is
/// left at the second (find_least_share()). What was kept stays while the next thing is tried, so small losses cannot
/// add up unseen. The step comes first, for it makes all later trials cheaper. Not run, and refused: a step beyond a
/// certain limit, and a scene that is none (a record interval below the step). Refused also: what a health check stops,
/// or a limit of the contacts as they stand. Not tried: what would save less than 1 % of the original's disc-steps (a
/// coarser mesh saves none of these, but a part of each step). The soil's elements fix the bed's size: of cases with
/// them, only step, region and mesh are tried.
///
/// Writes SMALLER.toml (`base` = the case, and the keys that differ) and SMALLER.csv (every trial with its quantities,
/// differences, half-widths, cost and decision) after each trial; runs are in SMALLER-runs/. The same command repeats
/// no complete run. Returns done, or 128 + a signal; throws Error with the original's status if that fails.
[[nodiscard]] int run_fit(const FitRequest& request);

}  // namespace ifedem
