#include "core/cloud/cloud_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "core/base/atomic_file.h"
#include "tests/support/comma_locale.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"
#include "tests/unit/cloud/sample_clouds.h"

namespace gripscan {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

void expect_same_points(const Cloud& read, const Cloud& written, float tolerance_m) {
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        EXPECT_LE((read.points[i] - written.points[i]).cwiseAbs().maxCoeff(), tolerance_m);
    }
}

void expect_same_fields(const Cloud& read, const Cloud& written) {
    EXPECT_EQ(read.normals, written.normals);
    EXPECT_EQ(read.intensity, written.intensity);
    EXPECT_EQ(read.seen, written.seen);
}

void write_text(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// The message of a file that must not load.
std::string message_of(const std::filesystem::path& path) {
    const auto cloud = load_cloud(path);
    if (cloud) return "loaded";
    EXPECT_EQ(cloud.error().kind, ErrorKind::kInput);
    EXPECT_THAT(cloud.error().message, HasSubstr(path.string()));
    EXPECT_THAT(cloud.error().message, testing::Not(HasSubstr("\n")));
    return cloud.error().message;
}

struct Format {
    friend void PrintTo(const Format& format, std::ostream* out) { *out << format.name; }
    std::string name;
    std::string file;
    PcdEncoding encoding;
    bool grid;
    bool viewpoint;
};

class RoundTrip : public testing::TestWithParam<Format> {};

TEST_P(RoundTrip, KeepsEveryFieldExactly) {
    const Format& format = GetParam();
    const TemporaryFolder folder;
    for (unsigned fields = 0; fields < test::kFieldSets; ++fields) {
        SCOPED_TRACE(test::name_of_fields(fields));
        const Cloud cloud = test::random_cloud(fields + 1, 100, fields);
        const auto path = folder / format.file;
        const Status saved = save_cloud(path, cloud, {.encoding = format.encoding});
        ASSERT_TRUE(saved) << saved.error().message;
        const auto read = load_cloud(path);
        ASSERT_TRUE(read) << read.error().message;
        expect_same_points(*read, cloud, 0.0F);
        expect_same_fields(*read, cloud);
        EXPECT_EQ(read->sigma, cloud.sigma);
        if (format.grid) {
            EXPECT_EQ(read->cell, cloud.cell);
            EXPECT_EQ(read->grid_width, cloud.grid_width);
            EXPECT_EQ(read->grid_height, cloud.grid_height);
        }
        EXPECT_EQ(read->viewpoint, format.viewpoint ? cloud.viewpoint : std::nullopt);
    }
}

TEST_P(RoundTrip, MillimetresScalePointsSigmaAndViewpoint) {
    const Format& format = GetParam();
    const TemporaryFolder folder;
    const Cloud cloud = test::random_cloud(5, 100, test::kFieldSets - 1);
    const auto path = folder / format.file;
    CloudFileOptions options{.encoding = format.encoding, .metres_per_unit = 0.001};
    ASSERT_TRUE(save_cloud(path, cloud, options));

    const auto in_mm = load_cloud(path);
    ASSERT_TRUE(in_mm) << in_mm.error().message;
    EXPECT_FLOAT_EQ(in_mm->points[0].z(), cloud.points[0].z() * 1000.0F);
    EXPECT_FLOAT_EQ(in_mm->sigma[0], cloud.sigma[0] * 1000.0F);
    EXPECT_EQ(in_mm->intensity, cloud.intensity);
    if (format.viewpoint) {
        EXPECT_FLOAT_EQ(in_mm->viewpoint->x(), cloud.viewpoint->x() * 1000.0F);
    }

    const auto read = load_cloud(path, options);
    ASSERT_TRUE(read) << read.error().message;
    // Two roundings to float at 0.9 m.
    expect_same_points(*read, cloud, 2e-7F);
    expect_same_fields(*read, cloud);
}

TEST_P(RoundTrip, AnEmptyCloudStaysEmpty) {
    const TemporaryFolder folder;
    const auto path = folder / GetParam().file;
    const Status saved = save_cloud(path, Cloud{}, {.encoding = GetParam().encoding});
    ASSERT_TRUE(saved) << saved.error().message;
    const auto read = load_cloud(path);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_TRUE(read->empty());
}

TEST_P(RoundTrip, SameCloudSameBytes) {
    const TemporaryFolder folder;
    const Cloud cloud = test::random_cloud(8, 500, test::kFieldSets - 1);
    const auto first = folder / ("a" + GetParam().file);
    const auto second = folder / ("b" + GetParam().file);
    ASSERT_TRUE(save_cloud(first, cloud, {.encoding = GetParam().encoding}));
    ASSERT_TRUE(save_cloud(second, cloud, {.encoding = GetParam().encoding}));
    EXPECT_EQ(read_whole_file(first).value(), read_whole_file(second).value());
}

INSTANTIATE_TEST_SUITE_P(
    Formats, RoundTrip,
    testing::Values(Format{"PcdAscii", "c.pcd", PcdEncoding::kAscii, true, true},
                    Format{"PcdBinary", "c.pcd", PcdEncoding::kBinary, true, true},
                    Format{"PcdCompressed", "c.PCD", PcdEncoding::kCompressed, true, true},
                    Format{"PlyAscii", "c.ply", PcdEncoding::kAscii, true, false},
                    Format{"PlyBinary", "c.ply", PcdEncoding::kBinary, true, false},
                    Format{"Xyz", "c.xyz", PcdEncoding::kAscii, false, false}),
    [](const auto& format) { return format.param.name; });

TEST(SaveCloud, RefusesWhatItCannotKeepAndLeavesTheOldFile) {
    const TemporaryFolder folder;
    const auto path = folder / "c.pcd";
    write_text(path, "old");
    Cloud cloud = test::random_cloud(1, 20, test::kNormals);
    cloud.normals[3].setConstant(std::numeric_limits<float>::quiet_NaN());
    const Status saved = save_cloud(path, cloud);
    ASSERT_FALSE(saved);
    EXPECT_THAT(saved.error().message, HasSubstr(path.string()));
    EXPECT_EQ(read_whole_file(path).value(), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);

    EXPECT_FALSE(save_cloud(folder / "c.obj", cloud));
    EXPECT_FALSE(save_cloud(folder / "no such folder" / "c.ply", Cloud{}));
    EXPECT_FALSE(save_cloud(folder / "c.ply", Cloud{}, {.metres_per_unit = 0.0}));
}

TEST(CloudFile, IsTheSameTextWhateverTheLocale) {
    const TemporaryFolder folder;
    const Cloud cloud = test::random_cloud(21, 2000, test::kFieldSets - 1);
    for (const char* name : {"c.pcd", "c.ply", "c.xyz"}) {
        ASSERT_TRUE(save_cloud(folder / name, cloud, {.encoding = PcdEncoding::kAscii}));
        const test::CommaLocale comma;
        const auto again = folder / ("again-" + std::string(name));
        ASSERT_TRUE(save_cloud(again, cloud, {.encoding = PcdEncoding::kAscii}));
        EXPECT_EQ(read_whole_file(again).value(), read_whole_file(folder / name).value());
        const auto read = load_cloud(folder / name);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->points, cloud.points);
    }
}

