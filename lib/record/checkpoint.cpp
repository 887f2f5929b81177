#include "record/checkpoint.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "record/files.hpp"
#include "record/hdf5.hpp"
#include "record/state_fields.hpp"

// A checkpoint is an HDF5 file with 16 bytes after its end: a magic word and a checksum of all before. HDF5 ignores
// what follows its own end, so h5dump and h5py read the file; we look at the checksum first, so HDF5 never sees a
// damaged file (it may crash or loop on one). The HDF5 part is made and read in memory: the disk sees one plain write.

namespace ifedem {
namespace {

using hdf5::check;

constexpr std::array<char, 8> trailer_magic = {'i', 'f', 'e', 'd', 'e', 'm', 'c', '1'};
constexpr std::size_t trailer_size = 16;
constexpr std::int64_t format_version = 1;

// ---------------------------------------------------------------------------------------------- the layout of members

/// An aggregate of doubles, as state.hpp promises: HDF5 copies the bits without looking at them.
template <class T>
hdf5::Type array_type(const std::string& path) {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0);
    static_assert(fields_are_complete<T>(), "a member of T has no name in fields_of<T>");
    const hsize_t length = sizeof(T) / sizeof(double);
    return {H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &length), "describe a type of", path};
}

/// The one mixed row.
hdf5::Type contact_type(const std::string& path) {
    static_assert(sizeof(BoundaryContact) == 16);
    hdf5::Type type(H5Tcreate(H5T_COMPOUND, sizeof(BoundaryContact)), "describe a type of", path);
    const auto insert = [&](const char* name, std::size_t offset, hid_t kind) {
        check(H5Tinsert(type, name, offset, kind), "describe a type of", path);
    };
    insert("disc", offsetof(BoundaryContact, disc), H5T_NATIVE_UINT32);
    insert("surface", offsetof(BoundaryContact, surface), H5T_NATIVE_UINT32);
    insert("tangential_m", offsetof(BoundaryContact, tangential_m), H5T_NATIVE_DOUBLE);
    return type;
}

template <class T>
hdf5::Type type_of(const std::string& path) {
    if constexpr (std::is_same_v<T, double>)
        return hdf5::copy_type(H5T_NATIVE_DOUBLE, path);
    else if constexpr (std::is_same_v<T, std::uint32_t>)
        return hdf5::copy_type(H5T_NATIVE_UINT32, path);
    else if constexpr (std::is_same_v<T, std::uint64_t>)
        return hdf5::copy_type(H5T_NATIVE_UINT64, path);
    else if constexpr (std::is_enum_v<T>)
        return type_of<std::underlying_type_t<T>>(path);
    else if constexpr (std::is_same_v<T, BoundaryContact>)
        return contact_type(path);
    else
        return array_type<T>(path);
}

// ------------------------------------------------------------------------------------------------------------- units

/// The unit that a name ends in. Longer endings stand first.
std::string unit_of(std::string_view name) {
    struct Ending {
        std::string_view text;
        const char* unit;
    };
    static constexpr std::array endings = {
        Ending{"_rad_s2", "rad/s2"}, Ending{"_m_s2", "m/s2"}, Ending{"_rad_s", "rad/s"}, Ending{"_m_s", "m/s"},
        Ending{"_1_kg", "1/kg"},     Ending{"_rad", "rad"},   Ending{"_kg", "kg"},       Ending{"_m", "m"},
        Ending{"_Ns", "N s"},        Ending{"_Nms", "N m s"}, Ending{"_s", "s"},         Ending{"_J", "J"},
        Ending{"_N", "N"},           Ending{"_Nm", "N m"}};
    for (const Ending& ending : endings) {
        if (name.ends_with(ending.text)) return ending.unit;
    }
    return "1";
}

