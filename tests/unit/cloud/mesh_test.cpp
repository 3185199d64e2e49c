#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "core/cloud/cloud_file.h"
#include "core/cloud/kd_tree.h"
#include "core/cloud/triangle_mesh.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace gripscan {
namespace {

constexpr double kSide_m = 0.04;

/// A cube with one corner at the origin, outward faces.
TriangleMesh cube() {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.emplace_back(kSide_m * (i & 1), kSide_m * ((i >> 1) & 1),
                                   kSide_m * ((i >> 2) & 1));
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

TEST(SampleSurface, IsEvenOverTheAreaWithOutwardNormals) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Cloud cloud = sample_surface(cube(), {.spacing_m = 0.001, .seed = seed});
        const double wanted = 6.0 * kSide_m * kSide_m / 1e-6;
        // One more where the area of the triangles adds up to a little more.
        ASSERT_NEAR(static_cast<double>(cloud.size()), wanted, 1.0);
        const Eigen::Vector3d middle = Eigen::Vector3d::Constant(kSide_m / 2.0);
        int upper = 0;
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            const Eigen::Vector3d p = cloud.points[i].cast<double>() - middle;
            EXPECT_NEAR(p.cwiseAbs().maxCoeff(), kSide_m / 2.0, 1e-8);
            EXPECT_NEAR(p.dot(cloud.normals[i].cast<double>()), kSide_m / 2.0, 1e-8);
            if (p.z() > 0.0) ++upper;
        }
        // Binomial: standard deviation of the share 0.5 of 9600 points is 0.005.
        EXPECT_NEAR(upper / wanted, 0.5, 0.02);
    }
}

TEST(SampleSurface, LimitsThePointsAndIgnoresWhatHasNoArea) {
    TriangleMesh mesh = cube();
    EXPECT_EQ(sample_surface(mesh, {.spacing_m = 1e-7, .max_points = 1234}).size(), 1234U);
    mesh.vertices.push_back(Eigen::Vector3d::Constant(std::nan("")));
    mesh.triangles.push_back({0, 1, 8});
    mesh.triangles.push_back({0, 0, 1});
    for (const auto& p : sample_surface(mesh).points) EXPECT_TRUE(p.allFinite());
    EXPECT_NEAR(static_cast<double>(sample_surface(mesh).size()), 9600.0, 1.0);
    EXPECT_TRUE(sample_surface(TriangleMesh{}).empty());
    mesh.triangles = {{0, 0, 0}};
    EXPECT_TRUE(sample_surface(mesh).empty());
}

std::string obj_text(double scale) {
    std::string text = "# a cube\n";
    for (const auto& v : cube().vertices) {
        text += fmt::format("v {} {} {}\n", v.x() * scale, v.y() * scale, v.z() * scale);
    }
    for (const auto& t : cube().triangles) {
        text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    }
    return text;
}

std::string ascii_stl() {
    const TriangleMesh mesh = cube();
    std::string text = "solid cube\n";
    for (const auto& t : mesh.triangles) {
        text += " facet normal 0 0 0\n  outer loop\n";
        for (const std::uint32_t i : t) {
            const auto& v = mesh.vertices[i];
            text += fmt::format("   vertex {} {} {}\n", v.x(), v.y(), v.z());
        }
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid cube\n";
}

void expect_cube(const Cloud& cloud) {
    EXPECT_NEAR(static_cast<double>(cloud.size()), 9600.0, 1.0);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3f p =
            cloud.points[i] - Eigen::Vector3f::Constant(static_cast<float>(kSide_m / 2.0));
        ASSERT_NEAR(p.cwiseAbs().maxCoeff(), kSide_m / 2.0, 1e-7);
        ASSERT_NEAR(p.dot(cloud.normals[i]), kSide_m / 2.0, 1e-7);
    }
}

TEST(LoadMesh, ObjAndStlBecomeClouds) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "c.obj") << obj_text(1.0);
    std::ofstream(folder / "mm.obj") << obj_text(1000.0);
    std::ofstream(folder / "c.STL") << ascii_stl();
    for (const auto& [name, unit] :
         {std::pair{"c.obj", 1.0}, std::pair{"mm.obj", 0.001}, std::pair{"c.STL", 1.0}}) {
        SCOPED_TRACE(name);
        const auto cloud = load_cloud(folder / name, {.metres_per_unit = unit});
        ASSERT_TRUE(cloud) << cloud.error().message;
        expect_cube(*cloud);
    }
}

TEST(LoadMesh, WithoutTrianglesThereIsAMessage) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "p.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const auto cloud = load_cloud(folder / "p.obj");
    ASSERT_FALSE(cloud);
    EXPECT_THAT(cloud.error().message, testing::HasSubstr("p.obj"));
}

TEST(LoadMesh, PlyWithFacesIsASurface) {
    GRIPSCAN_TEST_DATA(folder, "bunny");
    const auto surface = load_cloud(folder / "bun_zipper_res3.ply");
    const auto scan = load_cloud(folder / "bun000.ply");
    ASSERT_TRUE(surface) << surface.error().message;
    ASSERT_TRUE(scan) << scan.error().message;
    EXPECT_GT(surface->size(), 20000U);  // about 570 cm² at a point per mm²
    EXPECT_EQ(surface->normals.size(), surface->size());
    // Scan 000 lies in the model's frame but for its published shift.
    const Eigen::Vector3d shift = centroid(*scan) - centroid(*surface);
    EXPECT_LT(shift.norm(), 0.03);
    // Twelve neighbours of any sample lie within two spacings or so.
    const KdTree tree(surface->points);
    std::vector<Neighbour> found;
    for (std::size_t i = 0; i < surface->size(); i += 97) {
        tree.k_nearest(surface->points[i], 6, found);
        EXPECT_LT(std::sqrt(found.back().squared_distance_m2), 0.004F);
    }
}

}  // namespace
}  // namespace gripscan
