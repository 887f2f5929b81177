#pragma once
#include <string>

namespace ifedem {

struct SurfaceRequest {
    std::string run, output;
};

/// The soil's surface in the last and the first frame of a run, "x_m,top_m,first_m": the highest of discs, attached
/// discs and elements in each of many columns of the bin. Throws Error.
void write_surface(const SurfaceRequest& request);

}  // namespace ifedem