/// Units of one member, one a field, joined by commas.
template <class T>
std::string units_of(std::string_view member) {
    if (std::is_same_v<T, PidState>) return member.ends_with("torque") ? "rad s,rad,N m,rad" : "m s,m,N,m";
    if (!std::is_class_v<T> || std::is_same_v<T, Vec2>) return unit_of(member);
    std::string units;
    for (std::string_view rest = fields_of<T>; !rest.empty();) {
        const std::string_view field = rest.substr(0, rest.find(','));
        if (!units.empty()) units += ',';
        units += unit_of(field);
        rest.remove_prefix(std::min(rest.size(), field.size() + 1));
    }
    return units;
}

// ------------------------------------------------------------------------------------------------------ write and read

template <class T>
struct Rows {
    using Row = T;
    static constexpr bool many = false;
};
template <class T>
struct Rows<std::vector<T>> {
    using Row = T;
    static constexpr bool many = true;
};

template <class M>
void write_member(hid_t file, const std::string& path, const char* name, const M& member) {
    using Row = typename Rows<M>::Row;
    std::vector<hsize_t> extent;
    const void* data = &member;
    if constexpr (Rows<M>::many) {
        extent = {member.size()};
        data = member.data();
    }
    const hdf5::Type type = type_of<Row>(path);
    const hdf5::Space space = hdf5::simple_space(extent, path);
    const hdf5::Properties links = hdf5::link_properties(path);
    const hdf5::Properties properties = hdf5::dataset_properties(path);
    const hdf5::Dataset dataset(H5Dcreate2(file, name, type, space, links, properties, H5P_DEFAULT), "write", path);
    if (extent != std::vector<hsize_t>{0})
        check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), "write", path);
    hdf5::write_text_attribute(dataset, "units", units_of<Row>(name), path);
    hdf5::write_text_attribute(dataset, "fields", fields_of<Row>, path);
}

template <class M>
void read_member(hid_t file, const std::string& path, const char* name, M& member) {
    using Row = typename Rows<M>::Row;
    const hdf5::Dataset dataset(H5Dopen2(file, name, H5P_DEFAULT), "read " + std::string(name) + " from", path);
    const hdf5::Type stored(H5Dget_type(dataset), "read", path);
    const hdf5::Type type = type_of<Row>(path);
    const std::vector<hsize_t> extent = hdf5::extent_of(dataset, path);
    if (H5Tequal(stored, type) <= 0 || extent.size() != (Rows<M>::many ? 1U : 0U)) {
        fail_io("'" + path + "' holds " + name +
                " in another form (another version of the program wrote it). Run the case again?");
    }
    void* data = &member;
    if constexpr (Rows<M>::many) {
        member.resize(extent[0]);
        data = member.data();
        if (member.empty()) return;
    }
    check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), "read", path);
}

/// `S`: Spent, or const Spent.
template <class S, class F>
void for_each_cost(S& spent, F&& f) {
    f("spent_steps", spent.steps);
    f("spent_cpu_s", spent.cpu_s);
    f("spent_wall_s", spent.wall_s);
}

/// Access in memory only: nothing of HDF5's touches the disk.
hdf5::Properties memory_access(const std::string& path) {
    constexpr std::size_t growth = std::size_t{1} << 20;
    hdf5::Properties access(H5Pcreate(H5P_FILE_ACCESS), "prepare", path);
    check(H5Pset_fapl_core(access, growth, false), "prepare", path);
    return access;
}

std::vector<std::byte> make_image(const std::string& path, const State& state, const Case& c, const Spent& spent) {
    const hdf5::Properties access = memory_access(path);
    const hdf5::File file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), "make", path);
    hdf5::write_integer_attribute(file, "checkpoint_version", format_version, path);
    hdf5::write_integer_attribute(file, "results_version", results_version, path);
    hdf5::write_text_attribute(file, "case", to_toml(c), path);
    const auto write = [&](const char* name, const auto& member) { write_member(file, path, name, member); };
    for_each_present_member(state, write);
    for_each_cost(spent, write);
    check(H5Fflush(file, H5F_SCOPE_GLOBAL), "make", path);
    const ssize_t size = H5Fget_file_image(file, nullptr, 0);
    if (size <= 0) hdf5::fail("make", path);
    std::vector<std::byte> image(static_cast<std::size_t>(size));
    if (H5Fget_file_image(file, image.data(), image.size()) != size) hdf5::fail("make", path);
    return image;
}

