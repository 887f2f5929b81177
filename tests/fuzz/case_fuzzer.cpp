// The case reader: any bytes are a case or an Error(bad_input or io), and an accepted case reads back as it is written.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/error.hpp"
#include "model/case.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ifedem;
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        const std::string written = to_toml(parse_case(text, "case"));
        if (to_toml(parse_case(written, "again")) != written) std::abort();
    } catch (const Error& error) {
        const std::string message = error.what();
        if (message.empty() || (error.code() != ExitCode::bad_input && error.code() != ExitCode::io)) std::abort();
    }
    return 0;
}
