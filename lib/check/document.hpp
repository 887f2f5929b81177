#pragma once
#include <string>
#include <variant>
#include <vector>

namespace ifedem {

// A report before it takes a form: the same document becomes HTML and Markdown, so that the two cannot disagree.

struct Paragraph {
    std::string text;
    std::string style;  ///< CSS class, "" for plain
};

struct BulletList {
    std::vector<std::string> items;
};

struct Cell {
    std::string text;
    std::string style = {};  ///< CSS class such as a verdict
    std::string link = {};   ///< where the text leads, "" if nowhere
};

struct Table {
    std::string caption;
    std::string style;  ///< "cards": rows become cards on a narrow screen; "wide": the table scrolls sideways
    std::vector<std::string> header;
    std::vector<std::vector<Cell>> rows;
    std::string data_file;  ///< CSV beside the report, "" if none
};

struct Figure {
    std::string name;  ///< fig3-7b
    std::string title;
    std::string caption;
    std::string image;  ///< from the report's directory, .svg or .png
    std::string data;   ///< CSV, from the report's directory
    std::string style;  ///< "full" for the whole width
};

struct FigureGroup {
    std::vector<Figure> figures;
};

using SectionPart = std::variant<Paragraph, BulletList, Table, FigureGroup>;

struct Section {
    std::string id;
    std::string title;
    std::vector<SectionPart> blocks;
};

/// One part of the first line's count.
struct Tally {
    std::string style;
    std::string label;
    std::size_t count = 0;
};

struct Document {
    std::string title;
    std::string subtitle;
    std::string first_line;  ///< counts all verdicts
    std::vector<Tally> tallies;
    std::vector<Section> sections;
};

/// One file that needs nothing else: style, SVG and PNG are inside. `directory` is where the images are.
/// `page` is the template with {{title}}, {{style}} and {{body}}; `css` goes into {{style}}.
[[nodiscard]] std::string to_html(const Document& document, const std::string& directory, const std::string& page,
                                  const std::string& css);
/// The same as `directory`/index.html, with report.html and report.css of the directory `templates`. Throws Error(io).
void write_html(const Document& document, const std::string& directory, const std::string& templates);

[[nodiscard]] std::string to_markdown(const Document& document);

}  // namespace ifedem
