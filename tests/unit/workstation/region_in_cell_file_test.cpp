#include "app/workstation/region_in_cell_file.h"

#include <gmock/gmock.h>

#include "core/base/atomic_file.h"
#include "core/session/cell_file.h"
#include "tests/support/temporary_folder.h"

namespace gripscan::app {
namespace {

const Box kArea{{-0.1, -0.05, 0.6}, {0.1, 0.08, 0.85}};
constexpr std::string_view kLine = "region: {min: [-0.1, -0.05, 0.6], max: [0.1, 0.08, 0.85]}";

TEST(RegionInCellFile, TakesThePlaceOfTheOneBeforeAndLeavesCommentsAlone) {
    EXPECT_EQ(with_region("format: gripscan-cell/1\n"
                          "# measured with a rule\n"
                          "region: {min: [0, 0, 0], max: [1, 1, 1]}   # camera frame, m\n"
                          "axis_hint: [1, 0, 0]\n",
                          kArea),
              "format: gripscan-cell/1\n"
              "# measured with a rule\n" +
                  std::string(kLine) +
                  "   # camera frame, m\n"
                  "axis_hint: [1, 0, 0]\n");
}

TEST(RegionInCellFile, ReplacesOneThatTakesSeveralLines) {
    for (const std::string_view region : {"region:\n  min: [0, 0, 0]\n  max: [1, 1, 1]\n",
                                          "region: {\n  min: [0, 0, 0], max: [1, 1, 1]\n}\n"}) {
        EXPECT_EQ(
            with_region("format: gripscan-cell/1\n" + std::string(region) + "rig: r.yaml\n", kArea),
            "format: gripscan-cell/1\n" + std::string(kLine) + "\nrig: r.yaml\n");
    }
}

TEST(RegionInCellFile, IsAddedWhereThereIsNone) {
    EXPECT_EQ(with_region("format: gripscan-cell/1", kArea),
              "format: gripscan-cell/1\n" + std::string(kLine) + "\n");
}

TEST(RegionInCellFile, IsKeptToATenthOfAMillimetre) {
    Box dragged = kArea;
    dragged.max_m.x() = 0.123456789;
    EXPECT_THAT(with_region("", dragged), testing::HasSubstr("max: [0.1235, 0.08, 0.85]"));
}

TEST(RegionInCellFile, AFileThatWouldNotReadAnyMoreStaysAsItIs) {
    const test::TemporaryFolder folder;
    const auto file = folder / "cell.yaml";
    const std::string good = "format: gripscan-cell/1\nregion: {min: [0, 0, 0], max: [1, 1, 1]}\n";
    test::write_text(file, good);
    ASSERT_TRUE(keep_region(file, kArea));
    const auto kept = load_cell_file(file);
    ASSERT_TRUE(kept) << kept.error().message;
    EXPECT_TRUE(kept->region->max_m.isApprox(kArea.max_m));
    test::write_text(file, good);
    EXPECT_FALSE(keep_region(file, Box{{0, 0, 1}, {1, 1, 1}})) << "an area without depth";
    EXPECT_EQ(read_whole_file(file).value(), good);
    EXPECT_FALSE(keep_region(folder / "none.yaml", kArea));
}

}  // namespace
}  // namespace gripscan::app
