#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <map>

#include "core/error.hpp"
#include "dem/threads.hpp"
#include "topics.hpp"

namespace {

using namespace ifedem::chapter2;

int run_program(int argc, char** argv) {
    const std::map<std::string, void (*)(Output&, Effort)> topics{{"integration", measure_integration},
                                                                  {"contact", measure_contact},
                                                                  {"elements", measure_elements},
                                                                  {"traction", measure_traction},
                                                                  {"packing", measure_packing},
                                                                  {"heap", measure_heap},
                                                                  {"sand", measure_sand},
                                                                  {"footing", measure_footing},
                                                                  {"silo", measure_silo},
                                                                  {"calculix", measure_calculix}};
    CLI::App app{"chapter2_verify: measures one topic of chapter 2"};
    std::string topic, directory, runs;
    bool quick = false;
    app.add_option("topic", topic, "what to measure")->check(CLI::IsMember(topics));
    app.add_option("-o,--output", directory, "directory for its tables")->required();
    app.add_option("--travels", runs, "read the travels in this directory instead of measuring a topic");
    app.add_flag("--quick", quick, "fewer levels and realisations");
    CLI11_PARSE(app, argc, argv);
    ifedem::set_threads(1);  // samples are too small to share
    Output out(directory);
    if (!runs.empty())
        measure_travels(out, runs);
    else if (!topic.empty())
        topics.at(topic)(out, quick ? Effort::quick : Effort::full);
    else
        ifedem::fail_input("nothing to measure (neither a topic nor --travels). Give one?");
    out.finish();
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run_program(argc, argv);
    } catch (const std::exception& e) {
        fmt::print(stderr, "{}\n", e.what());
        return 4;
    }
}