TEST(LoadCloud, XyzNamesTheBadLine) {
    const TemporaryFolder folder;
    const auto path = folder / "c.xyz";
    write_text(path, "// a comment\n1 2 3\n\n4 five 6\n");
    EXPECT_THAT(message_of(path), HasSubstr("line 4: 'five' is no number"));
    write_text(path, "1 2 3\n4 5\n");
    EXPECT_THAT(message_of(path), HasSubstr("line 2: 2 numbers instead of 3"));
    write_text(path, "hello\n");
    EXPECT_THAT(message_of(path), HasSubstr("line 1"));
    write_text(path, "# nothing but a comment\n");
    EXPECT_THAT(message_of(path), HasSubstr("no points"));
}

TEST(LoadCloud, StripsPointsThatAreNotFinite) {
    const TemporaryFolder folder;
    const auto xyz = folder / "c.xyz";
    write_text(xyz, "1 2 3\nnan 2 3\n4 5 inf\n-nan nan nan\n7 8 9\n1e39 0 0\n");
    const auto points = load_cloud(xyz);
    ASSERT_TRUE(points) << points.error().message;
    EXPECT_EQ(points->size(), 2U);

    const auto pcd = folder / "c.pcd";
    write_text(pcd,
               "VERSION .7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n"
               "WIDTH 2\nHEIGHT 2\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS 4\nDATA ascii\n"
               "1 2 3 4\nnan nan nan nan\n5 6 inf 8\n9 10 11 12\n");
    const auto cloud = load_cloud(pcd);
    ASSERT_TRUE(cloud) << cloud.error().message;
    EXPECT_EQ(cloud->cell, (std::vector<std::int32_t>{0, 3}));
    EXPECT_EQ(cloud->intensity, (std::vector<float>{4, 12}));
    EXPECT_EQ(cloud->grid_width, 2);
    EXPECT_EQ(*cloud->viewpoint, Eigen::Vector3f(1, 2, 3));
}

