#pragma once
#include <string>
#include <string_view>

namespace ifedem {

/// & < > " as entities.
[[nodiscard]] std::string escape_html(std::string_view text);

/// Escaped, with the quantities of the text set in italics and subscripts (P_d, r_e, K_c …).
[[nodiscard]] std::string typeset(std::string_view text);

[[nodiscard]] std::string encode_base64(std::string_view bytes);

/// An SVG file as an element of a page: no prolog, scalable, ids prefixed so that several can stand in one page.
[[nodiscard]] std::string inline_svg(std::string_view svg, std::string_view prefix, std::string_view description);

}  // namespace ifedem
