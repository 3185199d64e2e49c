#include "core/session/csv_text.h"

namespace gripscan {
namespace {

class CsvParser {
  public:
    CsvParser(std::string_view file, std::string_view text) : file_(file), text_(text) {
        if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;
    }

    Result<std::vector<CsvLine>> parse() {
        std::vector<CsvLine> lines;
        while (at_ < text_.size()) {
            CsvLine line{line_, {}};
            if (Status status = read_line(line.cells); !status)
                return forward_error(status.error());
            if (line.cells.size() > 1 || !line.cells.front().empty()) {
                lines.push_back(std::move(line));
            }
        }
        return lines;
    }

  private:
    Status read_line(std::vector<std::string>& cells) {
        while (true) {
            auto cell = next() == '"' ? quoted() : plain();
            if (!cell) return forward_error(cell.error());
            cells.push_back(std::move(*cell));
            if (next() == ',') {
                ++at_;
                continue;
            }
            if (next() == '\r') ++at_;
            if (at_ < text_.size() && next() != '\n') {
                return input_error("{}:{}: text after a closing quote", file_, line_);
            }
            ++at_;
            ++line_;
            return {};
        }
    }

    Result<std::string> plain() {
        const auto end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
        std::string cell(text_.substr(at_, end - at_));
        at_ = end;
        return cell;
    }

    Result<std::string> quoted() {
        const int opened = line_;
        std::string cell;
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] == '"') {
                if (++at_ >= text_.size() || text_[at_] != '"') return cell;
            }
            if (text_[at_] == '\n') ++line_;
            cell += text_[at_];
        }
        return input_error("{}:{}: a quoted cell is never closed", file_, opened);
    }

    [[nodiscard]] char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    std::string_view file_;
    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
};

}  // namespace

Result<std::vector<CsvLine>> parse_csv(std::string_view file, std::string_view text) {
    return CsvParser(file, text).parse();
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string csv_line(const std::vector<std::string>& cells) {
    std::string line;
    for (const auto& cell : cells) {
        if (&cell != &cells.front()) line += ',';
        if (cell.find_first_of(",\"\r\n") == std::string::npos) {
            line += cell;
            continue;
        }
        line += '"';
        for (const char c : cell) {
            if (c == '"') line += '"';
            line += c;
        }
        line += '"';
    }
    return line + '\n';
}

}  // namespace gripscan
