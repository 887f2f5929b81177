#include "record/results.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "core/error.hpp"
#include "record/files.hpp"
#include "record/frame_file.hpp"
#include "record/xdmf.hpp"

namespace ifedem {
namespace {

std::string make_series_header() {
    std::string header;
    for_each_series_column(SeriesRow{}, [&](const char* name, double) {
        header += header.empty() ? fmt::format("{},stage", name) : fmt::format(",{}", name);
    });
    return header + "\n";
}
const std::string series_header = make_series_header();

/// The shortest digits that read back to the same bits.
std::string series_line(const SeriesRow& row) {
    std::string line;
    for_each_series_column(row, [&](const char*, double value) {
        line += line.empty() ? fmt::format("{},{}", value, stage_name(row.stage)) : fmt::format(",{}", value);
    });
    return line + "\n";
}

/// Whether a line of series.csv is at or before the step that a run resumes at. Half a step of play, because the
/// columns have times, not steps.
bool is_kept(std::string_view line, const Progress& resume_at, double time_step_s, const std::string& path) {
    double time_s = 0;
    const auto [end, fault] = std::from_chars(line.data(), line.data() + line.size(), time_s);
    const std::string_view rest(end, static_cast<std::size_t>(line.data() + line.size() - end));
    const std::string_view word = rest.substr(std::min<std::size_t>(1, rest.size()), rest.find(',', 1) - 1);
    for (const Stage stage : {Stage::consolidation, Stage::sinkage, Stage::travel, Stage::finished}) {
        if (fault != std::errc{} || word != stage_name(stage)) continue;
        const double limit_s = (static_cast<double>(resume_at.step) + 0.5) * time_step_s;
        return stage < resume_at.stage || (stage == resume_at.stage && time_s <= limit_s);
    }
    fail_io("'" + path + "' has a line that this program did not write ('" + std::string(line) +
            "'). Start the run again in a new directory?");
}

/// Length in bytes of the part of series.csv that is kept; an unfinished last line is not.
std::uint64_t kept_size(const std::string& path, const Progress& resume_at, double time_step_s) {
    const std::vector<std::byte> bytes = read_whole_file(path);
    std::string text(bytes.size(), '\0');
    std::transform(bytes.begin(), bytes.end(), text.begin(), [](std::byte b) { return static_cast<char>(b); });
    if (!text.starts_with(series_header)) {
        fail_io("'" + path +
                "' is no series of this program (its first line differs). Start the run again in a new directory?");
    }
    std::size_t at = series_header.size();
    for (std::size_t end = text.find('\n', at); end != std::string::npos; end = text.find('\n', at)) {
        if (!is_kept(std::string_view(text).substr(at, end - at), resume_at, time_step_s, path)) break;
        at = end + 1;
    }
    return at;
}

bool is_kept(const FrameInfo& info, const Progress& resume_at) {
    const Progress& progress = info.progress;
    return progress.stage < resume_at.stage || (progress.stage == resume_at.stage && progress.step <= resume_at.step);
}

void make_directory(const std::string& directory) {
    std::error_code fault;
    std::filesystem::create_directories(directory, fault);
    if (fault) {
        fail_io("cannot make the directory '" + directory + "' (" + fault.message() +
                "). Check the path and its permissions?");
    }
}

}  // namespace

struct Recorder::Impl {
    std::string directory;
    double time_step_s;
    FrameFile frames;
    OpenFile series;
    std::uint64_t series_size = 0;

    [[nodiscard]] std::string path(const char* name) const { return directory + "/" + name; }

    void start_series() {
        write_file_atomically(path("series.csv"), std::string(series_header));
        series = OpenFile(path("series.csv"), O_WRONLY);
        series_size = series_header.size();
    }

    void resume_series(const Progress& resume_at) {
        series_size = kept_size(path("series.csv"), resume_at, time_step_s);
        series = OpenFile(path("series.csv"), O_WRONLY);
        series.truncate(series_size);
        series.sync();
    }

    void resume_frames(const Progress& resume_at) {
        std::uint64_t kept = 0;
        while (kept < frames.frames().size() && is_kept(frames.frames()[kept], resume_at)) ++kept;
        frames.truncate(kept);
    }

    void write_xdmf() const {
        const std::size_t quads = frames.quad_count();
        write_file_atomically(path("discs.xdmf"), make_disc_xdmf(frames.frames(), frames.room(), time_step_s));
        write_file_atomically(path("wheel.xdmf"), make_wheel_xdmf(frames.frames(), frames.room(), quads, time_step_s));
    }
};

Recorder::Recorder(std::string directory, const Case& c, const WheelMesh& mesh, std::optional<Progress> resume_at) {
    const std::string case_text = to_toml(c);
    const std::string results = directory + "/results.h5";
    if (!resume_at) {
        make_directory(directory);
        write_file_atomically(directory + "/case.toml", case_text);  // first: it is what makes a directory a run's
    }
    FrameFileHeader header{case_text, mesh.mesh};
    FrameFile frames =
        resume_at ? FrameFile::open(results, std::move(header))
                  : FrameFile::create(results, std::move(header), static_cast<std::uint64_t>(c.bed.disc_count));
    impl_ = std::make_unique<Impl>(Impl{std::move(directory), c.time_step_s, std::move(frames), {}});
    if (resume_at) {
        impl_->resume_series(*resume_at);
        impl_->resume_frames(*resume_at);
    } else {
        impl_->start_series();
    }
    impl_->write_xdmf();
}

Recorder::~Recorder() = default;

void Recorder::add_series(const SeriesRow& row) {
    const std::string line = series_line(row);
    impl_->series.write_at(impl_->series_size, std::as_bytes(std::span(line)));
    impl_->series_size += line.size();
}

void Recorder::add_frame(const Frame& frame) {
    impl_->frames.append(frame);
    impl_->write_xdmf();
}

void Recorder::flush() { impl_->series.sync(); }  // frames are on the disk when append() returns

void Recorder::finish() {
    flush();
    impl_->frames.finish();
    impl_->write_xdmf();
}

}  // namespace ifedem
