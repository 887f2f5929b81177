// The mesh reader: any bytes are a wheel or an Error(bad_input), and a wheel's outline is a loop of its nodes.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/error.hpp"
#include "fem/gmsh.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ifedem;
    const std::string text(reinterpret_cast<const char*>(data), size);
    WheelCase wheel;
    wheel.rim_radius_m = 0.03;  // of the seeds
    wheel.tread_radius_m = 0.05;
    wheel.lug_pairs = 0;
    try {
        const WheelMesh made = make_gmsh_wheel(parse_gmsh(text, "mesh"), wheel, "mesh");
        const auto nodes = made.mesh.node_m.size();
        if (made.boundary.size() < 3 || made.mesh.part.size() != made.mesh.quad.size()) std::abort();
        if (std::ranges::any_of(made.boundary, [&](std::uint32_t n) { return n >= nodes; })) std::abort();
    } catch (const Error& error) {
        if (error.code() != ExitCode::bad_input) std::abort();
    }
    return 0;
}
