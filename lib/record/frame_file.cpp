#include "record/frame_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <span>
#include <type_traits>

#include "core/error.hpp"
#include "core/hash.hpp"
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
    {  // closed before the file: else HDF5 writes the rest when the last handle goes, where nobody hears of an error
        const std::uint64_t no_frames = 0;
        const hdf5::Dataset count = make_dataset(file, "frame_count", "1", H5T_NATIVE_UINT64, {}, path);
        check(H5Dwrite(count, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &no_frames), "write", path);
    }
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
    if (stored != count)
        fail_damaged("'" + path + "' is damaged (" + name + " has another length). Run the case again?");
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

/// `count` is the seal's, which is ahead of the file's own when its writer was killed between the two.
std::vector<FrameInfo> read_list(const hdf5::File& file, std::uint64_t count, const std::string& path) {
    const FrameRoom room = read_room(file, path);
    const auto time = read_all<double>(file, "frames/time_s", room.frames, path);
    const auto stage = read_all<Stage>(file, "frames/stage", room.frames, path);
    const auto step = read_all<std::uint64_t>(file, "frames/step", room.frames, path);
    const auto total = read_all<std::uint64_t>(file, "frames/total_steps", room.frames, path);
    const auto discs = read_all<std::uint64_t>(file, "frames/disc_count", room.frames, path);
    const auto nodes = read_all<std::uint64_t>(file, "frames/node_count", room.frames, path);
    if (count > room.frames) fail_damaged("'" + path + "' is damaged (more frames than room). Run the case again?");
    std::vector<FrameInfo> list;
    for (std::size_t k = 0; k < count; ++k) {
        if (discs[k] > room.discs || nodes[k] > room.nodes) {
            fail_damaged("'" + path + "' is damaged (frame " + std::to_string(k) + "). Run the case again?");
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

/// 0 for an empty dataset, which has no place and to which nothing is ever written.
std::uint64_t place_of(const hdf5::File& file, const char* name, const std::string& path) {
    const hdf5::Dataset dataset = open_dataset(file, name, path);
    const haddr_t place = H5Dget_offset(dataset);
    if (place != HADDR_UNDEF) return place;
    const auto extent = hdf5::extent_of(dataset, path);
    if (std::ranges::find(extent, 0U) == extent.end()) hdf5::fail("find a column in", path);
    return 0;
}

/// Columns of the layout that every frame has beside those of for_each_column.
constexpr std::array<const char*, 2> length_columns = {"frames/disc_count", "frames/node_count"};

FrameLayout find_layout(const hdf5::File& file, const FrameRoom& room, std::uint64_t hdf5_size,
                        const std::string& path) {
    FrameLayout layout{hdf5_size, room.frames, place_of(file, "frame_count", path), {}};
    for (const char* name : length_columns)
        layout.columns.push_back({place_of(file, name, path), sizeof(std::uint64_t)});
    const Frame shape;
    for_each_column(shape, [&](const char* name, const char*, Extent extent, const auto& member) {
        using T = ElementOf<std::remove_reference_t<decltype(member)>>;
        layout.columns.push_back({place_of(file, name, path), room_of(extent, room) * sizeof(T)});
    });
    return layout;
}

}  // namespace

// ------------------------------------------------------------------------------------------------------------ reading

struct FrameReader::Impl {
    std::string path;
    FrameFileStatus status;
    hdf5::File file;
    std::vector<FrameInfo> frames;
};

FrameReader::FrameReader(std::string path) : impl_(std::make_unique<Impl>()) {
    impl_->path = std::move(path);
    impl_->status = verify_frame_file(impl_->path);
    impl_->file = open_to_read(impl_->path);
    impl_->frames = read_list(impl_->file, impl_->status.frames, impl_->path);
}

FrameReader::~FrameReader() = default;
FrameReader::FrameReader(FrameReader&&) noexcept = default;
FrameReader& FrameReader::operator=(FrameReader&&) noexcept = default;

const std::vector<FrameInfo>& FrameReader::frames() const { return impl_->frames; }

Frame FrameReader::read(std::uint64_t number) const {
    if (number >= frames().size()) {
        fail_io("'" + impl_->path + "' has no frame " + std::to_string(number) + " (it has " +
                std::to_string(frames().size()) + "). Ask for an earlier one?");
    }
    return read_one(impl_->file, frames()[number], number, impl_->path);
}

FrameFileHeader FrameReader::header() const { return read_header(impl_->file, impl_->path); }

std::vector<FrameInfo> read_frame_list(const std::string& path) { return FrameReader(path).frames(); }
Frame read_frame(const std::string& path, std::uint64_t number) { return FrameReader(path).read(number); }
FrameFileHeader read_frame_header(const std::string& path) { return FrameReader(path).header(); }

// ------------------------------------------------------------------------------------------------------------ writing

FrameFile FrameFile::create(const std::string& path, FrameFileHeader header, std::uint64_t first_discs) {
    constexpr std::uint64_t first_frames = 16;
    FrameFile result(path, std::move(header));
    result.remake({first_frames, first_discs, result.header_.mesh.node_m.size()}, 0);
    return result;
}

FrameFile FrameFile::open(const std::string& path, FrameFileHeader header) {
    FrameFile result(path, std::move(header));
    const FrameFileHeader stored = FrameReader(path).header();
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
    const FrameReader reader(path_);
    const FrameReader::Impl& whole = *reader.impl_;
    finished_ = whole.status.finished;
    frames_ = whole.frames;
    room_ = read_room(whole.file, path_);
    layout_ = find_layout(whole.file, room_, whole.status.hdf5_size, path_);
    file_ = OpenFile(path_, O_RDWR);
    seal_ = FrameSeal::attach(file_, layout_, frames_.size());
    failed_ = false;
}

namespace {

/// Writes a frame's rows behind HDF5's back and returns its checksum.
std::uint64_t write_rows(OpenFile& file, const FrameLayout& layout, std::uint64_t number, const Frame& frame) {
    std::vector<std::uint64_t> sums;
    std::vector<std::byte> row;
    const auto write_row = [&](std::span<const std::byte> bytes) {
        const FrameLayout::Column& column = layout.columns[sums.size()];
        row.assign(column.row_size, std::byte{0});  // zeros behind the last disc
        std::ranges::copy(bytes, row.begin());
        file.write_at(column.offset + number * column.row_size, row);
        sums.push_back(checksum(row));
    };
    const std::uint64_t discs = frame.disc_id.size(), nodes = frame.wheel_position_m.size();
    write_row(bytes_of(discs));
    write_row(bytes_of(nodes));
    for_each_column(frame, [&](const char*, const char*, Extent, const auto& member) { write_row(bytes_of(member)); });
    return frame_sum(number, sums);
}

/// A file with its structure, a seal and no frames.
FrameSeal make_sealed_file(const std::string& path, const FrameFileHeader& header, const FrameRoom& room,
                           FrameLayout& layout) {
    make_file(path, header, room);
    OpenFile file(path, O_RDWR);
    layout = find_layout(open_to_read(path), room, file.size(), path);
    return FrameSeal::create(file, layout);
}

}  // namespace

void FrameFile::remake(const FrameRoom& room, std::uint64_t kept) {
    const std::string temporary = path_ + ".tmp";
    try {
        FrameLayout layout;
        FrameSeal seal = make_sealed_file(temporary, header_, room, layout);
        OpenFile file(temporary, O_RDWR);
        if (kept > 0) {
            const FrameReader old(path_);
            for (std::uint64_t k = 0; k < kept; ++k)
                seal.add_frame(file, write_rows(file, layout, k, old.read(k)), FrameSeal::Sync::later);
        }
        if (room.frames == kept) seal.finish(file);
        file.sync();
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
    if (room != room_) remake(room, frames_.size());
    if (failed_) seal_.take_back(file_);
    failed_ = true;
    seal_.add_frame(file_, write_rows(file_, layout_, frames_.size(), frame), FrameSeal::Sync::now);
    failed_ = false;
    frames_.push_back({frame.time_s, frame.progress, discs, nodes});
}

void FrameFile::truncate(std::uint64_t count) {
    if (count < frames_.size()) remake({std::max<std::uint64_t>(16, count + 1), room_.discs, room_.nodes}, count);
}

void FrameFile::finish() {
    if (finished_) return;
    FrameRoom room{frames_.size(), 0, room_.nodes};
    for (const FrameInfo& info : frames_) room.discs = std::max(room.discs, info.disc_count);
    remake(room, frames_.size());
}

}  // namespace ifedem
