#pragma once
#include <hdf5.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ifedem::hdf5 {

// A thin layer over the HDF5 C API: handles that close themselves and return codes that cannot be forgotten. Nothing
// else; whoever reads it needs only the HDF5 manual.

/// Throws Error(io): "cannot <action> '<path>' (HDF5: <its innermost reason>). <what to do>".
[[noreturn]] void fail(const std::string& action, const std::string& path);

/// An HDF5 identifier that closes itself.
template <herr_t (*close_function)(hid_t)>
class Handle {
public:
    Handle() = default;
    /// Takes the identifier that an HDF5 call returned; a negative one is an error. Throws Error(io).
    Handle(hid_t id, const std::string& action, const std::string& path) : id_(id) {
        if (id_ < 0) fail(action, path);
    }
    ~Handle() {
        if (id_ >= 0) close_function(id_);
    }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    /// Closes now and checks: for files, closing is when the last bytes are written.
    void close(const std::string& path) {
        if (close_function(std::exchange(id_, -1)) < 0) fail("finish writing", path);
    }
    operator hid_t() const noexcept { return id_; }  // NOLINT: it stands where the C API takes an identifier

private:
    hid_t id_ = -1;
};

using File = Handle<H5Fclose>;
using Dataset = Handle<H5Dclose>;
using Space = Handle<H5Sclose>;
using Type = Handle<H5Tclose>;
using Attribute = Handle<H5Aclose>;
using Properties = Handle<H5Pclose>;

/// Checks a return code. Throws Error(io).
inline void check(herr_t code, const std::string& action, const std::string& path) {
    if (code < 0) fail(action, path);
}

/// HDF5 prints a page to stderr for each error unless told not to; what it has to say goes into our message instead.
/// Every function that uses HDF5 calls this first.
void silence();

/// Dataset creation: no object times (they make the bytes of equal files differ).
[[nodiscard]] Properties dataset_properties(const std::string& path);
/// Link creation: makes the groups on the way.
[[nodiscard]] Properties link_properties(const std::string& path);

/// A copy of a predefined type, so that every Type is owned alike.
[[nodiscard]] Type copy_type(hid_t predefined, const std::string& path);
[[nodiscard]] Space simple_space(const std::vector<hsize_t>& extent, const std::string& path);

void write_text_attribute(hid_t object, const char* name, const std::string& text, const std::string& path);
[[nodiscard]] std::string read_text_attribute(hid_t object, const char* name, const std::string& path);
void write_integer_attribute(hid_t object, const char* name, std::int64_t value, const std::string& path);
[[nodiscard]] std::int64_t read_integer_attribute(hid_t object, const char* name, const std::string& path);

/// Lengths of a dataset's dimensions.
[[nodiscard]] std::vector<hsize_t> extent_of(const Dataset& dataset, const std::string& path);

}  // namespace ifedem::hdf5
