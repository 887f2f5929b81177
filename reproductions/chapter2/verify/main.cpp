#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <map>

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
                                                                  {"sand", measure_sand}};
    CLI::App app{"chapter2_verify: measures one topic of chapter 2"};
    std::string topic, directory;
    bool quick = false;
    app.add_option("topic", topic, "what to measure")->required()->check(CLI::IsMember(topics));
    app.add_option("-o,--output", directory, "directory for its tables")->required();
    app.add_flag("--quick", quick, "fewer levels and realisations");
    CLI11_PARSE(app, argc, argv);
    Output out(directory);
    topics.at(topic)(out, quick ? Effort::quick : Effort::full);
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
