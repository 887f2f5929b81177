// The wheel's elements against CalculiX: the same mesh, materials and supports, rim held, the lowest nodes pressed
// upwards by a hundredth of a millimetre, so that both are linear. The reaction over the way is a radial stiffness.
//
// Plane strain is CalculiX's CPE4 as it stands. Its CPS4 is not our plane stress: it becomes a brick whose nodes share
// their change of thickness, stiffer on a coarse mesh. But plane stress with (E, ν) has the D-matrix of plane strain
// with E (1 + 2ν)/(1 + ν)² and ν/(1 + ν), so CPE4 takes these; CPS4 is measured beside it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "check/csv.hpp"
#include "core/error.hpp"
#include "fem/equilibrium.hpp"
#include "fem/mesh.hpp"
#include "support/quad_meshes.hpp"
#include "topics.hpp"

namespace ifedem::chapter2 {
namespace {

constexpr double press_m = 1e-5;

struct Problem {
    WheelCase wheel;
    WheelMesh mesh;
    std::vector<std::uint32_t> pressed;
};

Problem make_problem(double intermediate_Pa, PlaneState plane) {
    Problem p;
    p.wheel.intermediate.young_Pa = intermediate_Pa;
    p.wheel.plane = plane;
    p.mesh = make_wheel_mesh(p.wheel);
    const auto& node = p.mesh.mesh.node_m;
    double lowest = 0;
    for (const Vec2 x : node) lowest = std::min(lowest, x.y);
    for (std::uint32_t n = 0; n < node.size(); ++n)
        if (node[n].y < lowest + 1e-4) p.pressed.push_back(n);
    return p;
}

double stiffness_here_N_m(const Problem& p) {
    const ElementSet set = make_elements(p.mesh.mesh, wheel_materials(p.wheel), p.wheel.width_m, p.wheel.plane);
    const auto& node = p.mesh.mesh.node_m;
    Supports supports{std::vector<std::uint8_t>(2 * node.size(), 0), std::vector<Vec2>(node.size())};
    StaticState state{node, {}};
    for (const std::uint32_t n : p.mesh.rigid) supports.held[2 * n] = supports.held[2 * n + 1] = 1;
    for (const std::uint32_t n : p.pressed) supports.held[2 * n + 1] = 1, state.position_m[n].y += press_m;
    if (find_equilibrium(set, supports, state) != Convergence::reached) return std::nan("");
    double push = 0;
    const std::vector<Vec2> force = scene::find_force(set, state.position_m);
    for (const std::uint32_t n : p.pressed) push -= force[n].y;
    return push / press_m;
}

enum class Form { plane_strain, equivalent_strain, thin_cps4 };

/// CalculiX's input: a set of each part that occurs, with its material.
std::string to_input(const Problem& p, Form form, double thickness_m) {
    const char* element = form == Form::thin_cps4 ? "CPS4" : "CPE4";
    const Mesh& mesh = p.mesh.mesh;
    std::string text = "*NODE\n";
    for (std::size_t n = 0; n < mesh.node_m.size(); ++n)
        text += fmt::format("{},{:.12g},{:.12g},0\n", n + 1, mesh.node_m[n].x, mesh.node_m[n].y);
    const auto materials = wheel_materials(p.wheel);
    for (std::size_t part = 0; part < materials.size(); ++part) {
        std::string elements;
        for (std::size_t k = 0; k < mesh.quad.size(); ++k)
            if (static_cast<std::size_t>(mesh.part[k]) == part)
                elements += fmt::format("{},{},{},{},{}\n", k + 1, mesh.quad[k][0] + 1, mesh.quad[k][1] + 1,
                                        mesh.quad[k][2] + 1, mesh.quad[k][3] + 1);
        if (elements.empty()) continue;
        double young_Pa = materials[part].young_Pa, nu = materials[part].poisson;
        if (form == Form::equivalent_strain) young_Pa *= (1 + 2 * nu) / ((1 + nu) * (1 + nu)), nu /= 1 + nu;
        text += fmt::format("*ELEMENT,TYPE={},ELSET=E{}\n{}*MATERIAL,NAME=M{}\n*ELASTIC\n{:.12g},{:.12g}\n", element,
                            part, elements, part, young_Pa, nu);
        text += fmt::format("*SOLID SECTION,ELSET=E{},MATERIAL=M{}\n{:.12g}\n", part, part, thickness_m);
    }
    text += "*NSET,NSET=PRESSED\n";
    for (const std::uint32_t n : p.pressed) text += fmt::format("{}\n", n + 1);
    text += "*BOUNDARY\n";
    for (const std::uint32_t n : p.mesh.rigid) text += fmt::format("{},1,2\n", n + 1);
    return text +
           fmt::format("*STEP\n*STATIC\n*BOUNDARY\nPRESSED,2,2,{:.12g}\n*NODE PRINT,NSET=PRESSED\nRF\n*END STEP\n",
                       press_m);
}

/// Runs in its directory: the solver leaves files of fixed names where it runs.
double stiffness_calculix_N_m(const Problem& p, Form form, const std::string& directory, const std::string& name) {
    const std::string job = directory + "/" + name;
    // Thin, so that no shear across the thickness stiffens CPS4.
    const double thickness_m = form == Form::thin_cps4 ? 1e-4 : p.wheel.width_m;
    write_text(job + ".inp", to_input(p, form, thickness_m));
    if (std::system(fmt::format("cd {0} && OMP_NUM_THREADS=1 ccx {1} > {1}.log 2>&1", directory, name).c_str()) != 0)
        fail_input(
            fmt::format("CalculiX did not solve {}.inp (is it installed?). Run apt-get install calculix-ccx, or "
                        "read {}.log?",
                        job, job));
    // "node fx fy fz" after a heading.
    std::ifstream file(job + ".dat");
    double push = 0;
    std::size_t found = 0;
    for (std::string line; std::getline(file, line);) {
        std::istringstream cells(line);
        double node = 0, fx = 0, fy = 0, fz = 0;
        if (cells >> node >> fx >> fy >> fz) push += fy, ++found;
    }
    if (found != p.pressed.size())
        fail_input(fmt::format("{}.dat holds {} reactions of {} (CalculiX writes another form). Read the file?", job,
                               found, p.pressed.size()));
    return push / press_m * p.wheel.width_m / thickness_m;
}

}  // namespace

void measure_calculix(Output& out, Effort) {
    std::vector<std::vector<std::string>> rows;
    for (const PlaneState plane : {PlaneState::stress, PlaneState::strain}) {
        const std::string state = plane == PlaneState::stress ? "stress" : "strain";
        for (const auto& [name, young_Pa] : {std::pair{"B3", 0.05e6}, std::pair{"B6", 0.3e6}}) {
            const Problem p = make_problem(young_Pa, plane);
            const double here = 1e-3 * stiffness_here_N_m(p);
            const std::string job = fmt::format("{}-{}", name, state);
            const Form form = plane == PlaneState::stress ? Form::equivalent_strain : Form::plane_strain;
            const double there = 1e-3 * stiffness_calculix_N_m(p, form, out.directory(), job);
            out.add(fmt::format("calculix_{}_{}", name, state), here / there, "-",
                    fmt::format("{:.5g} N/mm here, {:.5g} N/mm there", here, there));
            rows.push_back({name, state, number(here), number(there)});
            if (plane == PlaneState::stress)
                out.add(fmt::format("calculix_{}_cps4", name),
                        1e-3 * stiffness_calculix_N_m(p, Form::thin_cps4, out.directory(), job + "-cps4") / here, "-",
                        "CalculiX’s own plane stress element over ours: nodes share their change of thickness");
        }
    }
    out.write_table("calculix.csv", "wheel,plane,here_N_mm,calculix_N_mm", rows);
}

}  // namespace ifedem::chapter2
