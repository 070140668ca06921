// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Memory that control groups leave available, in folders that imitate theirs.
#include "dggFreeMemory.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

namespace
{
constexpr std::uint64_t Unlimited = std::numeric_limits<std::uint64_t>::max();

class ControlGroup : public ::testing::Test
{
protected:
  void SetUp() override { std::filesystem::remove_all(this->Root); }

  void Write(const std::string& file, const std::string& text) const
  {
    const std::filesystem::path path = this->Root + "/" + file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text << "\n";
  }

  void AddGroup(const std::string& path, const std::string& limit, const std::string& used) const
  {
    this->Write("mount" + path + "/memory.max", limit);
    this->Write("mount" + path + "/memory.current", used);
  }

  std::uint64_t GetFree() const
  {
    return dgg::GetFreeInControlGroup(this->Root + "/cgroup", this->Root + "/mount");
  }

  /// Folder of the test; separate, as tests may run at the same time.
  std::string Root = std::string(DGG_TEST_OUTPUT) + "/ControlGroup." +
    testing::UnitTest::GetInstance()->current_test_info()->name();
};
}

TEST_F(ControlGroup, NothingLimits)
{
  EXPECT_EQ(this->GetFree(), Unlimited);
  this->Write("cgroup", "0::/user.slice/some");
  EXPECT_EQ(this->GetFree(), Unlimited);
  this->AddGroup("/user.slice/some", "max", "100");
  EXPECT_EQ(this->GetFree(), Unlimited);
}

TEST_F(ControlGroup, TheGroupOfTheProcess)
{
  this->Write("cgroup", "0::/user.slice/some: group");
  this->AddGroup("/user.slice/some: group", "1000", "400");
  EXPECT_EQ(this->GetFree(), 600u);
  this->Write("mount/user.slice/some: group/memory.stat", "anon 5\ninactive_file 150\nslab 3");
  EXPECT_EQ(this->GetFree(), 750u);
  this->AddGroup("/user.slice/some: group", "300", "900");
  EXPECT_EQ(this->GetFree(), 0u);
}

TEST_F(ControlGroup, AGroupAroundIt)
{
  this->Write("cgroup", "0::/a/b/c");
  this->AddGroup("/a/b/c", "1000", "100");
  this->AddGroup("/a/b", "max", "300");
  this->AddGroup("/a", "900", "500");
  this->AddGroup("/other", "10", "10");
  EXPECT_EQ(this->GetFree(), 400u);
}

TEST_F(ControlGroup, InsideAContainer)
{
  // The root is the group of the container; the path is the path on the machine, or points outside
  // of the root.
  for (const char* path : { "/", "/docker/0123", "/../../system.slice" })
  {
    this->Write("cgroup", std::string("0::") + path);
    this->AddGroup("", "1000", "250");
    EXPECT_EQ(this->GetFree(), 750u) << path;
  }
  std::filesystem::remove(this->Root + "/cgroup");
  EXPECT_EQ(this->GetFree(), 750u);
}

TEST_F(ControlGroup, TheFirstVersion)
{
  this->Write("cgroup", "12:cpu,cpuacct:/x\n7:hugetlb,memory:/jobs/one\n1:name=systemd:/jobs/one");
  this->Write("mount/memory/jobs/memory.limit_in_bytes", "5000");
  this->Write("mount/memory/jobs/memory.usage_in_bytes", "4000");
  this->Write("mount/memory/jobs/memory.stat", "total_inactive_file 500");
  this->Write("mount/memory/jobs/one/memory.limit_in_bytes", "9223372036854771712");
  this->Write("mount/memory/jobs/one/memory.usage_in_bytes", "4000");
  EXPECT_EQ(this->GetFree(), 1500u);
}
