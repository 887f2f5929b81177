#pragma once
#include <string>
#include <vector>

#include "app/run_set.hpp"
#include "model/case.hpp"

namespace ifedem {

struct DoubtRequest {
    std::string case_path;
    std::string directory;
    std::vector<Override> overrides;
    std::string quantities = "H,Pd,R,z";
    std::string tolerance = "5%";
    std::string increases = "depth,length,discs,region,mesh,step";  ///< what may be more
    int realisations = 3;
    RunSetOptions options;
};

/// Does the case's size or resolution decide its outcome? Runs it and variants with more of one thing each in the
/// same realisations, and writes DIR/doubt.csv, a line a variant and quantity:
/// - depth: twice the discs at the same length, with twice the time to settle;
/// - length: bed, discs and the wheel's starting place doubled: twice the soil behind the wheel, at least twice ahead;
/// - discs: half the radii, four times the discs, half the step: the same share of the contacts' limit;
/// - mesh: twice the wheel's rings and columns between lugs (not for plates and wheels from Gmsh);
/// - step: half of time_step_s;
/// - region: twice the blocks of discs between soil elements.
/// Where the finer mesh's own limit asks for it, the step is halved too; the column `changes` says so. The
/// soil's elements fix the bed's size and its discs: cases with them are doubted by region, mesh and step. Returns what
/// the program returns: done, the worst status of a variant that failed (its lines say so), or 128 + a signal. Throws
/// Error with the default's status if that fails.
[[nodiscard]] int run_doubt(const DoubtRequest& request);

}  // namespace ifedem
