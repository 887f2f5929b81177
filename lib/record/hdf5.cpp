#include "record/hdf5.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string_view>

#include "core/error.hpp"
#include "record/files.hpp"

namespace ifedem::hdf5 {
namespace {

/// The first entry from the inside is the one that knows the cause.
herr_t keep_innermost(unsigned depth, const H5E_error2_t* entry, void* text) {
    if (depth == 0 && entry->desc != nullptr) *static_cast<std::string*>(text) = entry->desc;
    return 0;
}

std::string innermost_error() {
    std::string text;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &text);
    return text.empty() ? "no reason given" : text;
}

}  // namespace

void fail(const std::string& action, const std::string& path) {
    const std::string reason = innermost_error();
    // A failed read or write is told as a page of numbers, the system's reason among them.
    constexpr std::string_view mark = "errno = ";
    if (const std::size_t at = reason.find(mark); at != std::string::npos) {
        errno = std::atoi(reason.c_str() + at + mark.size());
        fail_errno(action, path);
    }
    fail_io("cannot " + action + " '" + path + "' (HDF5: " + reason +
            "). Check free disk space, the permissions of the directory and that this program wrote the file?");
}

void silence() {
    // HDF5 1.10 ends the program with a segmentation fault when it cleans up at exit after a disk was full.
    static const herr_t no_cleanup = H5dont_atexit();
    (void)no_cleanup;
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Properties dataset_properties(const std::string& path) {
    Properties properties(H5Pcreate(H5P_DATASET_CREATE), "prepare", path);
    check(H5Pset_obj_track_times(properties, false), "prepare", path);
    return properties;
}

Properties link_properties(const std::string& path) {
    Properties properties(H5Pcreate(H5P_LINK_CREATE), "prepare", path);
    check(H5Pset_create_intermediate_group(properties, 1), "prepare", path);
    return properties;
}

Type copy_type(hid_t predefined, const std::string& path) { return {H5Tcopy(predefined), "describe a type of", path}; }

Space simple_space(const std::vector<hsize_t>& extent, const std::string& path) {
    if (extent.empty()) return {H5Screate(H5S_SCALAR), "describe a size in", path};
    return {H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), "describe a size in", path};
}

void write_text_attribute(hid_t object, const char* name, const std::string& text, const std::string& path) {
    const Type type = copy_type(H5T_C_S1, path);
    check(H5Tset_size(type, std::max<std::size_t>(text.size(), 1)), "describe", path);
    check(H5Tset_strpad(type, H5T_STR_NULLPAD), "describe", path);
    check(H5Tset_cset(type, H5T_CSET_UTF8), "describe", path);
    const Space space = simple_space({}, path);
    const Attribute attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), "write", path);
    check(H5Awrite(attribute, type, text.c_str()), "write", path);
}

std::string read_text_attribute(hid_t object, const char* name, const std::string& path) {
    const Attribute attribute(H5Aopen(object, name, H5P_DEFAULT), "read", path);
    const Type type(H5Aget_type(attribute), "read", path);
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0) fail("read", path);
    std::string text(H5Tget_size(type), '\0');
    if (text.empty()) fail("read", path);
    check(H5Aread(attribute, type, text.data()), "read", path);
    text.resize(std::min(text.size(), text.find('\0')));
    return text;
}

void write_integer_attribute(hid_t object, const char* name, std::int64_t value, const std::string& path) {
    const Space space = simple_space({}, path);
    const Attribute attribute(H5Acreate2(object, name, H5T_NATIVE_INT64, space, H5P_DEFAULT, H5P_DEFAULT), "write",
                              path);
    check(H5Awrite(attribute, H5T_NATIVE_INT64, &value), "write", path);
}

std::int64_t read_integer_attribute(hid_t object, const char* name, const std::string& path) {
    const Attribute attribute(H5Aopen(object, name, H5P_DEFAULT), "read", path);
    std::int64_t value = 0;
    check(H5Aread(attribute, H5T_NATIVE_INT64, &value), "read", path);
    return value;
}

std::vector<hsize_t> extent_of(const Dataset& dataset, const std::string& path) {
    const Space space(H5Dget_space(dataset), "read", path);
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank < 0) fail("read", path);
    std::vector<hsize_t> extent(static_cast<std::size_t>(rank));
    if (rank > 0) check(H5Sget_simple_extent_dims(space, extent.data(), nullptr), "read", path);
    return extent;
}

}  // namespace ifedem::hdf5
