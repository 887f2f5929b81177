#include "record/frame_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <span>
#include <type_traits>

#include "core/error.hpp"
#include "record/checkpoint.hpp"
#include "record/hdf5.hpp"

namespace ifedem {
namespace {

using hdf5::check;

// ------------------------------------------------------------------------------------------------------------ columns

template <class M>
struct Element {
    using Type = M;
    static constexpr bool many = false;
};
template <class T>
struct Element<std::vector<T>> {
    using Type = T;
    static constexpr bool many = true;
};
template <class M>
using ElementOf = typename Element<std::remove_const_t<M>>::Type;

/// HDF5 type of a number; a Vec2 is a last dimension of two numbers.
template <class T>
hid_t number_type() {
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Vec2>)
        return H5T_NATIVE_DOUBLE;
    else if constexpr (std::is_same_v<T, float>)
        return H5T_NATIVE_FLOAT;
    else if constexpr (std::is_same_v<T, std::uint32_t>)
        return H5T_NATIVE_UINT32;
    else if constexpr (std::is_same_v<T, std::uint8_t>)
        return H5T_NATIVE_UINT8;
    else if constexpr (std::is_enum_v<T>)
        return number_type<std::underlying_type_t<T>>();
    else
        return H5T_NATIVE_UINT64;
}

/// Dimensions of `frames` rows of `length` elements; a column of one value a frame has no second dimension.
template <class T>
std::vector<hsize_t> dimensions(hsize_t frames, Extent extent, hsize_t length) {
    std::vector<hsize_t> result = {frames};
    if (extent != Extent::one) result.push_back(length);
    if (std::is_same_v<T, Vec2>) result.push_back(2);
    return result;
}

std::uint64_t room_of(Extent extent, const FrameRoom& room) {
    if (extent == Extent::discs) return room.discs;
    return extent == Extent::nodes ? room.nodes : 1;
}

template <class M>
std::span<const std::byte> bytes_of(const M& member) {
    if constexpr (Element<M>::many)
        return std::as_bytes(std::span(member));
    else
        return std::as_bytes(std::span(&member, 1));
}

// ------------------------------------------------------------------------------------------------- opening and making

/// No locks: the file is whole at every instant, so a reader need not keep the writer out, nor the writer a reader.
hdf5::Properties file_access(const std::string& path) {
    hdf5::Properties access(H5Pcreate(H5P_FILE_ACCESS), "prepare", path);
    check(H5Pset_file_locking(access, false, true), "prepare", path);
    return access;
}

hdf5::File open_to_read(const std::string& path) {
    hdf5::silence();
    (void)OpenFile(path, O_RDONLY).size();  // a missing or unreadable file gets the system's reason
    return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, file_access(path)), "read", path};
}

hdf5::Dataset open_dataset(const hdf5::File& file, const char* name, const std::string& path) {
    return {H5Dopen2(file, name, H5P_DEFAULT), "read " + std::string(name) + " from", path};
}

/// Contiguous, its place fixed now, left unwritten.
hdf5::Dataset make_dataset(const hdf5::File& file, const char* name, const char* unit, hid_t type,
                           const std::vector<hsize_t>& extent, const std::string& path) {
    const hdf5::Properties properties = hdf5::dataset_properties(path);
    check(H5Pset_layout(properties, H5D_CONTIGUOUS), "prepare", path);
    check(H5Pset_alloc_time(properties, H5D_ALLOC_TIME_EARLY), "prepare", path);
    check(H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER), "prepare", path);
    const hdf5::Space space = hdf5::simple_space(extent, path);
    const hdf5::Properties links = hdf5::link_properties(path);
    hdf5::Dataset dataset(H5Dcreate2(file, name, type, space, links, properties, H5P_DEFAULT), "write", path);
    hdf5::write_text_attribute(dataset, "units", unit, path);
    return dataset;
}

template <class T>
void write_table(const hdf5::File& file, const char* name, const char* unit, const std::vector<hsize_t>& extent,
                 const T* data, const std::string& path) {
    const hdf5::Dataset dataset = make_dataset(file, name, unit, number_type<T>(), extent, path);
    if (extent[0] > 0) check(H5Dwrite(dataset, number_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, data), "write", path);
}

