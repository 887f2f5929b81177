#include "record/frame_seal.hpp"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/error.hpp"
#include "core/hash.hpp"

namespace ifedem {
namespace {

using Word = std::uint64_t;

// The seal, in words: head, two slots, one checksum a frame, footer. The footer is the end of the file, so that a file
// that was cut off is known by its last bytes.
constexpr Word head_magic = 0x3172'6d65'6465'6669;    // "ifedemr1" in the order of bytes
constexpr Word footer_magic = 0x3173'6d65'6465'6669;  // "ifedems1"
constexpr std::size_t head_fixed = 5;                 // magic, columns, hdf5_size, room, count_offset
constexpr std::size_t slot_words = 3;                 // count, chain, check
constexpr std::size_t footer_words = 5;               // magic, finished, place of the seal, sum of all before, check
constexpr Word most_columns = 1000;

Word combine(std::span<const Word> words) {
    Hasher hasher;
    for (const Word word : words) hasher.add(word);
    return hasher.value();
}

[[noreturn]] void fail_damaged(const std::string& path, const std::string& what) {
    ifedem::fail_damaged("'" + path + "' is damaged (" + what + "). Use an earlier copy, or run the case again?");
}

void write_words(OpenFile& file, Word place, std::span<const Word> words) {
    file.write_at(place, std::as_bytes(words));
}

std::vector<Word> read_words(const OpenFile& file, Word place, std::size_t count) {
    std::vector<Word> words(count);
    file.read_at(place, std::as_writable_bytes(std::span(words)));
    return words;
}

Word head_size(const FrameLayout& layout) { return sizeof(Word) * (head_fixed + 2 * layout.columns.size() + 2); }
Word slot_place(const FrameLayout& layout, Word count) {
    return layout.hdf5_size + head_size(layout) + sizeof(Word) * slot_words * (count % 2);
}
Word sum_place(const FrameLayout& layout, Word frame) {
    return layout.hdf5_size + head_size(layout) + sizeof(Word) * (2 * slot_words + frame);
}
Word footer_place(const FrameLayout& layout) { return sum_place(layout, layout.room); }

std::vector<Word> make_head(const FrameLayout& layout, Word constant_sum) {
    std::vector<Word> head = {head_magic, layout.columns.size(), layout.hdf5_size, layout.room, layout.count_offset};
    for (const FrameLayout::Column& column : layout.columns) {
        head.push_back(column.offset);
        head.push_back(column.row_size);
    }
    head.push_back(constant_sum);
    head.push_back(combine(head));
    return head;
}

std::array<Word, slot_words> make_slot(Word head_sum, Word count, Word chain) {
    return {count, chain, combine(std::array{head_sum, count, chain})};
}

Word extend_chain(Word chain, Word sum) { return combine(std::array{chain, sum}); }

/// Checksum of HDF5's bytes without the frames' rows and their number.
Word sum_constant_bytes(const OpenFile& file, const FrameLayout& layout) {
    struct Range {
        Word begin, end;
    };
    std::vector<Range> changing = {{layout.count_offset, layout.count_offset + sizeof(Word)}};
    for (const auto& column : layout.columns) {
        changing.push_back({column.offset, column.offset + column.row_size * layout.room});
    }
    std::ranges::sort(changing, {}, &Range::begin);
    changing.push_back({layout.hdf5_size, layout.hdf5_size});
    Hasher hasher;
    Word at = 0;
    for (const Range& range : changing) {
        if (range.begin > at) {
            std::vector<std::byte> bytes(range.begin - at);
            file.read_at(at, bytes);
            hasher.add(checksum(bytes));
        }
        at = std::max(at, range.end);
    }
    return hasher.value();
}

struct Footer {
    bool finished = false;
    Word seal_place = 0;
    Word whole_sum = 0;
};

std::array<Word, footer_words> to_words(const Footer& footer) {
    const std::array<Word, 4> words = {footer_magic, footer.finished ? Word{1} : Word{0}, footer.seal_place,
                                       footer.whole_sum};
    return {words[0], words[1], words[2], words[3], combine(words)};
}

Footer read_footer(const OpenFile& file, const std::string& path) {
    const Word size = file.size();
    constexpr Word footer_size = footer_words * sizeof(Word);
    if (size <= footer_size) fail_damaged(path, "too short; was it cut off?");
    const std::vector<Word> words = read_words(file, size - footer_size, footer_words);
    if (words[0] != footer_magic)
        fail_damaged(path, "its last bytes are not this program's; was it cut off or edited?");
    const Footer footer{words[1] == 1, words[2], words[3]};
    if (!std::ranges::equal(words, to_words(footer))) fail_damaged(path, "checksum of its seal");
    return footer;
}

/// The table, believed only if it is as written and lies within the file.
FrameLayout read_layout(const OpenFile& file, Word place, const std::string& path) {
    const Word size = file.size();
    if (place >= size || size - place < sizeof(Word) * head_fixed) fail_damaged(path, "place of its seal");
    const std::vector<Word> fixed = read_words(file, place, head_fixed);
    if (fixed[0] != head_magic || fixed[1] > most_columns) fail_damaged(path, "beginning of its seal");
    FrameLayout layout;
    layout.hdf5_size = fixed[2];
    layout.room = fixed[3];
    layout.count_offset = fixed[4];
    const std::vector<Word> rest = read_words(file, place + sizeof(Word) * head_fixed, 2 * fixed[1] + 2);
    for (std::size_t k = 0; k < fixed[1]; ++k) layout.columns.push_back({rest[2 * k], rest[2 * k + 1]});
    if (make_head(layout, rest[rest.size() - 2]).back() != rest.back()) fail_damaged(path, "table of its seal");
    if (layout.hdf5_size != place || footer_place(layout) + sizeof(Word) * footer_words != size)
        fail_damaged(path, "its length");
    if (sum_constant_bytes(file, layout) != rest[rest.size() - 2]) fail_damaged(path, "checksum of its structure");
    return layout;
}

Word read_count(const OpenFile& file, const FrameLayout& layout) {
    return read_words(file, layout.count_offset, 1).front();
}

/// The newest of the two slots that is as written.
struct Slot {
    Word count = 0, chain = 0;
};
Slot read_newest_slot(const OpenFile& file, const FrameLayout& layout, Word head_sum, const std::string& path) {
    Slot newest;
    bool found = false;
    for (const Word which : {Word{0}, Word{1}}) {
        const std::vector<Word> slot = read_words(file, slot_place(layout, which), slot_words);
        const bool good = std::ranges::equal(slot, make_slot(head_sum, slot[0], slot[1])) && slot[0] <= layout.room;
        if (!good || (found && slot[0] < newest.count)) continue;
        newest = {slot[0], slot[1]};
        found = true;
    }
    if (!found) fail_damaged(path, "number of frames in its seal");
    return newest;
}

Word sum_frame_in_file(const OpenFile& file, const FrameLayout& layout, Word number) {
    std::vector<Word> sums;
    std::vector<std::byte> row;
    for (const FrameLayout::Column& column : layout.columns) {
        row.resize(column.row_size);
        file.read_at(column.offset + number * column.row_size, row);
        sums.push_back(checksum(row));
    }
    return frame_sum(number, sums);
}

Word head_sum_of(const OpenFile& file, const FrameLayout& layout) {
    return read_words(file, layout.hdf5_size + head_size(layout) - sizeof(Word), 1).front();
}

/// A file that is being written, perhaps at this moment. HDF5's count follows the slot and was read before and after.
Word verify_frames(const OpenFile& file, const FrameLayout& layout, const std::string& path) {
    const Word before = read_count(file, layout);
    const Slot newest = read_newest_slot(file, layout, head_sum_of(file, layout), path);
    const Word after = read_count(file, layout);
    if (newest.count < before || newest.count > after + 1) fail_damaged(path, "number of frames");
    Word chain = 0;
    const std::vector<Word> sums = read_words(file, sum_place(layout, 0), newest.count);
    for (Word k = 0; k < newest.count; ++k) {
        if (sum_frame_in_file(file, layout, k) != sums[k]) fail_damaged(path, "frame " + std::to_string(k));
        chain = extend_chain(chain, sums[k]);
    }
    if (chain != newest.chain) fail_damaged(path, "checksums of frames");
    return newest.count;
}

/// Checksum of everything before the footer, in pieces that fit a cache.
Word sum_all_bytes(const OpenFile& file, Word size) {
    constexpr Word piece = Word{1} << 20;
    std::vector<std::byte> bytes;
    Hasher hasher;
    for (Word at = 0; at < size; at += piece) {
        bytes.resize(std::min(piece, size - at));
        file.read_at(at, bytes);
        hasher.add(checksum(bytes));
    }
    return hasher.value();
}

}  // namespace

Word frame_sum(Word number, std::span<const Word> row_sums) { return combine(std::array{number, combine(row_sums)}); }

FrameSeal FrameSeal::create(OpenFile& file, FrameLayout layout) {
    FrameSeal seal;
    seal.layout_ = std::move(layout);
    const std::vector<Word> head = make_head(seal.layout_, sum_constant_bytes(file, seal.layout_));
    seal.head_sum_ = head.back();
    write_words(file, seal.layout_.hdf5_size, head);
    for (const Word which : {Word{0}, Word{1}})
        write_words(file, slot_place(seal.layout_, which), make_slot(seal.head_sum_, 0, 0));
    write_words(file, footer_place(seal.layout_), to_words({false, seal.layout_.hdf5_size, 0}));
    return seal;
}

FrameSeal FrameSeal::attach(const OpenFile& file, FrameLayout layout, Word frames) {
    FrameSeal seal;
    seal.layout_ = std::move(layout);
    seal.head_sum_ = head_sum_of(file, seal.layout_);
    seal.count_ = frames;
    for (const Word sum : read_words(file, sum_place(seal.layout_, 0), frames)) {
        seal.chain_ = extend_chain(seal.chain_, sum);
    }
    return seal;
}

void FrameSeal::take_back(OpenFile& file) const {
    write_words(file, layout_.count_offset, std::array{count_});
    file.sync();
    write_words(file, slot_place(layout_, count_ + 1), std::array<Word, slot_words>{});
    file.sync();
}

void FrameSeal::add_frame(OpenFile& file, Word sum, Sync sync) {
    const auto order = [&] {
        if (sync == Sync::now) file.sync();
    };
    const Word chain = extend_chain(chain_, sum);
    write_words(file, sum_place(layout_, count_), std::array{sum});
    order();
    write_words(file, slot_place(layout_, count_ + 1), make_slot(head_sum_, count_ + 1, chain));
    order();
    write_words(file, layout_.count_offset, std::array{count_ + 1});
    order();
    chain_ = chain;
    ++count_;
}

void FrameSeal::finish(OpenFile& file) const {
    const Word place = footer_place(layout_);
    write_words(file, place, to_words({true, layout_.hdf5_size, sum_all_bytes(file, place)}));
    file.sync();
}

FrameFileStatus verify_frame_file(const std::string& path) {
    const OpenFile file(path, O_RDONLY);
    const Footer footer = read_footer(file, path);
    if (footer.finished && sum_all_bytes(file, file.size() - sizeof(Word) * footer_words) != footer.whole_sum)
        fail_damaged(path, "its checksum does not fit");
    const FrameLayout layout = read_layout(file, footer.seal_place, path);
    return {verify_frames(file, layout, path), footer.finished, layout.hdf5_size};
}

}  // namespace ifedem