void append_trailer(std::vector<std::byte>& image) {
    const std::uint64_t sum = checksum(image);
    std::array<std::byte, trailer_size> trailer{};
    std::memcpy(trailer.data(), trailer_magic.data(), trailer_magic.size());
    std::memcpy(trailer.data() + trailer_magic.size(), &sum, sizeof sum);
    image.insert(image.end(), trailer.begin(), trailer.end());
}

/// Verifies the trailer and takes it off.
void remove_trailer(std::vector<std::byte>& image, const std::string& path) {
    const std::string advice = " Resume from an earlier checkpoint, or run the case again?";
    if (image.size() <= trailer_size)
        fail_damaged("'" + path + "' is no checkpoint (too short; was it cut off?)." + advice);
    const std::byte* trailer = image.data() + image.size() - trailer_size;
    if (std::memcmp(trailer, trailer_magic.data(), trailer_magic.size()) != 0) {
        fail_damaged("'" + path +
                     "' is no complete checkpoint (its last bytes are not the mark of one; was it cut off?)." + advice);
    }
    std::uint64_t stored = 0;
    std::memcpy(&stored, trailer + trailer_magic.size(), sizeof stored);
    image.resize(image.size() - trailer_size);
    const std::uint64_t found = checksum(image);
    if (found != stored) {
        fail_damaged("'" + path + "' is damaged (checksum " + to_hex(found) + ", should be " + to_hex(stored) + ")." +
                     advice);
    }
}

Case read_stored_case(const hdf5::File& file, const std::string& path) {
    const std::string text = hdf5::read_text_attribute(file, "case", path);
    try {
        return parse_case(text, path);
    } catch (const Error& error) {
        fail_io("the case in '" + path + "' cannot be read (" + error.what() +
                "; another version of the program wrote it?). Run the case again?");
    }
}

}  // namespace

void write_checkpoint(const std::string& path, const State& state, const Case& c, const Spent& spent) {
    hdf5::silence();
    std::vector<std::byte> image = make_image(path, state, c, spent);
    append_trailer(image);
    write_bytes_atomically(path, image);
}

Checkpoint read_checkpoint(const std::string& path) { return decode_checkpoint(read_whole_file(path), path); }

Checkpoint decode_checkpoint(std::vector<std::byte> image, const std::string& path) {
    hdf5::silence();
    remove_trailer(image, path);
    const hdf5::Properties access = memory_access(path);
    check(H5Pset_file_image(access, image.data(), image.size()), "read", path);
    // HDF5 wants a name for the image, and that no file has it.
    const hdf5::File file(H5Fopen((path + ".in-memory").c_str(), H5F_ACC_RDONLY, access), "read", path);
    if (const std::int64_t version = hdf5::read_integer_attribute(file, "checkpoint_version", path);
        version != format_version) {
        fail_io("'" + path + "' has checkpoint version " + std::to_string(version) + " (this program reads " +
                std::to_string(format_version) + "). Run the case again?");
    }
    Checkpoint checkpoint;
    checkpoint.results_version = static_cast<int>(hdf5::read_integer_attribute(file, "results_version", path));
    checkpoint.c = read_stored_case(file, path);
    const auto read = [&](const char* name, auto& member) { read_member(file, path, name, member); };
    for_each_member(checkpoint.state, read);
    const auto has = [&](const char* name) {
        const htri_t there = H5Lexists(file, name, H5P_DEFAULT);
        hdf5::check(there, "read", path);
        return there > 0;
    };
    if (has("soil_kind")) for_each_soil_member(checkpoint.state, read);
    if (has("stress_block")) for_each_stress_member(checkpoint.state, read);
    if (has("soil_mass_kg")) for_each_mass_member(checkpoint.state, read);
    if (has("spent_steps")) for_each_cost(checkpoint.spent, read);
    return checkpoint;
}

}  // namespace ifedem