void make_file(const std::string& path, const FrameFileHeader& header, const FrameRoom& room) {
    hdf5::silence();
    hdf5::File file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, file_access(path)), "make", path);
    hdf5::write_text_attribute(file, "case", header.case_text, path);
    hdf5::write_integer_attribute(file, "results_version", results_version, path);
    const std::uint64_t no_frames = 0;
    const hdf5::Dataset count = make_dataset(file, "frame_count", "1", H5T_NATIVE_UINT64, {}, path);
    check(H5Dwrite(count, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &no_frames), "write", path);

    const Mesh& mesh = header.mesh;
    const hsize_t quads = mesh.quad.size();
    write_table(file, "wheel/reference_m", "m", {mesh.node_m.size(), 2}, mesh.node_m.data(), path);
    write_table(file, "wheel/quad", "1", {quads, 4}, quads > 0 ? mesh.quad.front().data() : nullptr, path);
    write_table(file, "wheel/part", "1", {quads}, mesh.part.data(), path);
    std::vector<std::uint32_t> index(room.discs);  // ParaView's Polyvertex wants the points by number
    std::iota(index.begin(), index.end(), 0U);
    write_table(file, "discs/index", "1", {room.discs}, index.data(), path);

    (void)make_dataset(file, "frames/disc_count", "1", H5T_NATIVE_UINT64, {room.frames}, path);
    (void)make_dataset(file, "frames/node_count", "1", H5T_NATIVE_UINT64, {room.frames}, path);
    const Frame shape;
    for_each_column(shape, [&](const char* name, const char* unit, Extent extent, const auto& member) {
        using T = ElementOf<std::remove_reference_t<decltype(member)>>;
        (void)make_dataset(file, name, unit, number_type<T>(),
                           dimensions<T>(room.frames, extent, room_of(extent, room)), path);
    });
    file.close(path);
}

// ------------------------------------------------------------------------------------------------------------ reading

