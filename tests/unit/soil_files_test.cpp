// soil.csv of a run that was interrupted is that of one that was not.
#include "record/soil_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "support/scratch.hpp"

namespace ifedem {
namespace {

constexpr double step_s = 1.6e-5;  // step 1 is printed as 0.000016, step 1 of 1.6e-6 s as 0.000002: rounded up

/// One block that sinks a little every step, with a disc attached to its top.
SoilState soil_at(int step) {
    SoilState soil;
    soil.kind = {BlockKind::element};
    const double top = 0.1 - 1e-4 * step;
    soil.position_m = {{0, 0}, {0.1, 0}, {0, top}, {0.1, top}};
    soil.attached = {{0.5, 0, 0.001, 0.002}};
    soil.attached_from = {3}, soil.attached_to = {2}, soil.attached_block = {0};
    return soil;
}

void add_steps(const std::string& directory, int first, int last, double dt) {
    for (int n = first; n <= last; ++n) add_soil_frame(directory, soil_at(n), n * dt, 1);
}

TEST(SoilFrames, EndAsThoseOfAnUninterruptedRun) {
    for (const double dt : {step_s, 0.1 * step_s}) {
        const Scratch whole, part;
        start_soil_frames(whole.path);
        add_steps(whole.path, 0, 12, dt);
        for (const int checkpoint : {1, 4, 6}) {
            start_soil_frames(part.path);
            add_steps(part.path, 0, checkpoint + 4, dt);
            std::ofstream(part.file("soil.csv"), std::ios::app) << "0.0000";  // a torn line
            drop_soil_frames_after(part.path, checkpoint * dt);
            add_steps(part.path, checkpoint + 1, 12, dt);
            EXPECT_EQ(read_text(part.file("soil.csv")), read_text(whole.file("soil.csv"))) << dt << " " << checkpoint;
        }
        EXPECT_EQ(read_soil_outline(whole.path, 5 * dt).element_m.at(0)[2].y, 0.0995);
    }
}

TEST(SoilFrames, OfADirectoryThatLostThemAreAnError) {
    const Scratch scratch;
    EXPECT_THROW(drop_soil_frames_after(scratch.path, 1), Error);
    EXPECT_THROW(add_soil_frame(scratch.path, soil_at(0), 0, 1), Error);
    EXPECT_FALSE(std::filesystem::exists(scratch.file("soil.csv")));
    std::ofstream(scratch.file("soil.csv")) << "another header\n";
    EXPECT_THROW(drop_soil_frames_after(scratch.path, 1), Error);
}

}  // namespace
}  // namespace ifedem
