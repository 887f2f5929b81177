// Where methods fail: each topic writes its map as CSV and adds to measurements.csv.
#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <map>

#include "maps.hpp"
#include "record/files.hpp"

namespace ifedem::maps {

void Output::measured(const std::string& name, double value, const std::string& units, const std::string& note) {
    measurements += fmt::format("{},{:.10g},{},,1,\"{}\"\n", name, value, units, note);
}

void Output::write(const std::string& file, const std::string& text) const {
    write_file_atomically(directory + "/" + file, text);
}

}  // namespace ifedem::maps

int main(int argc, char** argv) {
    using namespace ifedem::maps;
    const std::map<std::string, void (*)(Output&)> topics{
        {"contacts", map_contacts}, {"elements", map_elements}, {"control", map_control}, {"rolling", map_rolling},
        {"coupling", map_coupling}, {"scenes", map_scenes},     {"cost", map_cost}};
    CLI::App app{"chapter2_limits: maps of where methods fail"};
    std::string topic;
    Output out;
    bool quick = false;
    app.add_option("topic", topic, "which map")->required()->check(CLI::IsMember(topics));
    app.add_option("-o,--output", out.directory, "directory of the tables")->required();
    app.add_flag("--quick", quick, "fewer points");
    CLI11_PARSE(app, argc, argv);
    out.effort = quick ? Effort::quick : Effort::full;
    try {
        std::filesystem::create_directories(out.directory);
        omp_set_num_threads(1);
        topics.at(topic)(out);
        out.write("measured-" + topic + ".csv", out.measurements);
    } catch (const std::exception& e) {
        fmt::print(stderr, "{}: {}\n", topic, e.what());
        return 4;
    }
    return 0;
}
