// PCL reads what gripscan writes and the other way round.
#include <gtest/gtest.h>
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include "core/cloud/cloud_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/cloud/sample_clouds.h"

namespace gripscan {
namespace {

using PclCloud = pcl::PointCloud<pcl::PointXYZINormal>;

void expect_equal(const PclCloud& pcl_cloud, const Cloud& cloud) {
    std::size_t next = 0;
    for (const auto& p : pcl_cloud) {
        if (!p.getVector3fMap().allFinite()) continue;
        ASSERT_LT(next, cloud.size());
        EXPECT_EQ(p.getVector3fMap(), cloud.points[next]);
        EXPECT_EQ(p.getNormalVector3fMap(), cloud.normals[next]);
        EXPECT_EQ(p.intensity, cloud.intensity[next]);
        ++next;
    }
    EXPECT_EQ(next, cloud.size());
}

constexpr unsigned kPclFields = test::kNormals | test::kIntensity;

TEST(PclAgreement, PclReadsOurPcd) {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);  // no curvature: it says so
    const test::TemporaryFolder folder;
    for (const auto encoding :
         {PcdEncoding::kAscii, PcdEncoding::kBinary, PcdEncoding::kCompressed}) {
        for (const unsigned more : {0U, unsigned{test::kGrid}, unsigned{test::kViewpoint},
                                    unsigned{test::kSigma | test::kSeen}}) {
            const Cloud cloud = test::random_cloud(more + 1, 200, kPclFields | more);
            ASSERT_TRUE(save_cloud(folder / "c.pcd", cloud, {.encoding = encoding}));
            PclCloud read;
            ASSERT_EQ(pcl::io::loadPCDFile((folder / "c.pcd").string(), read), 0);
            expect_equal(read, cloud);
            if (cloud.organised()) {
                EXPECT_EQ(read.width, static_cast<unsigned>(cloud.grid_width));
            }
            if (cloud.viewpoint) {
                EXPECT_LT((read.sensor_origin_.head<3>() - *cloud.viewpoint).norm(), 1e-6F);
            }
        }
    }
}

TEST(PclAgreement, PclReadsOurPly) {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    const test::TemporaryFolder folder;
    for (const auto encoding : {PcdEncoding::kAscii, PcdEncoding::kBinary}) {
        for (const unsigned more : {0U, unsigned{test::kGrid}}) {
            const Cloud cloud = test::random_cloud(more + 1, 200, kPclFields | more);
            ASSERT_TRUE(save_cloud(folder / "c.ply", cloud, {.encoding = encoding}));
            PclCloud read;
            ASSERT_EQ(pcl::io::loadPLYFile((folder / "c.ply").string(), read), 0);
            expect_equal(read, cloud);
        }
    }
}

TEST(PclAgreement, WeReadPclsFiles) {
    const test::TemporaryFolder folder;
    const Cloud cloud = test::random_cloud(3, 204, kPclFields | test::kGrid);
    PclCloud written(17, 12);
    for (auto& p : written) p.x = p.y = p.z = std::numeric_limits<float>::quiet_NaN();
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        auto& p = written.at(static_cast<std::size_t>(cloud.cell[i]));
        p.getVector3fMap() = cloud.points[i];
        p.getNormalVector3fMap() = cloud.normals[i];
        p.intensity = cloud.intensity[i];
    }
    written.is_dense = true;  // a lie that PCL's PLY reader tells
    written.sensor_origin_ = {0.25F, -0.5F, 1.0F, 0.0F};
    const auto path = (folder / "c.pcd").string();
    const auto check = [&] {
        const auto read = load_cloud(path);
        ASSERT_TRUE(read) << read.error().message;
        expect_equal(written, *read);
        EXPECT_EQ(read->cell, cloud.cell);
        EXPECT_EQ(*read->viewpoint, Eigen::Vector3f(0.25F, -0.5F, 1.0F));
    };
    pcl::PCDWriter writer;
    ASSERT_EQ(writer.writeBinary(path, written), 0);
    check();
    ASSERT_EQ(writer.writeBinaryCompressed(path, written), 0);
    check();
    ASSERT_EQ(writer.writeASCII(path, written, 9), 0);
    check();
}

}  // namespace
}  // namespace gripscan
