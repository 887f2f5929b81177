#include <fmt/format.h>

#include "check/csv.hpp"
#include "check/document.hpp"
#include "check/html.hpp"

namespace ifedem {
namespace {

std::string class_attribute(const std::string& style) {
    return style.empty() ? std::string() : fmt::format(" class=\"{}\"", style);
}

std::string render(const Paragraph& p, const std::string&) {
    return fmt::format("<p{}>{}</p>\n", class_attribute(p.style), typeset(p.text));
}

std::string render(const BulletList& list, const std::string&) {
    std::string out = "<ul>\n";
    for (const auto& item : list.items) out += fmt::format("<li>{}</li>\n", typeset(item));
    return out + "</ul>\n";
}

std::string render(const Cell& cell) {
    if (cell.link.empty()) return typeset(cell.text);
    return fmt::format("<a href=\"{}\">{}</a>", escape_html(cell.link), typeset(cell.text));
}

std::string render(const Table& table, const std::string&) {
    std::string out = fmt::format("<div class=\"table {}\"><table>\n", table.style);
    if (!table.caption.empty()) out += fmt::format("<caption>{}</caption>\n", typeset(table.caption));
    out += "<thead><tr>";
    for (std::size_t k = 0; k < table.header.size(); ++k) {
        const bool is_number = !table.rows.empty() && table.rows[0][k].style.starts_with("num");
        out += fmt::format("<th scope=\"col\"{}>{}</th>", class_attribute(is_number ? "num" : ""),
                           typeset(table.header[k]));
    }
    out += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
        out += "<tr>";
        for (std::size_t k = 0; k < row.size(); ++k)
            // The label lets the style sheet turn rows into cards where the screen is narrow.
            out += fmt::format("<td{} data-label=\"{}\"><span>{}</span></td>", class_attribute(row[k].style),
                               escape_html(table.header[k]), render(row[k]));
        out += "</tr>\n";
    }
    out += "</tbody></table></div>\n";
    if (!table.data_file.empty())
        out += fmt::format("<p class=\"data\"><a href=\"{0}\">{0}</a></p>\n", escape_html(table.data_file));
    return out;
}

std::string render_image(const Figure& figure, const std::string& directory) {
    const std::string bytes = read_text(directory + "/" + figure.image);
    if (figure.image.ends_with(".svg")) return inline_svg(bytes, figure.name, figure.title);
    return fmt::format("<img alt=\"{}\" src=\"data:image/{};base64,{}\">", escape_html(figure.title),
                       figure.image.ends_with(".gif") ? "gif" : "png", encode_base64(bytes));
}

std::string render(const FigureGroup& group, const std::string& directory) {
    std::string out = "<div class=\"figures\">\n";
    for (const auto& figure : group.figures) {
        const std::string data =
            figure.data.empty() ? "" : fmt::format(" <a href=\"{}\">data</a>", escape_html(figure.data));
        out += fmt::format(
            "<figure id=\"{}\"{}>\n<figcaption class=\"above\">{}</figcaption>\n{}\n"
            "<figcaption>{}<span class=\"links\"><a href=\"{}\">image</a>{}</span></figcaption>\n</figure>\n",
            figure.name, class_attribute(figure.style), typeset(figure.title), render_image(figure, directory),
            typeset(figure.caption), escape_html(figure.image), data);
    }
    return out + "</div>\n";
}

std::string render_header(const Document& document) {
    std::string out = fmt::format(
        "<header>\n<p class=\"counts\" id=\"verdicts-line\">{}</p>\n<div class=\"bar\" aria-hidden=\"true\">",
        escape_html(document.first_line));
    for (const auto& t : document.tallies)
        if (t.count > 0)
            out += fmt::format("<span class=\"{}\" style=\"flex:{}\">{}</span>", t.style, t.count, t.count);
    out += fmt::format("</div>\n<h1>{}</h1>\n<p class=\"subtitle\">{}</p>\n<nav>", typeset(document.title),
                       typeset(document.subtitle));
    for (const auto& section : document.sections)
        out += fmt::format("<a href=\"#{}\">{}</a>", section.id, typeset(section.title));
    return out + "</nav>\n</header>\n";
}

std::string fill(std::string page, const std::string& mark, const std::string& text) {
    const std::size_t at = page.find(mark);
    if (at != std::string::npos) page.replace(at, mark.size(), text);
    return page;
}

}  // namespace

std::string to_html(const Document& document, const std::string& directory, const std::string& page,
                    const std::string& css) {
    std::string body = render_header(document) + "<main>\n";
    for (const auto& section : document.sections) {
        body += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n", section.id, typeset(section.title));
        for (const auto& block : section.blocks)
            body += std::visit([&](const auto& b) { return render(b, directory); }, block);
        body += "</section>\n";
    }
    body += "</main>\n";
    return fill(fill(fill(page, "{{title}}", escape_html(document.title)), "{{style}}", css), "{{body}}", body);
}

void write_html(const Document& document, const std::string& directory, const std::string& templates) {
    write_text(directory + "/index.html", to_html(document, directory, read_text(templates + "/report.html"),
                                                  read_text(templates + "/report.css")));
}

}  // namespace ifedem