template <class T>
std::vector<T> read_all(const hdf5::File& file, const char* name, std::size_t count, const std::string& path) {
    const hdf5::Dataset dataset = open_dataset(file, name, path);
    hsize_t stored = 1;
    for (const hsize_t length : hdf5::extent_of(dataset, path)) stored *= length;
    std::vector<T> values(count);
    if (stored != count) fail_io("'" + path + "' is damaged (" + name + " has another length). Run the case again?");
    if (count > 0) {
        check(H5Dread(dataset, number_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read", path);
    }
    return values;
}

/// The part of a column that belongs to one frame.
template <class T>
void read_row(const hdf5::File& file, const char* name, Extent extent, std::uint64_t number, std::span<T> values,
              const std::string& path) {
    if (values.empty()) return;
    const hdf5::Dataset dataset = open_dataset(file, name, path);
    const std::vector<hsize_t> count = dimensions<T>(1, extent, values.size());
    std::vector<hsize_t> start(count.size(), 0);
    start[0] = number;
    const hdf5::Space place(H5Dget_space(dataset), "read", path);
    check(H5Sselect_hyperslab(place, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), "read", path);
    const hdf5::Space memory = hdf5::simple_space(count, path);
    check(H5Dread(dataset, number_type<T>(), memory, place, H5P_DEFAULT, values.data()), "read", path);
}

FrameRoom read_room(const hdf5::File& file, const std::string& path) {
    const auto discs = hdf5::extent_of(open_dataset(file, "discs/position_m", path), path);
    const auto nodes = hdf5::extent_of(open_dataset(file, "wheel/position_m", path), path);
    if (discs.size() != 3 || nodes.size() != 3) fail_io("'" + path + "' is no result of this program. Check the path?");
    return {discs[0], discs[1], nodes[1]};
}

std::vector<FrameInfo> read_list(const hdf5::File& file, const std::string& path) {
    const FrameRoom room = read_room(file, path);
    const std::uint64_t count = read_all<std::uint64_t>(file, "frame_count", 1, path)[0];
    const auto time = read_all<double>(file, "frames/time_s", room.frames, path);
    const auto stage = read_all<Stage>(file, "frames/stage", room.frames, path);
    const auto step = read_all<std::uint64_t>(file, "frames/step", room.frames, path);
    const auto total = read_all<std::uint64_t>(file, "frames/total_steps", room.frames, path);
    const auto discs = read_all<std::uint64_t>(file, "frames/disc_count", room.frames, path);
    const auto nodes = read_all<std::uint64_t>(file, "frames/node_count", room.frames, path);
    if (count > room.frames) fail_io("'" + path + "' is damaged (more frames than room). Run the case again?");
    std::vector<FrameInfo> list;
    for (std::size_t k = 0; k < count; ++k) {
        if (discs[k] > room.discs || nodes[k] > room.nodes) {
            fail_io("'" + path + "' is damaged (frame " + std::to_string(k) + "). Run the case again?");
        }
        list.push_back({time[k], {stage[k], step[k], total[k]}, discs[k], nodes[k]});
    }
    return list;
}

FrameFileHeader read_header(const hdf5::File& file, const std::string& path) {
    FrameFileHeader header;
    header.case_text = hdf5::read_text_attribute(file, "case", path);
    const auto nodes = hdf5::extent_of(open_dataset(file, "wheel/reference_m", path), path);
    const auto parts = hdf5::extent_of(open_dataset(file, "wheel/part", path), path);
    const auto node = read_all<double>(file, "wheel/reference_m", 2 * nodes.at(0), path);
    const auto corner = read_all<std::uint32_t>(file, "wheel/quad", 4 * parts.at(0), path);
    for (std::size_t k = 0; k < node.size(); k += 2) header.mesh.node_m.push_back({node[k], node[k + 1]});
    for (std::size_t k = 0; k < corner.size(); k += 4) {
        header.mesh.quad.push_back({corner[k], corner[k + 1], corner[k + 2], corner[k + 3]});
    }
    header.mesh.part = read_all<Part>(file, "wheel/part", parts.at(0), path);
    return header;
}

Frame read_one(const hdf5::File& file, const FrameInfo& info, std::uint64_t number, const std::string& path) {
    Frame frame;
    for_each_column(frame, [&](const char* name, const char*, Extent extent, auto& member) {
        using M = std::remove_reference_t<decltype(member)>;
        if constexpr (Element<M>::many) {
            member.resize(extent == Extent::discs ? info.disc_count : info.node_count);
            read_row<ElementOf<M>>(file, name, extent, number, member, path);
        } else {
            read_row<M>(file, name, extent, number, std::span(&member, 1), path);
        }
    });
    return frame;
}

std::uint64_t place_of(const hdf5::File& file, const char* name, const std::string& path) {
    const haddr_t place = H5Dget_offset(open_dataset(file, name, path));
    return place == HADDR_UNDEF ? 0 : place;  // undefined for an empty dataset, to which nothing is ever written
}

}  // namespace

// ------------------------------------------------------------------------------------------------------------ writing

FrameFile FrameFile::create(const std::string& path, FrameFileHeader header, std::uint64_t first_discs) {
    constexpr std::uint64_t first_frames = 16;
    FrameFile result(path, std::move(header));
    result.remake({first_frames, first_discs, result.header_.mesh.node_m.size()});
    return result;
}

FrameFile FrameFile::open(const std::string& path, FrameFileHeader header) {
    FrameFile result(path, std::move(header));
    const FrameFileHeader stored = read_frame_header(path);
    // Compared by value: the comments of a case file may change from one version of the program to the next.
    if (to_toml(parse_case(stored.case_text, path)) != to_toml(parse_case(result.header_.case_text, path)) ||
        stored.mesh.quad != result.header_.mesh.quad) {
        fail_io("'" + path +
                "' belongs to another case than the checkpoint (the directory holds files of two runs?). Start the run "
                "again in a new directory?");
    }
    result.attach();
    return result;
}

/// Learns where everything stands and opens the file for writing behind HDF5's back.
void FrameFile::attach() {
    const hdf5::File file = open_to_read(path_);
    room_ = read_room(file, path_);
    frames_ = read_list(file, path_);
    frame_count_offset_ = place_of(file, "frame_count", path_);
    disc_count_offset_ = place_of(file, "frames/disc_count", path_);
    node_count_offset_ = place_of(file, "frames/node_count", path_);
    column_offset_.clear();
    const Frame shape;
    for_each_column(shape, [&](const char* name, const char*, Extent, const auto&) {
        column_offset_.push_back(place_of(file, name, path_));
    });
    file_ = OpenFile(path_, O_RDWR);
}

void FrameFile::remake(const FrameRoom& room) {
    const std::string temporary = path_ + ".tmp";
    try {
        make_file(temporary, header_, room);
        FrameFile next(temporary, header_);
        next.attach();
        for (std::uint64_t k = 0; k < frames_.size(); ++k) next.write_frame(k, read_frame(path_, k));
        next.write_count(frames_.size());
        next.file_.sync();
        replace_file(temporary, path_);
    } catch (...) {
        ::unlink(temporary.c_str());
        throw;
    }
    attach();
}

void FrameFile::append(const Frame& frame) {
    const std::uint64_t discs = frame.disc_id.size();
    const std::uint64_t nodes = frame.wheel_position_m.size();
    if (nodes != 0 && nodes != room_.nodes)
        fail_input("a frame has another wheel than its run. Give the mesh to the recorder?");
    FrameRoom room = room_;
    if (frames_.size() == room.frames) room.frames = std::max<std::uint64_t>(16, 2 * room.frames);
    // The number of discs rarely changes; where it does (conversion to elements), not every frame shall remake the
    // file.
    if (discs > room.discs) room.discs = frames_.empty() ? discs : std::max(discs, room.discs + room.discs / 4);
    if (room != room_) remake(room);
    write_frame(frames_.size(), frame);
    file_.sync();
    write_count(frames_.size() + 1);  // eight bytes in one write: the frame is there or it is not
    file_.sync();
    frames_.push_back({frame.time_s, frame.progress, discs, nodes});
}

void FrameFile::write_frame(std::uint64_t number, const Frame& frame) {
    const std::uint64_t discs = frame.disc_id.size();
    const std::uint64_t nodes = frame.wheel_position_m.size();
    std::size_t column = 0;
    for_each_column(frame, [&](const char*, const char*, Extent extent, const auto& member) {
        using T = ElementOf<std::remove_reference_t<decltype(member)>>;
        const std::span<const std::byte> bytes = bytes_of(member);
        std::vector<std::byte> row(room_of(extent, room_) * sizeof(T));  // zeros behind the last disc
        std::copy(bytes.begin(), bytes.end(), row.begin());
        file_.write_at(column_offset_[column++] + number * row.size(), row);
    });
    file_.write_at(disc_count_offset_ + number * sizeof discs, bytes_of(discs));
    file_.write_at(node_count_offset_ + number * sizeof nodes, bytes_of(nodes));
}

void FrameFile::write_count(std::uint64_t count) { file_.write_at(frame_count_offset_, bytes_of(count)); }

void FrameFile::truncate(std::uint64_t count) {
    if (count >= frames_.size()) return;
    write_count(count);
    file_.sync();
    frames_.resize(count);
}

void FrameFile::shrink() {
    FrameRoom room{frames_.size(), 0, room_.nodes};
    for (const FrameInfo& info : frames_) room.discs = std::max(room.discs, info.disc_count);
    if (room != room_) remake(room);
}

std::vector<FrameInfo> read_frame_list(const std::string& path) { return read_list(open_to_read(path), path); }

Frame read_frame(const std::string& path, std::uint64_t number) {
    const hdf5::File file = open_to_read(path);
    const std::vector<FrameInfo> list = read_list(file, path);
    if (number >= list.size()) {
        fail_io("'" + path + "' has no frame " + std::to_string(number) + " (it has " + std::to_string(list.size()) +
                "). Ask for an earlier one?");
    }
    return read_one(file, list[number], number, path);
}

FrameFileHeader read_frame_header(const std::string& path) { return read_header(open_to_read(path), path); }

}  // namespace ifedem
