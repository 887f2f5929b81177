#include "record/xdmf.hpp"

#include <fmt/format.h>

namespace ifedem {
namespace {

// XDMF 2, the dialect that ParaView's plain "Xdmf Reader" takes. It wants the points of a Polyvertex by number and
// NodesPerElement="1"; without these it draws nothing and says nothing. It takes frames whose topology and geometry
// have the same text for one and the same frame, where text is what stands before the first inner element: so every
// topology and geometry is a HyperSlab, and between it and its inner elements stands not even a space.

std::string wrap_collection(const char* name, const std::string& grids) {
    return fmt::format(
        "<?xml version=\"1.0\" ?>\n<Xdmf Version=\"2.0\">\n<Domain>\n"
        "<Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n{}</Grid>\n</Domain>\n</Xdmf>\n",
        name, grids);
}

/// A whole dataset.
std::string whole(const char* dataset, const std::string& dimensions, const char* number) {
    return fmt::format("<DataItem Format=\"HDF\" Dimensions=\"{}\" {}>results.h5:/{}</DataItem>", dimensions, number,
                       dataset);
}

constexpr const char* real64 = "NumberType=\"Float\" Precision=\"8\"";
constexpr const char* real32 = "NumberType=\"Float\" Precision=\"4\"";
constexpr const char* whole32 = "NumberType=\"UInt\" Precision=\"4\"";
constexpr const char* whole8 = "NumberType=\"UChar\" Precision=\"1\"";

/// `count` pairs or single values of frame `number` out of a dataset with room for `room` in each of `frames` rows.
std::string pairs(const char* dataset, std::size_t number, std::uint64_t count, std::uint64_t frames,
                  std::uint64_t room) {
    return fmt::format(
        "<DataItem ItemType=\"HyperSlab\" Dimensions=\"{1} 2\" Type=\"HyperSlab\">"
        "<DataItem Format=\"XML\" Dimensions=\"3 3\">{0} 0 0 1 1 1 1 {1} 2</DataItem>{2}</DataItem>",
        number, count, whole(dataset, fmt::format("{} {} 2", frames, room), real64));
}
std::string singles(const char* dataset, const char* kind, std::size_t number, std::uint64_t count,
                    const FrameRoom& room) {
    return fmt::format(
        "<DataItem ItemType=\"HyperSlab\" Dimensions=\"{1}\" Type=\"HyperSlab\">"
        "<DataItem Format=\"XML\" Dimensions=\"3 2\">{0} 0 1 1 1 {1}</DataItem>{2}</DataItem>",
        number, count, whole(dataset, fmt::format("{} {}", room.frames, room.discs), kind));
}

std::string open_grid(const char* name, const FrameInfo& info, double time_step_s) {
    return fmt::format("<Grid Name=\"{}\" GridType=\"Uniform\"><Time Value=\"{}\"/>\n", name,
                       static_cast<double>(info.progress.total_steps) * time_step_s);
}

}  // namespace

std::string make_disc_xdmf(std::span<const FrameInfo> frames, const FrameRoom& room, double time_step_s) {
    std::string grids;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const std::uint64_t count = frames[k].disc_count;
        const auto attribute = [&](const char* name, const char* kind) {
            return fmt::format("<Attribute Name=\"{0}\" AttributeType=\"Scalar\" Center=\"Node\">{1}</Attribute>\n",
                               name, singles(fmt::format("discs/{}", name).c_str(), kind, k, count, room));
        };
        grids += open_grid("discs", frames[k], time_step_s);
        grids += fmt::format(
            "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{0}\" NodesPerElement=\"1\">"
            "<DataItem ItemType=\"HyperSlab\" Dimensions=\"{0}\" Type=\"HyperSlab\">"
            "<DataItem Format=\"XML\" Dimensions=\"3 1\">0 1 {0}</DataItem>{1}</DataItem></Topology>\n",
            count, whole("discs/index", fmt::format("{}", room.discs), whole32));
        grids += fmt::format("<Geometry GeometryType=\"XY\">{}</Geometry>\n",
                             pairs("discs/position_m", k, count, room.frames, room.discs));
        grids += attribute("radius_m", real32) + attribute("speed_m_s", real32) + attribute("pressure_Pa", real32) +
                 attribute("id", whole32) + "</Grid>\n";
    }
    return wrap_collection("discs", grids);
}

std::string make_wheel_xdmf(std::span<const FrameInfo> frames, const FrameRoom& room, std::size_t quads,
                            double time_step_s) {
    std::string grids;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        if (frames[k].node_count == 0 || quads == 0) continue;
        grids += open_grid("wheel", frames[k], time_step_s);
        grids += fmt::format(
            "<Topology TopologyType=\"Quadrilateral\" NumberOfElements=\"{0}\">"
            "<DataItem ItemType=\"HyperSlab\" Dimensions=\"{0} 4\" Type=\"HyperSlab\">"
            "<DataItem Format=\"XML\" Dimensions=\"3 2\">0 0 1 1 {0} 4</DataItem>{1}</DataItem></Topology>\n",
            quads, whole("wheel/quad", fmt::format("{} 4", quads), whole32));
        grids += fmt::format("<Geometry GeometryType=\"XY\">{}</Geometry>\n",
                             pairs("wheel/position_m", k, frames[k].node_count, room.frames, room.nodes));
        grids +=
            fmt::format("<Attribute Name=\"part\" AttributeType=\"Scalar\" Center=\"Cell\">{}</Attribute>\n</Grid>\n",
                        whole("wheel/part", fmt::format("{}", quads), whole8));
    }
    return wrap_collection("wheel", grids);
}

}  // namespace ifedem
