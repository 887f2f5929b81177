#include "step/stages.hpp"

#include "core/hash.hpp"
#include "step/scene.hpp"

namespace ifedem {

std::string stage_hash(const Case& c, Stage stage, int results_version) {
    Hasher h;
    h.add(static_cast<std::uint64_t>(results_version));
    h.add(static_cast<std::uint64_t>(stage));
    // The bed depends neither on the wheel nor on the friction of later stages, so that loads and wheels share one bed.
    std::vector<std::string> keys = {"gravity_m_s2",
                                     "time_step_s",
                                     "integrator",
                                     "soil",
                                     "bed",
                                     "stages.consolidation_s",
                                     "record.energy_interval_s",
                                     "contact.normal_stiffness_N_m",
                                     "contact.tangential_stiffness_N_m",
                                     "contact.consolidation_friction_soil",
                                     "contact.consolidation_friction_wall",
                                     "contact.damping_ratio",
                                     "contact.rolling_factor",
                                     "contact.rolling_chord",
                                     "contact.rolling_scheme",
                                     "contact.contact_end"};
    if (c.elements.columns > 0) keys.emplace_back("elements");  // only then: other scenes keep their stages' names
    if (stage != Stage::consolidation)
        keys.insert(keys.end(),
                    {"contact", "wheel", "control", "travel.start_x_m", "stages.sinkage_s", "stages.load_ramp_s"});
    if (stage == Stage::travel) keys.insert(keys.end(), {"travel", "record"});
    h.add(to_toml_subset(c, keys));
    return to_hex(h.value());
}

double count_disc_steps(const Case& c, Stage stage) {
    const bool filled = stage == Stage::consolidation && !(c.elements.columns > 0 && c.elements.disc_columns > 0);
    return static_cast<double>(filled ? c.bed.disc_count : planned_discs(c)) *
           static_cast<double>(steps_of_stage(c, stage));
}

double count_disc_steps(const Case& c) {
    double sum = 0;
    for (const Stage stage : {Stage::consolidation, Stage::sinkage, Stage::travel}) sum += count_disc_steps(c, stage);
    return sum;
}

}  // namespace ifedem
