// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExtraMeshes.h"

#include "MeshFile.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace fs = std::filesystem;

namespace
{
std::vector<std::string> FindFiles(const std::vector<std::string>& folders)
{
  std::vector<std::string> files;
  for (const std::string& folder : folders)
  {
    const fs::path path = fs::path(DGG_EXTRA_DATA) / folder;
    if (fs::is_directory(path))
    {
      for (const fs::directory_entry& entry : fs::directory_iterator(path))
      {
        if (entry.path().extension() == ".ply")
        {
          files.push_back(entry.path().string());
        }
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}
}

std::vector<std::string> FindExtraMeshes()
{
  return FindFiles({ "", "awkward" });
}

std::vector<std::string> FindExtraClouds()
{
  return FindFiles({ "clouds" });
}

std::string NameExtraMesh(const testing::TestParamInfo<std::string>& info)
{
  std::string name = StemOf(info.param);
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}
