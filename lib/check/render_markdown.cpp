#include <fmt/format.h>

#include "check/document.hpp"

namespace ifedem {
namespace {

/// A cell may not end its row.
std::string markdown_cell(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '|') out += '\\';
        out += c == '\n' ? ' ' : c;
    }
    return out;
}

std::string markdown_cell(const Cell& cell) {
    const std::string text = markdown_cell(cell.text);
    return cell.link.empty() ? text : fmt::format("[{}]({})", text, cell.link);
}

std::string render(const Paragraph& p) { return p.text + "\n\n"; }

std::string render(const BulletList& list) {
    std::string out;
    for (const auto& item : list.items) out += "- " + item + "\n";
    return out + "\n";
}

std::string render(const Table& table) {
    std::string out = table.caption.empty() ? "" : table.caption + "\n\n";
    std::string rule = "|";
    out += "|";
    for (const auto& name : table.header) {
        out += " " + markdown_cell(name) + " |";
        rule += "---|";
    }
    out += "\n" + rule + "\n";
    for (const auto& row : table.rows) {
        out += "|";
        for (const auto& cell : row) out += " " + markdown_cell(cell) + " |";
        out += "\n";
    }
    if (!table.data_file.empty()) out += fmt::format("\n[{0}]({0})\n", table.data_file);
    return out + "\n";
}

std::string render(const FigureGroup& group) {
    std::string out;
    for (const auto& f : group.figures) {
        out += fmt::format("**{0}**\n\n![{0}]({1})\n\n{2}", f.title, f.image, f.caption);
        out += f.data.empty() ? "\n\n" : fmt::format(" ([data]({}))\n\n", f.data);
    }
    return out;
}

}  // namespace

std::string to_markdown(const Document& document) {
    std::string out = fmt::format("{}\n\n# {}\n\n{}\n\n", document.first_line, document.title, document.subtitle);
    for (const auto& section : document.sections) {
        out += fmt::format("## {}\n\n", section.title);
        for (const auto& block : section.blocks) out += std::visit([](const auto& b) { return render(b); }, block);
    }
    return out;
}

}  // namespace ifedem
