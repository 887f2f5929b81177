#include "fem/gmsh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <unordered_map>

#include "core/error.hpp"

namespace ifedem {
namespace {

/// The file's words, with the line that each stands in.
class Words {
public:
    Words(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    [[noreturn]] void fail(const std::string& message) const {
        fail_input(fmt::format("{}:{}: {}", name_, line_, message));
    }
    /// "" at the end.
    std::string_view next() {
        skip_space();
        const std::size_t begin = at_;
        while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
        return text_.substr(begin, at_ - begin);
    }
    /// The rest of the line, less the spaces at its ends.
    std::string_view rest_of_line() {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        std::string_view rest = text_.substr(at_, end - at_);
        at_ = end;
        while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
        while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
        return rest;
    }
    void next_line() {
        (void)rest_of_line();
        if (at_ == text_.size()) fail("the file ends too early. Save it again?");
        ++at_;
        ++line_;
    }
    std::uint64_t whole(const char* what) { return number<std::uint64_t>(what); }
    /// Physical and entity tags may be negative.
    std::int64_t tag(const char* what) { return number<std::int64_t>(what); }
    double real(const char* what) {
        const auto value = number<double>(what);
        if (!std::isfinite(value)) fail(fmt::format("{} is not finite. Save the mesh again?", what));
        return value;
    }
    void skip_to(std::string_view word) {
        for (std::string_view w = next(); w != word; w = next())
            if (w.empty()) fail(fmt::format("the file ends before {}. Save it again?", word));
    }
    void expect(std::string_view word) {
        const std::string_view found = next();
        if (found != word) fail(fmt::format("\"{}\" stands where {} should. Save the mesh again?", shown(found), word));
    }
    static std::string shown(std::string_view word) {
        std::string text;
        for (const char c : word.substr(0, 40)) text += c > ' ' && c < 127 ? c : '?';
        return text;
    }

private:
    static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
    void skip_space() {
        for (; at_ < text_.size() && is_space(text_[at_]); ++at_) line_ += text_[at_] == '\n' ? 1U : 0U;
    }
    template <class T>
    T number(const char* what) {
        const std::string_view word = next();
        T value{};
        const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty() || fault != std::errc{} || end != word.data() + word.size())
            fail(fmt::format("\"{}\" is no {}. Save the mesh as ASCII again?", shown(word), what));
        return value;
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
};

constexpr int quad_type = 3;
constexpr std::array<int, 4> passed_over = {1, 15, 8, 26};  // lines and points: they bound surfaces, they are no part

/// What the sections gather.
struct Reading {
    int version = 0;                                              // 22 or 41
    std::unordered_map<std::int64_t, std::string> physical_name;  // of surfaces
    std::unordered_map<std::int64_t, std::int64_t> surface_physical;
    std::unordered_map<std::uint64_t, std::uint32_t> node;  // Gmsh's number → ours
    GmshMesh mesh;
};

void read_format(Words& words, Reading& reading) {
    const std::string_view version = words.next();
    if (version != "2.2" && version != "4.1")
        words.fail(fmt::format("format {} (2.2 and 4.1 are read). Save it with Mesh.MshFileVersion = 4.1?",
                               Words::shown(version)));
    reading.version = version == "2.2" ? 22 : 41;
    if (words.next() != "0") words.fail("the file is binary (ASCII is read). Save it with Mesh.Binary = 0?");
    (void)words.next();
}

void read_names(Words& words, Reading& reading) {
    const std::uint64_t count = words.whole("number of names");
    for (std::uint64_t k = 0; k < count; ++k) {
        const std::int64_t dimension = words.tag("dimension");
        const std::int64_t tag = words.tag("physical tag");
        std::string_view name = words.rest_of_line();
        if (name.size() >= 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
        if (dimension == 2) reading.physical_name[tag] = std::string(name);
    }
}

void skip_words(Words& words, std::uint64_t count, const char* what) {
    for (std::uint64_t k = 0; k < count; ++k) (void)words.tag(what);
}

void read_entities(Words& words, Reading& reading) {
    std::array<std::uint64_t, 4> count{};
    for (std::uint64_t& n : count) n = words.whole("number of entities");
    for (std::size_t dimension = 0; dimension < 3; ++dimension) {
        for (std::uint64_t k = 0; k < count[dimension]; ++k) {
            const std::int64_t tag = words.tag("entity tag");
            for (int b = 0; b < (dimension == 0 ? 3 : 6); ++b) (void)words.real("coordinate");
            const std::uint64_t physicals = words.whole("number of physical tags");
            for (std::uint64_t p = 0; p < physicals; ++p) {
                const std::int64_t physical = words.tag("physical tag");
                if (dimension == 2 && p == 0) reading.surface_physical[tag] = physical;
            }
            if (dimension > 0) skip_words(words, words.whole("number of bounds"), "entity tag");
        }
    }
    words.skip_to("$EndEntities");
}

void add_node(Words& words, Reading& reading, std::uint64_t number, double x, double y, double z) {
    if (std::fabs(z) > 1e-9 * (1 + std::fabs(x) + std::fabs(y)))
        words.fail(fmt::format("node {} lies at z = {} (a wheel is plane). Project the mesh on z = 0?", number, z));
    if (!reading.node.emplace(number, static_cast<std::uint32_t>(reading.mesh.node_m.size())).second)
        words.fail(fmt::format("node {} is given twice. Save the mesh again?", number));
    reading.mesh.node_m.push_back({x, y});
}

void read_nodes_22(Words& words, Reading& reading) {
    const std::uint64_t count = words.whole("number of nodes");
    for (std::uint64_t k = 0; k < count; ++k) {
        const std::uint64_t number = words.whole("node number");
        const double x = words.real("coordinate"), y = words.real("coordinate"), z = words.real("coordinate");
        add_node(words, reading, number, x, y, z);
    }
}

void read_nodes_41(Words& words, Reading& reading) {
    const std::uint64_t blocks = words.whole("number of blocks");
    skip_words(words, 3, "number");
    for (std::uint64_t b = 0; b < blocks; ++b) {
        const std::uint64_t dimension = words.whole("dimension");
        (void)words.tag("entity tag");
        const bool parametric = words.whole("flag") != 0;
        const std::uint64_t count = words.whole("number of nodes");
        std::vector<std::uint64_t> numbers;
        for (std::uint64_t k = 0; k < count; ++k) numbers.push_back(words.whole("node number"));
        for (const std::uint64_t number : numbers) {
            const double x = words.real("coordinate"), y = words.real("coordinate"), z = words.real("coordinate");
            for (std::uint64_t p = 0; parametric && p < std::min<std::uint64_t>(dimension, 3); ++p)
                (void)words.real("parameter");
            add_node(words, reading, number, x, y, z);
        }
    }
}

void add_quad(Words& words, Reading& reading, std::uint64_t number, std::int64_t physical) {
    std::array<std::uint32_t, 4> quad{};
    for (std::uint32_t& corner : quad) {
        const std::uint64_t node = words.whole("node number");
        const auto found = reading.node.find(node);
        if (found == reading.node.end())
            words.fail(fmt::format("element {} has node {}, which there is not. Save the mesh again?", number, node));
        corner = found->second;
    }
    const auto name = reading.physical_name.find(physical);
    if (name == reading.physical_name.end())
        words.fail(
            fmt::format("quad {} belongs to no named physical surface (its part is unknown). Name it with "
                        "Physical Surface(\"surface\")?",
                        number));
    reading.mesh.quad.push_back(quad);
    reading.mesh.group.push_back(name->second);
}

/// True for a quad, false for what is passed over.
bool is_quad(Words& words, std::int64_t type) {
    if (type == quad_type) return true;
    if (std::ranges::find(passed_over, type) != passed_over.end()) return false;
    words.fail(
        fmt::format("an element of Gmsh type {} (only four-node quads are read). Mesh with Mesh.RecombineAll = 1 "
                    "and Mesh.ElementOrder = 1?",
                    type));
}

void read_elements_22(Words& words, Reading& reading) {
    const std::uint64_t count = words.whole("number of elements");
    for (std::uint64_t k = 0; k < count; ++k) {
        const std::uint64_t number = words.whole("element number");
        if (!is_quad(words, words.tag("element type"))) {
            words.next_line();
            continue;
        }
        const std::uint64_t tags = words.whole("number of tags");
        const std::int64_t physical = tags > 0 ? words.tag("tag") : 0;
        if (tags > 1) skip_words(words, tags - 1, "tag");
        add_quad(words, reading, number, physical);
    }
}

void read_elements_41(Words& words, Reading& reading) {
    const std::uint64_t blocks = words.whole("number of blocks");
    skip_words(words, 3, "number");
    for (std::uint64_t b = 0; b < blocks; ++b) {
        (void)words.whole("dimension");
        const std::int64_t entity = words.tag("entity tag");
        const bool quads = is_quad(words, words.tag("element type"));
        const std::uint64_t count = words.whole("number of elements");
        const auto physical = reading.surface_physical.find(entity);
        const std::int64_t tag = physical == reading.surface_physical.end() ? 0 : physical->second;
        for (std::uint64_t k = 0; k < count; ++k) {
            const std::uint64_t number = words.whole("element number");
            if (quads) {
                add_quad(words, reading, number, tag);
            } else {
                words.next_line();
            }
        }
    }
}

void read_section(Words& words, Reading& reading, std::string_view section) {
    if (section == "$PhysicalNames") return read_names(words, reading);
    if (section == "$Nodes")
        return reading.version == 22 ? read_nodes_22(words, reading) : read_nodes_41(words, reading);
    if (section == "$Elements")
        return reading.version == 22 ? read_elements_22(words, reading) : read_elements_41(words, reading);
}

}  // namespace

GmshMesh parse_gmsh(std::string_view text, const std::string& name) {
    Words words(text, name);
    Reading reading;
    if (words.next() != "$MeshFormat")
        words.fail("the file does not begin with $MeshFormat (it is no Gmsh mesh). Save the mesh as .msh?");
    read_format(words, reading);
    words.expect("$EndMeshFormat");
    for (std::string_view section = words.next(); !section.empty(); section = words.next()) {
        if (section.front() != '$')
            words.fail(
                fmt::format("\"{}\" stands where a section should begin. Save the mesh again?", Words::shown(section)));
        const std::string end = "$End" + std::string(section.substr(1));
        const bool known = section == "$PhysicalNames" || section == "$Nodes" || section == "$Elements";
        if (section == "$Entities") {
            read_entities(words, reading);
        } else if (known) {
            read_section(words, reading, section);
            words.expect(end);
        } else {
            words.skip_to(end);
        }
    }
    if (reading.mesh.quad.empty()) words.fail("there are no quads in the mesh. Mesh the surfaces before saving?");
    return std::move(reading.mesh);
}

}  // namespace ifedem
