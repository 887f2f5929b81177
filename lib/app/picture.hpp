#pragma once
#include <string>

#include "record/snapshot.hpp"

namespace ifedem {

/// Draws a recorded frame of a run directory again: snapshot.png near the wheel, coloured by speed, and
/// snapshot_bed.png of the whole bin, coloured by pressure. `frame` counts from 0; −1 is the last one. Throws
/// Error(io).
void draw_pictures(const std::string& run_directory, const std::string& out_directory, long frame);

/// contact_sheet.png: up to nine frames, evenly spaced over the travel.
void draw_contact_sheet(const std::string& run_directory, const std::string& out_directory, DiscColour colour);

/// travel.gif: up to thirty frames, evenly spaced, one after the other.
void draw_animation(const std::string& run_directory, const std::string& out_directory, DiscColour colour);

}  // namespace ifedem
