#include <cstdio>

#include "core/hash.hpp"
#include "step/step.hpp"

int main() {
    ifedem::Case c;
    c.bed.disc_count = 100;
    const ifedem::Scene scene = ifedem::make_scene(c, ifedem::Stage::consolidation);
    ifedem::State state = ifedem::make_initial_state(c);
    ifedem::Workspace work = ifedem::make_workspace(scene, state);
    for (int n = 0; n < 100; ++n) ifedem::step(scene, state, work);
    std::printf("state-hash: %s\n", ifedem::to_hex(ifedem::hash_state(state)).c_str());
}
