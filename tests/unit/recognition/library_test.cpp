#include "core/recognition/library_add.h"

#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "core/base/checksum.h"
#include "core/cloud/cloud_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/recognition/part_templates.h"

namespace gripscan {
namespace {

namespace fs = std::filesystem;

class LibraryTest : public testing::Test {
  protected:
    test::TemporaryFolder folder_;
    Library library_{folder_.path() / "library", {}};

    fs::path saved(const Cloud& cloud, const std::string& name) {
        const fs::path path = folder_.path() / name;
        EXPECT_TRUE(save_cloud(path, cloud));
        return path;
    }
    Result<Added> add(const fs::path& source, const std::string& name, bool replace = false) {
        AddRequest request;
        request.source = source;
        request.name = name;
        request.replace = replace;
        request.software = "test";
        return add_to_library(library_, request, {}, for_each_in_order);
    }
    Cloud part(std::uint64_t seed) { return test::surface_of(test::asymmetric_part(seed)); }
};

TEST_F(LibraryTest, WhatIsAddedIsThereWhenOpenedAgain) {
    const auto added = add(saved(part(1), "a.pcd"), "arm");
    ASSERT_TRUE(added) << added.error().message;
    const auto again = open_library(library_.folder);
    ASSERT_TRUE(again) << again.error().message;
    ASSERT_EQ(again->entries.size(), 1U);
    const LibraryEntry& entry = again->entries.front();
    EXPECT_EQ(sidecar_text(entry), sidecar_text(added->entry));
    const auto cloud = load_entry(*again, entry);
    ASSERT_TRUE(cloud);
    EXPECT_EQ(cloud->size(), part(1).size());
}

TEST_F(LibraryTest, APcdKeepsItsBytes) {
    const fs::path path = saved(part(1), "a.pcd");
    const auto added = add(path, "arm");
    ASSERT_TRUE(added);
    EXPECT_EQ(added->entry.check, checksum_text(*read_whole_file(path)));
}

TEST_F(LibraryTest, TheSamePointsAreRefusedUnderAnotherName) {
    const fs::path path = saved(part(1), "a.pcd");
    ASSERT_TRUE(add(path, "arm"));
    const auto again = add(path, "leg");
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().message.find("'arm'"), std::string::npos) << again.error().message;
    EXPECT_EQ(open_library(library_.folder)->entries.size(), 1U);
}

TEST_F(LibraryTest, TheSameShapeElsewhereIsRefusedAndAnotherShapeIsNot) {
    ASSERT_TRUE(add(saved(part(1), "a.pcd"), "arm"));
    Pose T = Pose::Identity();
    T.linear() = rotation_from_vector({0.9, -1.1, 0.4});
    T.translation() = Eigen::Vector3d(0.3, -0.2, 0.7);
    const auto turned = add(saved(transformed(part(1), T), "b.pcd"), "leg");
    ASSERT_FALSE(turned);
    EXPECT_NE(turned.error().message.find("same shape"), std::string::npos)
        << turned.error().message;
    const auto other = add(saved(part(2), "c.pcd"), "other");
    EXPECT_TRUE(other) << other.error().message;
}

TEST_F(LibraryTest, ATakenNameMustBeReplacedOnPurpose) {
    ASSERT_TRUE(add(saved(part(1), "a.pcd"), "arm"));
    const fs::path other = saved(part(2), "b.pcd");
    ASSERT_FALSE(add(other, "arm"));
    ASSERT_TRUE(add(other, "arm", true));
    const auto again = open_library(library_.folder);
    ASSERT_EQ(again->entries.size(), 1U);
    EXPECT_EQ(load_entry(*again, again->entries.front())->size(), part(2).size());
    // The points of the one before are gone.
    int pcds = 0;
    for (const auto& file : fs::directory_iterator(library_.folder)) {
        pcds += file.path().extension() == ".pcd" ? 1 : 0;
    }
    EXPECT_EQ(pcds, 1);
}

TEST_F(LibraryTest, RemovedIsGone) {
    ASSERT_TRUE(add(saved(part(1), "a.pcd"), "arm"));
    ASSERT_TRUE(remove_entry(library_, "arm"));
    EXPECT_TRUE(fs::is_empty(library_.folder));
    EXPECT_FALSE(remove_entry(library_, "arm"));
}

TEST_F(LibraryTest, AnObjectGoesStaleWhenItsGripperChanges) {
    ASSERT_TRUE(add(saved(part(1), "a.pcd"), "gripper"));
    const fs::path object = saved(part(2), "object.pcd");
    const std::string check = library_.find("gripper")->check;
    ASSERT_TRUE(write_file_atomically(
        folder_.path() / "object.json",
        R"({"format": "gripscan-template/1", "kind": "object", "frame": "camera",
            "settings": {"step_deg": 20}, "gripper": {"file": "g", "check": ")" +
            check + R"(", "T_gripper_object": [1,0,0,0.1, 0,1,0,0, 0,0,1,0, 0,0,0,1]}})"));
    const auto added = add(object, "object");
    ASSERT_TRUE(added) << added.error().message;
    ASSERT_TRUE(added->entry.held);
    EXPECT_EQ(added->entry.held->gripper, "gripper");
    EXPECT_EQ(added->entry.kind, "object");
    EXPECT_DOUBLE_EQ(*added->entry.alpha_deg, 20.0);
    EXPECT_NEAR(added->entry.held->T_gripper_object->translation().x(), 0.1, 1e-12);
    EXPECT_EQ(lineage_of(library_, *library_.find("object")), Lineage::kCurrent);
    ASSERT_TRUE(add(saved(part(3), "b.pcd"), "gripper", true));
    EXPECT_EQ(lineage_of(library_, *library_.find("object")), Lineage::kStale);
    ASSERT_TRUE(remove_entry(library_, "gripper"));
    EXPECT_EQ(lineage_of(library_, *library_.find("object")), Lineage::kMissing);
}

TEST_F(LibraryTest, DamagedPointsAreNoticed) {
    ASSERT_TRUE(add(saved(part(1), "a.pcd"), "arm"));
    const LibraryEntry entry = library_.entries.front();
    auto bytes = *read_whole_file(library_.folder / entry.file);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    ASSERT_TRUE(write_file_atomically(library_.folder / entry.file, bytes));
    const auto cloud = load_entry(library_, entry);
    ASSERT_FALSE(cloud);
    EXPECT_NE(cloud.error().message.find(entry.file), std::string::npos);
}

TEST_F(LibraryTest, AnUnreadableSidecarIsNamed) {
    ASSERT_TRUE(add(saved(part(1), "a.pcd"), "arm"));
    for (const char* text : {"no json", "{}", R"({"format": "gripscan-library/1", "name": 3})"}) {
        ASSERT_TRUE(write_file_atomically(library_.folder / "arm.template.json", text));
        const auto opened = open_library(library_.folder);
        ASSERT_FALSE(opened) << text;
        EXPECT_NE(opened.error().message.find("arm.template.json"), std::string::npos);
    }
}

TEST_F(LibraryTest, NamesThatLeaveTheFolderAreRefused) {
    const fs::path path = saved(part(1), "a.pcd");
    for (const char* name : {"../arm", "a/b", ".hidden", "with space"}) {
        EXPECT_FALSE(add(path, name)) << name;
    }
}

}  // namespace
}  // namespace gripscan
