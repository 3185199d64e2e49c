#include "core/camera/frame_protocol.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/seeded_random.h"

namespace gripscan::frames {
namespace {

Result<Message> decoded(std::string_view bytes) {
    const auto header = decode_header(bytes.substr(0, std::min(bytes.size(), kHeaderBytes)));
    if (!header) return forward_error(header.error());
    return decode(*header, bytes.substr(kHeaderBytes));
}

StereoFrame noise(int width, int height, std::uint64_t seed) {
    SeededRandom random(seed);
    StereoFrame frame{cv::Mat(height, width, CV_8U), cv::Mat(height, width, CV_8U), 2.25};
    for (cv::Mat* image : {&frame.left, &frame.right}) {
        for (int i = 0; i < width * height; ++i) {
            image->data[i] = static_cast<std::uint8_t>(random.next());
        }
    }
    return frame;
}

Description description() {
    Description cell;
    cell.rig.image = {320, 240};
    cell.rig.K_left << 246.25, 0, 160.5, 0, 246.25, 119.0, 0, 0, 1;
    cell.rig.K_right = cell.rig.K_left * 1.5;
    cell.rig.D_left = {-0.06, 0.02, 0.1, 1.0 / 3.0};
    cell.rig.T_right_left.translation() = Eigen::Vector3d(-0.12, 0.001, 0.002);
    cell.region = Box{{-1, -2, -3}, {1, 2, 3}};
    return cell;
}

TEST(FrameProtocol, BringsRequestsBack) {
    const auto message = decoded(encode(AskFrame{-1, 3, 2}));
    ASSERT_TRUE(message) << message.error().message;
    const auto request = std::get<AskFrame>(*message);
    EXPECT_EQ(request.capture, -1);
    EXPECT_EQ(request.attempt, 3);
    EXPECT_EQ(request.exposure, 2);
    EXPECT_TRUE(std::holds_alternative<AskDescription>(decoded(encode(AskDescription{})).value()));
    EXPECT_EQ(std::get<Greeting>(decoded(encode(Greeting{7})).value()).version, 7U);
    EXPECT_EQ(std::get<Refusal>(decoded(encode(Refusal{"no light"})).value()).why, "no light");
}

TEST(FrameProtocol, BringsPicturesBackByteForByte) {
    for (const auto& [width, height] : {std::pair{1, 1}, {33, 7}, {320, 240}}) {
        const StereoFrame sent = noise(width, height, 5);
        const auto message = decoded(encode(sent));
        ASSERT_TRUE(message) << message.error().message;
        const auto& got = std::get<StereoFrame>(*message);
        EXPECT_EQ(got.t_s, sent.t_s);
        for (const auto& [a, b] : {std::pair{&sent.left, &got.left}, {&sent.right, &got.right}}) {
            ASSERT_EQ(a->size(), b->size());
            EXPECT_TRUE(std::equal(a->datastart, a->dataend, b->datastart));
        }
    }
}

TEST(FrameProtocol, SendsRowsOfAViewWithoutWhatLiesBetween) {
    const StereoFrame whole = noise(40, 30, 6);
    const cv::Rect part(3, 4, 20, 10);
    const auto message = decoded(encode(StereoFrame{whole.left(part), whole.right(part), 0.0}));
    ASSERT_TRUE(message);
    const auto& got = std::get<StereoFrame>(*message);
    EXPECT_EQ(got.left.at<std::uint8_t>(9, 19), whole.left.at<std::uint8_t>(13, 22));
}

TEST(FrameProtocol, BringsTheDescriptionBackExactly) {
    for (const bool hint : {false, true}) {
        Description sent = description();
        if (hint) sent.axis_hint = Eigen::Vector3d(0.1, 0.2, 0.3);
        const auto message = decoded(encode(sent));
        ASSERT_TRUE(message) << message.error().message;
        const auto& got = std::get<Description>(*message);
        EXPECT_EQ(got.rig.image, sent.rig.image);
        EXPECT_EQ(got.rig.K_left, sent.rig.K_left);
        EXPECT_EQ(got.rig.K_right, sent.rig.K_right);
        EXPECT_EQ(got.rig.D_left, sent.rig.D_left);
        EXPECT_EQ(got.rig.D_right, sent.rig.D_right);
        EXPECT_EQ(got.rig.T_right_left.matrix(), sent.rig.T_right_left.matrix());
        EXPECT_EQ(got.region.value().min_m, sent.region->min_m);
        EXPECT_EQ(got.axis_hint, sent.axis_hint);
    }
}

TEST(FrameProtocol, TakesNothingThatIsCutShortOrTooLong) {
    for (const Message& message : {Message(AskFrame{1, 2, 3}), Message(description()),
                                   Message(noise(9, 5, 1)), Message(Greeting{})}) {
        const std::string bytes = encode(message);
        const Header header = decode_header(bytes.substr(0, kHeaderBytes)).value();
        const std::string payload = bytes.substr(kHeaderBytes);
        ASSERT_TRUE(decode(header, payload));
        for (std::size_t n = 0; n < payload.size(); ++n) {
            EXPECT_FALSE(decode(header, payload.substr(0, n))) << n;
        }
        EXPECT_FALSE(decode(header, payload + "x"));
    }
}

TEST(FrameProtocol, TakesNoOtherProtocolAndNoHugeMessage) {
    EXPECT_FALSE(decode_header("HTTP/1.1 200"));
    EXPECT_FALSE(decode_header("GSFP"));
    std::string huge = encode(Greeting{}).substr(0, kHeaderBytes);
    huge.replace(8, 4, "\xff\xff\xff\xff");
    const auto header = decode_header(huge);
    ASSERT_FALSE(header);
    EXPECT_NE(header.error().message.find("4294967295 bytes"), std::string::npos);
    EXPECT_FALSE(decode({99, 0}, ""));
    // A picture that claims more pixels than there are bytes.
    std::string lie = encode(noise(4, 4, 1)).substr(kHeaderBytes);
    lie[1] = 0x20;
    EXPECT_FALSE(decode({103, lie.size()}, lie));
}

}  // namespace
}  // namespace gripscan::frames
