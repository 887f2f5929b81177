// The checkpoint decoder: any bytes are a checkpoint or an Error(io). HDF5 itself is not under test: the checksum is
// verified first, so damage never reaches it, and who forges checksums can do worse.
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "core/error.hpp"
#include "record/checkpoint.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ifedem;
    const auto bytes = std::as_bytes(std::span(data, size));
    try {
        (void)decode_checkpoint({bytes.begin(), bytes.end()}, "checkpoint");
    } catch (const Error& error) {
        if (error.code() != ExitCode::io) std::abort();
    }
    return 0;
}
