#include "core/camera/frame_protocol.h"

#include <cmath>
#include <cstring>

#include "core/camera/wire_bytes.h"

namespace gripscan::frames {
namespace {

constexpr std::string_view kMagic = "GSFP";
constexpr int kLongestSide_px = 16384;
constexpr std::uint32_t kMostDistortion = 14;  ///< coefficients of OpenCV's longest model

enum Type : std::uint32_t {
    kAskDescription = 1,
    kAskFrame = 2,
    kGreeting = 101,
    kDescription = 102,
    kFrame = 103,
    kRefusal = 104,
};

template <typename Derived>
void put_matrix(ByteWriter& writer, const Eigen::MatrixBase<Derived>& M) {
    for (int row = 0; row < M.rows(); ++row) {
        for (int column = 0; column < M.cols(); ++column) writer.f64(M(row, column));
    }
}

template <typename Matrix>
Matrix get_matrix(ByteReader& reader) {
    Matrix M;
    for (int row = 0; row < M.rows(); ++row) {
        for (int column = 0; column < M.cols(); ++column) M(row, column) = reader.f64();
    }
    return M;
}

void put_numbers(ByteWriter& writer, const std::vector<double>& numbers) {
    writer.u32(static_cast<std::uint32_t>(numbers.size()));
    for (const double number : numbers) writer.f64(number);
}

std::vector<double> get_numbers(ByteReader& reader) {
    std::vector<double> numbers(std::min(reader.u32(), kMostDistortion));
    for (double& number : numbers) number = reader.f64();
    return numbers;
}

std::string_view bytes_of(const cv::Mat& row) {
    return {row.ptr<char>(), row.total()};
}

struct Writer {
    ByteWriter& bytes;

    void operator()(const AskDescription&) const {}
    void operator()(const AskFrame& request) const {
        bytes.i32(request.capture);
        bytes.i32(request.attempt);
        bytes.i32(request.exposure);
    }
    void operator()(const Greeting& greeting) const { bytes.u32(greeting.version); }
    void operator()(const Description& cell) const {
        bytes.i32(cell.rig.image.width);
        bytes.i32(cell.rig.image.height);
        put_matrix(bytes, cell.rig.K_left);
        put_matrix(bytes, cell.rig.K_right);
        put_numbers(bytes, cell.rig.D_left);
        put_numbers(bytes, cell.rig.D_right);
        put_matrix(bytes, Eigen::Matrix4d(cell.rig.T_right_left.matrix()));
        bytes.u32(cell.region ? 1 : 0);
        if (cell.region) {
            put_matrix(bytes, cell.region->min_m);
            put_matrix(bytes, cell.region->max_m);
        }
        bytes.u32(cell.axis_hint ? 1 : 0);
        if (cell.axis_hint) put_matrix(bytes, *cell.axis_hint);
    }
    void operator()(const StereoFrame& frame) const {
        bytes.i32(frame.left.cols);
        bytes.i32(frame.left.rows);
        bytes.f64(frame.t_s);
        for (const cv::Mat* image : {&frame.left, &frame.right}) {
            for (int row = 0; row < image->rows; ++row) bytes.raw(bytes_of(image->row(row)));
        }
    }
    void operator()(const Refusal& refusal) const { bytes.raw(refusal.why); }
};

/// In the order of the alternatives of Message.
constexpr std::array<Type, 6> kTypes = {kAskDescription, kAskFrame, kGreeting,
                                        kDescription,    kFrame,    kRefusal};

Message read_description(ByteReader& reader) {
    Description cell;
    cell.rig.image.width = reader.i32();
    cell.rig.image.height = reader.i32();
    cell.rig.K_left = get_matrix<Eigen::Matrix3d>(reader);
    cell.rig.K_right = get_matrix<Eigen::Matrix3d>(reader);
    cell.rig.D_left = get_numbers(reader);
    cell.rig.D_right = get_numbers(reader);
    cell.rig.T_right_left.matrix() = get_matrix<Eigen::Matrix4d>(reader);
    if (reader.u32() != 0) {
        Box region;
        region.min_m = get_matrix<Eigen::Vector3d>(reader);
        region.max_m = get_matrix<Eigen::Vector3d>(reader);
        cell.region = region;
    }
    if (reader.u32() != 0) cell.axis_hint = get_matrix<Eigen::Vector3d>(reader);
    return cell;
}

Result<Message> read_frame(ByteReader& reader) {
    const int width = reader.i32();
    const int height = reader.i32();
    StereoFrame frame;
    frame.t_s = reader.f64();
    if (width < 1 || height < 1 || width > kLongestSide_px || height > kLongestSide_px) {
        return device_error("frame port: a picture of {} x {} px", width, height);
    }
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (reader.left() != 2 * pixels) {
        return device_error("frame port: two pictures of {} x {} px in {} bytes", width, height,
                            reader.left());
    }
    for (cv::Mat* image : {&frame.left, &frame.right}) {
        image->create(height, width, CV_8U);
        std::memcpy(image->data, reader.raw(pixels).data(), pixels);
    }
    return frame;
}

Result<Message> read_message(std::uint32_t type, ByteReader& reader) {
    switch (type) {
        case kAskDescription:
            return AskDescription{};
        case kAskFrame: {
            AskFrame request;
            request.capture = reader.i32();
            request.attempt = reader.i32();
            request.exposure = reader.i32();
            return request;
        }
        case kGreeting:
            return Greeting{reader.u32()};
        case kDescription:
            return read_description(reader);
        case kFrame:
            return read_frame(reader);
        case kRefusal:
            return Refusal{std::string(reader.raw(reader.left()))};
        default:
            return device_error("frame port: no message has the type {}", type);
    }
}

}  // namespace

std::string encode(const Message& message) {
    ByteWriter payload;
    std::visit(Writer{payload}, message);
    const std::string bytes = payload.take();
    ByteWriter writer;
    writer.raw(kMagic);
    writer.u32(kTypes.at(message.index()));
    writer.u32(static_cast<std::uint32_t>(bytes.size()));
    writer.raw(bytes);
    return writer.take();
}

Result<Header> decode_header(std::string_view bytes) {
    ByteReader reader(bytes);
    if (reader.raw(kMagic.size()) != kMagic) {
        return device_error("frame port: the other side does not speak this protocol");
    }
    Header header;
    header.type = reader.u32();
    header.payload_bytes = reader.u32();
    if (!reader.is_at_end()) return device_error("frame port: a message's head was cut short");
    if (header.payload_bytes > kLongestPayload) {
        return device_error("frame port: a message of {} bytes; at most {} are taken",
                            header.payload_bytes, kLongestPayload);
    }
    return header;
}

Result<Message> decode(const Header& header, std::string_view payload) {
    ByteReader reader(payload);
    auto message = read_message(header.type, reader);
    if (message && !reader.is_at_end()) {
        return device_error("frame port: a message of type {} is {}", header.type,
                            reader.is_short() ? "cut short" : "longer than it says");
    }
    return message;
}

}  // namespace gripscan::frames
