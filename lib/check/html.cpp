#include "check/html.hpp"

#include <array>
#include <cstdint>
#include <utility>

namespace ifedem {
namespace {

std::string replace_all(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/// A hyphen before a digit at the beginning of a word is a minus sign.
std::string with_minus_signs(std::string_view text) {
    std::string out;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const bool begins = k == 0 || text[k - 1] == ' ' || text[k - 1] == '(';
        const bool negates = k + 1 < text.size() && text[k + 1] >= '0' && text[k + 1] <= '9';
        if (text[k] == '-' && begins && negates) {
            out += "\u2212";
        } else {
            out += text[k];
        }
    }
    return out;
}

}  // namespace

std::string escape_html(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string typeset(std::string_view text) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 9> quantities{
        {{"P_d", "<i>P</i><sub>d</sub>"},
         {"r_e", "<i>r</i><sub>e</sub>"},
         {"K_c", "<i>K</i><sub>c</sub>"},
         {"F_x", "<i>F</i><sub>x</sub>"},
         {"F_y", "<i>F</i><sub>y</sub>"},
         {"K_d", "<i>K</i><sub>d</sub>"},
         {"f_n", "<i>f</i><sub>n</sub>"},
         {"M_r", "<i>M</i><sub>r</sub>"},
         {"u_read", "<i>u</i><sub>read</sub>"}}};
    std::string out = escape_html(with_minus_signs(text));
    for (const auto& [plain, set] : quantities) out = replace_all(std::move(out), plain, set);
    return out;
}

std::string encode_base64(std::string_view bytes) {
    static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = (word << 8) | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) out += at + k <= bytes.size() ? digits[(word >> (18 - 6 * k)) & 63U] : '=';
    }
    return out;
}

std::string inline_svg(std::string_view svg, std::string_view prefix, std::string_view description) {
    const std::size_t start = svg.find("<svg");
    std::string text(start == std::string_view::npos ? svg : svg.substr(start));
    const std::string p(prefix);
    for (const char* quote : {"'", "\""}) {
        const std::string q(quote);
        text = replace_all(std::move(text), " id=" + q, " id=" + q + p + "-");
        text = replace_all(std::move(text), "href=" + q + "#", "href=" + q + "#" + p + "-");
    }
    text = replace_all(std::move(text), "url(#", "url(#" + p + "-");
    const std::size_t end = text.find('>');
    if (end != std::string::npos) text.insert(end, " role=\"img\" aria-label=\"" + escape_html(description) + "\"");
    return text;
}

}  // namespace ifedem
