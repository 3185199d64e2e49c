#include "ui/widgets/rich_text.h"

#include <string>
#include <vector>

#include "ui/widgets/draw.h"

namespace gripscan::ui {
namespace {

struct Piece {
    std::string_view text;
    bool number;
};
using Word = std::vector<Piece>;  ///< what stays together

std::vector<Word> words_of(std::string_view text) {
    std::vector<Word> words(1);
    bool number = false;
    std::size_t begin = 0;
    const auto close_piece = [&](std::size_t end) {
        if (end > begin) words.back().push_back({text.substr(begin, end - begin), number});
        begin = end + 1;
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '`') {
            close_piece(i);
            number = !number;
        } else if (text[i] == ' ' && !number) {
            close_piece(i);
            if (!words.back().empty()) words.emplace_back();
        }
    }
    close_piece(text.size());
    return words;
}

/// Calls place(piece, x offset, line) for every piece; returns the number of lines.
template <typename Place>
int lay_out(const Ui& ui, float width, std::string_view text, const TextStyle& style,
            const Place& place) {
    const float blank = text_width(ui, style.words, " ");
    float x = 0.0F;
    int line = 0;
    for (const Word& word : words_of(text)) {
        float word_width = 0.0F;
        for (const Piece& p : word) {
            word_width += text_width(ui, p.number ? style.numbers : style.words, p.text);
        }
        if (x > 0.0F && x + word_width > width) {
            x = 0.0F;
            ++line;
        }
        for (const Piece& p : word) {
            place(p, x, line);
            x += text_width(ui, p.number ? style.numbers : style.words, p.text);
        }
        x += blank;
    }
    return line + 1;
}

}  // namespace

int draw_rich_text(const Ui& ui, int x, int y, int width, const Colour& colour,
                   std::string_view text, const TextStyle& style) {
    const int line_height =
        ui.em(style.line_em * ui.fonts.em_px(style.words) / (kTextSizePx * ui.scale.factor()));
    const int lines = lay_out(
        ui, static_cast<float>(width), text, style, [&](const Piece& p, float dx, int line) {
            draw_text(
                ui, static_cast<float>(x) + dx,
                static_cast<float>(y + line * line_height) + 0.5F * static_cast<float>(line_height),
                p.number ? style.numbers : style.words, colour, p.text);
        });
    return lines * line_height;
}

int rich_text_height(const Ui& ui, int width, std::string_view text, const TextStyle& style) {
    const int line_height =
        ui.em(style.line_em * ui.fonts.em_px(style.words) / (kTextSizePx * ui.scale.factor()));
    return line_height *
           lay_out(ui, static_cast<float>(width), text, style, [](const Piece&, float, int) {});
}

}  // namespace gripscan::ui
