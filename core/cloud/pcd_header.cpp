#include "core/cloud/pcd_header.h"

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "core/cloud/text_scan.h"

namespace gripscan {
namespace {

constexpr std::size_t kMaxHeaderLines = 200;
constexpr std::size_t kMaxFields = 256;
constexpr std::size_t kMaxCount = 4096;
constexpr std::size_t kMaxPoints = std::size_t{1} << 31;
/// LZF stores at most 264 bytes in three.
constexpr std::size_t kMaxLzfRatio = 88;
constexpr std::size_t kLzfSizes = 8;

/// One line of the header: its words after the keyword, and where it stands.
struct Entry {
    std::vector<std::string> words;
    std::size_t line = 0;
};
using Entries = std::map<std::string, Entry, std::less<>>;

Result<Entries> read_entries(std::string_view bytes, PcdHeader& header) {
    Entries entries;
    LineScanner lines(bytes);
    std::vector<std::string_view> words;
    while (lines.line_number() < kMaxHeaderLines) {
        const auto line = lines.next();
        if (!line) break;
        split_words(*line, kBlanks, words);
        if (words.empty() || words[0].starts_with('#')) continue;
        std::string keyword(words[0] == "COLUMNS" ? "FIELDS" : words[0]);
        const Entry entry{{words.begin() + 1, words.end()}, lines.line_number()};
        if (!entries.emplace(keyword, entry).second) {
            return input_error("line {}: {} appears twice", entry.line, keyword);
        }
        if (keyword == "DATA") {
            header.body_offset = lines.offset();
            header.body_line = lines.line_number() + 1;
            return entries;
        }
    }
    return input_error("this is no PCD file: no line DATA in its head");
}

Result<std::vector<std::size_t>> counts_of(const Entries& entries, std::string_view keyword,
                                           std::size_t expected, std::size_t limit) {
    const auto found = entries.find(keyword);
    if (found == entries.end()) return input_error("the head has no line {}", keyword);
    const auto& [words, line] = found->second;
    if (words.size() != expected) {
        return input_error("line {}: {} has {} entries instead of {}", line, keyword, words.size(),
                           expected);
    }
    std::vector<std::size_t> counts;
    for (const auto& word : words) {
        const auto count = count_from_word(word);
        if (!count || *count > limit) {
            return input_error("line {}: {} {} is no whole number up to {}", line, keyword, word,
                               limit);
        }
        counts.push_back(*count);
    }
    return counts;
}

std::optional<NumberType> number_type(std::string_view letter, std::size_t size) {
    using enum NumberType;
    static constexpr std::array<std::tuple<char, std::size_t, NumberType>, 10> kTypes{
        {{'I', 1, kInt8},
         {'U', 1, kUint8},
         {'I', 2, kInt16},
         {'U', 2, kUint16},
         {'I', 4, kInt32},
         {'U', 4, kUint32},
         {'I', 8, kInt64},
         {'U', 8, kUint64},
         {'F', 4, kFloat32},
         {'F', 8, kFloat64}}};
    for (const auto& [known_letter, known_size, type] : kTypes) {
        if (letter.size() == 1 && letter[0] == known_letter && size == known_size) return type;
    }
    return std::nullopt;
}

Status read_fields(const Entries& entries, PcdHeader& header) {
    const auto names = entries.find("FIELDS");
    const auto types = entries.find("TYPE");
    if (names == entries.end()) return input_error("the head has no line FIELDS");
    if (types == entries.end()) return input_error("the head has no line TYPE");
    const std::size_t n = names->second.words.size();
    if (n == 0 || n > kMaxFields || types->second.words.size() != n) {
        return input_error("line {}: {} FIELDS and {} TYPEs; both must be the same, up to {}",
                           names->second.line, n, types->second.words.size(), kMaxFields);
    }
    const auto sizes = counts_of(entries, "SIZE", n, 8);
    if (!sizes) return forward_error(sizes.error());
    std::vector<std::size_t> counts(n, 1);
    if (entries.contains("COUNT")) {
        auto given = counts_of(entries, "COUNT", n, kMaxCount);
        if (!given) return forward_error(given.error());
        counts = std::move(*given);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const auto type = number_type(types->second.words[i], (*sizes)[i]);
        if (!type) {
            return input_error("line {}: TYPE {} of SIZE {} is no number of PCD",
                               types->second.line, types->second.words[i], (*sizes)[i]);
        }
        header.fields.push_back({names->second.words[i], *type, counts[i]});
    }
    return {};
}

Status read_size(const Entries& entries, PcdHeader& header) {
    const auto width = counts_of(entries, "WIDTH", 1, kMaxPoints);
    if (!width) return forward_error(width.error());
    const auto height = counts_of(entries, "HEIGHT", 1, kMaxPoints);
    if (!height) return forward_error(height.error());
    header.width = width->front();
    header.height = height->front();
    if (header.points() > kMaxPoints) {
        return input_error("{} x {} points are too many", header.width, header.height);
    }
    if (!entries.contains("POINTS")) return {};
    const auto points = counts_of(entries, "POINTS", 1, kMaxPoints);
    if (!points) return forward_error(points.error());
    if (points->front() != header.points()) {
        return input_error("WIDTH {} x HEIGHT {} are not POINTS {}", header.width, header.height,
                           points->front());
    }
    return {};
}

Status read_viewpoint(const Entries& entries, PcdHeader& header) {
    const auto found = entries.find("VIEWPOINT");
    if (found == entries.end()) return {};
    const auto& [words, line] = found->second;
    Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 7; ++i) {
        const auto value = i < words.size() ? value_from_word(words[i]) : std::nullopt;
        if (!value || !std::isfinite(*value)) {
            return input_error("line {}: VIEWPOINT needs seven numbers tx ty tz qw qx qy qz", line);
        }
        if (i < 3) viewpoint[static_cast<Eigen::Index>(i)] = *value;
    }
    header.viewpoint = viewpoint;
    return {};
}

Status read_encoding(const Entries& entries, PcdHeader& header) {
    const auto& [words, line] = entries.at("DATA");
    const std::string name = words.size() == 1 ? words[0] : "";
    if (name == "ascii") {
        header.encoding = PcdEncoding::kAscii;
    } else if (name == "binary") {
        header.encoding = PcdEncoding::kBinary;
    } else if (name == "binary_compressed") {
        header.encoding = PcdEncoding::kCompressed;
    } else {
        return input_error("line {}: DATA must be ascii, binary or binary_compressed", line);
    }
    return {};
}

/// The least a body of so many points can be long. Overflow is impossible within the limits.
std::size_t least_body_size(const PcdHeader& header) {
    switch (header.encoding) {
        case PcdEncoding::kAscii:
            return 2 * header.points() * header.numbers_per_point();
        case PcdEncoding::kBinary:
            return header.points() * header.bytes_per_point();
        case PcdEncoding::kCompressed:
            return kLzfSizes + header.points() * header.bytes_per_point() / kMaxLzfRatio;
    }
    return 0;
}

}  // namespace

std::size_t PcdHeader::numbers_per_point() const {
    std::size_t numbers = 0;
    for (const PcdField& field : fields) numbers += field.count;
    return numbers;
}

std::size_t PcdHeader::bytes_per_point() const {
    std::size_t bytes = 0;
    for (const PcdField& field : fields) bytes += field.count * size_of(field.type);
    return bytes;
}

Result<PcdHeader> parse_pcd_header(std::string_view bytes) {
    PcdHeader header;
    const auto entries = read_entries(bytes, header);
    if (!entries) return forward_error(entries.error());
    for (const auto read : {read_fields, read_size, read_viewpoint, read_encoding}) {
        if (const Status status = read(*entries, header); !status) {
            return forward_error(status.error());
        }
    }
    const std::size_t present = bytes.size() - header.body_offset;
    const std::size_t needed = least_body_size(header);
    // The last line of a text may lack its end.
    if (present + (header.encoding == PcdEncoding::kAscii ? 1 : 0) < needed) {
        return input_error("the file is cut off: {} points need at least {} bytes, {} are there",
                           header.points(), needed, present);
    }
    return header;
}

}  // namespace gripscan
