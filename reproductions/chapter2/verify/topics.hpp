#pragma once
#include "output.hpp"

namespace ifedem::chapter2 {

void measure_integration(Output& out, Effort effort);  ///< Eqs 2.1–2.3, 2.6–2.12
void measure_contact(Output& out, Effort effort);      ///< Eqs 2.17, 2.18, section 2.5, small exact cases
void measure_elements(Output& out, Effort effort);     ///< Eqs 2.4, 2.5
void measure_traction(Output& out, Effort effort);     ///< Eqs 2.13–2.16, Fig 2-5
void measure_heap(Output& out, Effort effort);         ///< angle of repose
void measure_packing(Output& out, Effort effort);      ///< porosity of the bed
void measure_sand(Output& out, Effort effort);         ///< biaxial and confined compression
void measure_footing(Output& out, Effort effort);      ///< section 2.2: discs over soil elements
void measure_silo(Output& out, Effort effort);         ///< Janssen's stress between rough walls
void measure_calculix(Output& out, Effort effort);     ///< radial stiffness of a wheel, by CalculiX too

/// What travels that were run already say (travel.mk).
void measure_travels(Output& out, const std::string& runs_directory);

}  // namespace ifedem::chapter2