TEST(LoadCloud, HalfKnownFieldsAreUnknown) {
    const TemporaryFolder folder;
    const auto path = folder / "c.xyz";
    write_text(path,
               "# x y z normal_x normal_y normal_z intensity sigma seen\n"
               "1 2 3 0 0 2 10 0.1 3\n4 5 6 0 0 0 nan -1 2.5\n");
    const auto cloud = load_cloud(path);
    ASSERT_TRUE(cloud) << cloud.error().message;
    EXPECT_EQ(cloud->size(), 2U);
    EXPECT_TRUE(cloud->normals.empty());
    EXPECT_TRUE(cloud->intensity.empty());
    EXPECT_TRUE(cloud->sigma.empty());
    EXPECT_TRUE(cloud->seen.empty());
}

TEST(LoadCloud, OtherFilesAreNamedWithTheReason) {
    const TemporaryFolder folder;
    EXPECT_THAT(message_of(folder / "absent.pcd"), HasSubstr("No such file"));
    EXPECT_THAT(message_of(folder / "cloud.las"), HasSubstr("clouds are .pcd"));
    std::filesystem::create_directory(folder / "folder.pcd");
    EXPECT_THAT(message_of(folder / "folder.pcd"), HasSubstr("folder"));
    for (const char* name : {"e.pcd", "e.ply", "e.xyz", "e.obj", "e.stl"}) {
        write_text(folder / name, "");
        EXPECT_THAT(message_of(folder / name), HasSubstr("empty"));
        write_text(folder / name, "\x01\x02garbage\n\n\xff\xfe");
        EXPECT_NE(message_of(folder / name), "loaded");
    }
}

TEST(LoadCloud, PromisesBeyondTheFileCostNoMemory) {
    const TemporaryFolder folder;
    const std::string head =
        "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 1000000000\nHEIGHT 2\nPOINTS 2000000000\n";
    for (const char* data : {"ascii", "binary", "binary_compressed"}) {
        write_text(folder / "c.pcd", head + "DATA " + data + "\n0 0 0 ");
        EXPECT_THAT(message_of(folder / "c.pcd"), HasSubstr("cut off")) << data;
    }
    const std::string ply = "\nelement vertex 4000000000000000000\nproperty float x\nend_header\n";
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        write_text(folder / "c.ply", "ply\nformat " + std::string(format) + " 1.0" + ply);
        EXPECT_THAT(message_of(folder / "c.ply"), HasSubstr("cut off")) << format;
    }
    write_text(folder / "c.stl", std::string(80, ' ') + "\xff\xff\xff\x7f");
    EXPECT_NE(message_of(folder / "c.stl"), "loaded");
}

TEST(LoadCloud, RangeGridOfAScanner) {
    GRIPSCAN_TEST_DATA(folder, "bunny");
    const auto cloud = load_cloud(folder / "bun000.ply");
    ASSERT_TRUE(cloud) << cloud.error().message;
    EXPECT_EQ(cloud->size(), 40256U);  // element vertex of the file
    EXPECT_EQ(cloud->grid_width, 512);
    EXPECT_EQ(cloud->grid_height, 400);
    EXPECT_FALSE(cloud->viewpoint.has_value());
    for (const auto& p : cloud->points) ASSERT_TRUE(p.allFinite());
    // Neighbours in the grid are neighbours in space: the scanner's step is 0.5 mm.
    const auto index = point_of_cell(*cloud);
    std::vector<float> gaps;
    for (std::size_t i = 0; i + 1 < index.size(); ++i) {
        if (index[i] < 0 || index[i + 1] < 0) continue;
        gaps.push_back((cloud->points[static_cast<std::size_t>(index[i])] -
                        cloud->points[static_cast<std::size_t>(index[i + 1])])
                           .norm());
    }
    std::nth_element(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2),
                     gaps.end());
    EXPECT_LT(gaps[gaps.size() / 2], 0.0007F);
}

TEST(LoadCloud, RecordedFilesOfPcl) {
    GRIPSCAN_TEST_DATA(folder, "pcl");
    const auto milk = load_cloud(folder / "milk.pcd");
    ASSERT_TRUE(milk) << milk.error().message;
    EXPECT_EQ(milk->size(), 12575U);
    EXPECT_LT((centroid(*milk) - Eigen::Vector3d(0.24962, -0.09658, -0.69680)).norm(), 1e-5);
    const auto scene = load_cloud(folder / "milk_cartoon_all_small_clorox.pcd");
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->size(), 241407U);
    EXPECT_EQ(scene->grid_width, 640);
    EXPECT_EQ(scene->grid_height, 480);
    const auto bun0 = load_cloud(folder / "bun0.pcd");
    ASSERT_TRUE(bun0) << bun0.error().message;
    EXPECT_EQ(bun0->normals.size(), 397U);
}

}  // namespace
}  // namespace gripscan
