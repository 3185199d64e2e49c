// Files as they arrive after a full disk, a bad stick or a hostile hand: cut off anywhere, with
// bits turned over or numbers exchanged. Loading must end with a cloud or a message, never with a
// crash, a hang or a giant request for memory (the sanitizers' build runs this too).
#include <gtest/gtest.h>

#include <fstream>

#include "core/base/atomic_file.h"
#include "core/cloud/cloud_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/cloud/sample_clouds.h"

namespace gripscan {
namespace {

using test::TemporaryFolder;

struct Sample {
    friend void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.name; }
    std::string name;
    std::string file;
    PcdEncoding encoding = PcdEncoding::kBinary;
    /// A cut-off file of this format can be told from a whole one.
    bool length_known = true;
};

const std::string kCube =
    "v 0 0 0\nv 0.01 0 0\nv 0.01 0.01 0\nv 0 0.01 0\nv 0 0 0.01\nv 0.01 0 0.01\n"
    "v 0.01 0.01 0.01\nv 0 0.01 0.01\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n"
    "f 4 1 5 8\n";

std::string binary_stl() {
    std::string bytes(80, ' ');
    const std::uint32_t facets = 20;
    bytes.append(reinterpret_cast<const char*>(&facets), 4);
    SeededRandom random(3);
    for (std::uint32_t i = 0; i < facets * 12; ++i) {
        const auto number = static_cast<float>(random.uniform(-0.02, 0.02));
        bytes.append(reinterpret_cast<const char*>(&number), 4);
        if (i % 12 == 11) bytes.append(2, '\0');
    }
    return bytes;
}

const std::string kPlyMesh =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n0.02 0 0\n0.02 0.02 0\n0 0.02 0\n4 0 1 2 3\n3 0 1 2\n";

std::string bytes_of(const Sample& sample, const TemporaryFolder& folder) {
    if (sample.file.ends_with(".obj")) return kCube;
    if (sample.file.ends_with(".stl")) return binary_stl();
    if (sample.name == "PlyMesh") return kPlyMesh;
    const unsigned fields = sample.file.ends_with(".xyz") ? 15 : test::kFieldSets - 1;
    EXPECT_TRUE(save_cloud(folder / sample.file, test::random_cloud(42, 60, fields),
                           {.encoding = sample.encoding}));
    return read_whole_file(folder / sample.file).value();
}

Result<Cloud> load_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::filesystem::remove(path);  // overwriting makes the file system wait for the disk
    std::ofstream(path, std::ios::binary) << bytes;
    // Damaged coordinates make huge meshes: the number of their points is limited all the same.
    auto cloud = load_cloud(path, {.mesh_max_points = 1000});
    if (cloud) {
        for (const auto& p : cloud->points) EXPECT_TRUE(p.allFinite());
        for (const auto& n : cloud->normals) EXPECT_NEAR(n.norm(), 1.0F, 1e-4F);
        EXPECT_LE(cloud->size(), std::max<std::size_t>(bytes.size(), 1000));
    } else {
        EXPECT_FALSE(cloud.error().message.empty());
    }
    return cloud;
}

class BrokenFile : public testing::TestWithParam<Sample> {};

TEST_P(BrokenFile, WholeItLoads) {
    const TemporaryFolder folder;
    const auto cloud = load_bytes(folder / GetParam().file, bytes_of(GetParam(), folder));
    ASSERT_TRUE(cloud) << cloud.error().message;
    EXPECT_GT(cloud->size(), 10U);
}

TEST_P(BrokenFile, CutOffAnywhere) {
    const TemporaryFolder folder;
    const std::string bytes = bytes_of(GetParam(), folder);
    const std::size_t step = std::max<std::size_t>(bytes.size() / 200, 1);
    // A text whose last number lost digits still reads; one that lost more does not.
    const std::size_t last_number = 12;
    for (std::size_t length = 0; length < bytes.size(); length += step) {
        const auto cloud = load_bytes(folder / GetParam().file, bytes.substr(0, length));
        if (GetParam().length_known && length + last_number < bytes.size()) {
            EXPECT_FALSE(cloud) << "cut off at " << length << " of " << bytes.size();
        }
    }
}

TEST_P(BrokenFile, BitsTurnedOver) {
    const TemporaryFolder folder;
    const std::string bytes = bytes_of(GetParam(), folder);
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SeededRandom random(seed);
        std::string damaged = bytes;
        const std::size_t flips = 1 + random.next() % 4;
        for (std::size_t i = 0; i < flips; ++i) {
            // Half of them in the head, where they do most harm.
            const std::size_t reach = random.uniform() < 0.5 ? 300 : damaged.size();
            char& c = damaged[random.next() % std::min(reach, damaged.size())];
            c = static_cast<char>(c ^ (1 << random.next() % 8));
        }
        (void)load_bytes(folder / GetParam().file, damaged);
    }
}

TEST_P(BrokenFile, NumbersExchanged) {
    const TemporaryFolder folder;
    const std::string bytes = bytes_of(GetParam(), folder);
    const char* const numbers[] = {
        "0",          "-1",  "99999999999999999999", "4294967295", "1e308",
        "2147483648", "nan", "18446744073709551615", "",           "x"};
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SeededRandom random(seed);
        std::string damaged = bytes;
        const std::size_t at = damaged.find_first_of(
            "0123456789", random.next() % std::min<std::size_t>(damaged.size(), 400));
        if (at == std::string::npos) continue;
        const std::size_t end = damaged.find_first_not_of("0123456789", at);
        damaged.replace(at, std::min(end, damaged.size()) - at, numbers[random.next() % 10]);
        (void)load_bytes(folder / GetParam().file, damaged);
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, BrokenFile,
                         testing::Values(Sample{"PcdAscii", "c.pcd", PcdEncoding::kAscii},
                                         Sample{"PcdBinary", "c.pcd", PcdEncoding::kBinary},
                                         Sample{"PcdCompressed", "c.pcd", PcdEncoding::kCompressed},
                                         Sample{"PlyAscii", "c.ply", PcdEncoding::kAscii},
                                         Sample{"PlyBinary", "c.ply", PcdEncoding::kBinary},
                                         Sample{"PlyMesh", "m.ply"},
                                         Sample{"Xyz", "c.xyz", PcdEncoding::kAscii, false},
                                         Sample{"Obj", "m.obj", PcdEncoding::kAscii, false},
                                         Sample{"Stl", "m.stl"}),
                         [](const auto& sample) { return sample.param.name; });

}  // namespace
}  // namespace gripscan
