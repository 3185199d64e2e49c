#include "core/stereo/rig_file.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "core/base/seeded_random.h"
#include "tests/support/test_data.h"
#include "tests/unit/stereo/board_images.h"

namespace gripscan::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path file_named(const std::string& name) {
    return fs::path(testing::TempDir()) / ("gripscan_rig_" + name + ".yaml");
}

std::string saved_text() {
    const fs::path path = file_named("text");
    EXPECT_TRUE(save_rig(path, distorted_rig()));
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

Result<StereoRig> load_text(const std::string& text) {
    const fs::path path = file_named("broken");
    std::ofstream(path) << text;
    return load_rig(path);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(RigFile, ReadsBackWhatItWroteToTheLastBit) {
    SeededRandom random(3);
    for (int i = 0; i < 20; ++i) {
        StereoRig rig = distorted_rig();
        rig.K_left(0, 0) = random.uniform(300.0, 2000.0);
        rig.D_right = {random.normal() * 0.1, random.normal() * 1e-7, random.normal(), 0.0};
        rig.T_right_left.linear() = rotation_from_vector({0.01, random.normal() * 0.05, 0.02});
        rig.T_right_left.translation().x() = -random.uniform(0.05, 0.5);
        const fs::path path = file_named("round");
        ASSERT_TRUE(save_rig(path, rig));
        const auto read = load_rig(path);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->image, rig.image);
        EXPECT_EQ(read->K_left, rig.K_left);
        EXPECT_EQ(read->K_right, rig.K_right);
        EXPECT_EQ(read->D_left, rig.D_left);
        EXPECT_EQ(read->D_right, rig.D_right);
        EXPECT_EQ(read->T_right_left.matrix(), rig.T_right_left.matrix());
    }
}

TEST(RigFile, EveryTruncationIsAnErrorThatNamesTheFile) {
    const std::string text = saved_text();
    // Without its last number the file is still a rig only once the vector T is complete.
    const std::size_t complete = text.rfind(']');
    for (std::size_t length = 0; length < complete; length += 17) {
        const auto rig = load_text(text.substr(0, length));
        ASSERT_FALSE(rig) << length;
        EXPECT_THAT(rig.error().message, HasSubstr("gripscan_rig_broken.yaml"));
    }
}

TEST(RigFile, NamesTheKeyThatIsMissingOrWrong) {
    const std::string text = saved_text();
    const auto expect = [&](const std::string& from, const std::string& to,
                            const std::string& message) {
        const auto rig = load_text(replaced(text, from, to));
        ASSERT_FALSE(rig) << from << " -> " << to;
        EXPECT_THAT(rig.error().message, HasSubstr(message));
    };
    expect("K2:", "Kzwei:", "key K2 is missing");
    expect("image_width: 640", "image_width: wide", "image_width");
    expect("image_width: 640", "image_width: 640.5", "image_width");
    expect("image_width: 640", "image_width: 4", "no image size");
    expect("-1.0000000000000001e-01", ".Nan", "key T");
    expect("-1.0000000000000001e-01", "1.0000000000000001e-01", "wrong sign");
    expect("-1.0000000000000001e-01", "0.", "wrong sign");
    expect("-1.0000000000000001e-01", "-1.0000000000000001e+02", "millimetres");
    expect("-2.0000000000000001e-01", ".Inf", "key D1");
}

TEST(RigFile, RefusesWhatIsNoRig) {
    EXPECT_THAT(load_rig("/nowhere/rig.yaml").error().message, HasSubstr("/nowhere/rig.yaml"));
    EXPECT_FALSE(load_text(""));
    EXPECT_FALSE(load_text("hello"));
    EXPECT_FALSE(load_text("%YAML:1.0\n---\nK1: 3\n"));
    StereoRig rig = distorted_rig();
    rig.T_right_left.translation().setZero();
    EXPECT_FALSE(save_rig(file_named("zero"), rig));
    EXPECT_FALSE(fs::exists(file_named("zero")));
}

TEST(RigFile, ReadsTheRecordings) {
    GRIPSCAN_TEST_DATA(temple, "temple-turn/rig.yaml");
    const auto rig = load_rig(temple);
    ASSERT_TRUE(rig) << rig.error().message;
    EXPECT_EQ(rig->image, (ImageSize{480, 640}));
    EXPECT_DOUBLE_EQ(rig->K_left(0, 0), 1525.9);
    EXPECT_NEAR(rig->baseline_m(), 0.07517, 1e-5);
}

}  // namespace
}  // namespace gripscan::test
