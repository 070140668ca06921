// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Fixture of reader tests: files in a separate folder, and checks common to all readers.
#ifndef ReaderFixture_h
#define ReaderFixture_h

#include "FilterTestTools.h"
#include "MeshDescription.h"

#include "vtkErrorCode.h"

#include <clocale>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace dggtest
{
/// A file and the expected output or error. Words of the error may be separated by '*'.
struct FileCase
{
  const char* Name;
  std::string Content;
  std::string Expected;
  unsigned long Code = vtkErrorCode::FileFormatError;
};

template <typename ReaderType>
class ReaderFixture : public testing::Test
{
protected:
  /// `good` is the content of a valid file.
  ReaderFixture(const char* name, const std::string& good)
    : Name(name)
    , Good(good)
  {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    this->Folder = std::filesystem::path(DGG_TEST_OUTPUT) / info->test_suite_name() / info->name();
    std::filesystem::create_directories(this->Folder);
  }
  ~ReaderFixture() override { std::filesystem::remove_all(this->Folder); }

  std::string GetPath(const std::string& name) const { return (this->Folder / name).string(); }
  std::string Write(const std::string& content, const std::string& name) const
  {
    // Replacing a file may wait for the disk, so the old file is removed first.
    std::filesystem::remove(this->GetPath(name));
    std::ofstream(this->GetPath(name), std::ios::binary) << content;
    return this->GetPath(name);
  }
  std::string Write(const std::string& content) const { return this->Write(content, this->Name); }
  std::string Load(const std::string& name) const
  {
    std::ifstream file(this->GetPath(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  std::string Load() const { return this->Load(this->Name); }

  void Use(const std::string& path)
  {
    this->Reader->SetFileName(path.c_str());
    this->Reader->Modified(); // the name may be unchanged
  }
  vtkPolyData* ReadWellFile(const std::string& name)
  {
    this->Use(this->GetPath(name));
    ExpectSuccess(this->Reader);
    return this->Reader->GetOutput();
  }
  vtkPolyData* ReadWellFile() { return this->ReadWellFile(this->Name); }
  vtkPolyData* ReadWell(const std::string& content)
  {
    this->Write(content);
    return this->ReadWellFile();
  }

  /// Expects an error with this code that names the file and contains all of `parts`, and an empty
  /// output. A valid file must then be read without error.
  void ExpectRefused(
    const std::string& content, unsigned long code, const std::vector<std::string>& parts)
  {
    SCOPED_TRACE(content);
    std::vector<std::string> all = parts;
    all.push_back(this->Write(content));
    this->Use(all.back());
    ExpectError(this->Reader, all);
    EXPECT_EQ(this->Reader->GetErrorCode(), code);
    EXPECT_GT(this->ReadWell(this->Good)->GetNumberOfPoints(), 0);
  }

  /// Reads all files. A defect must cause an error that names the file and the defect; the output
  /// is empty.
  template <typename Cases>
  void Check(const Cases& cases)
  {
    for (const FileCase& file : cases)
    {
      SCOPED_TRACE(file.Name + (": " + file.Content.substr(0, 300)));
      const std::string path = this->Write(file.Content);
      this->Use(path);
      Listener listener(this->Reader);
      this->Reader->Update();
      if (this->Reader->GetErrorCode() == vtkErrorCode::NoError)
      {
        EXPECT_EQ(Describe(this->Reader->GetOutput()), file.Expected);
        EXPECT_TRUE(listener.Errors.empty());
        EXPECT_TRUE(listener.Warnings.empty());
        continue;
      }
      ASSERT_EQ(listener.Errors.size(), 1u);
      const std::string& error = listener.Errors[0];
      ASSERT_FALSE(file.Expected.empty()) << error;
      std::size_t position = error.find("Cannot read " + path + ": ");
      ASSERT_NE(position, std::string::npos) << error;
      std::istringstream words(file.Expected);
      for (std::string word; std::getline(words, word, '*');)
      {
        position = error.find(word, position);
        ASSERT_NE(position, std::string::npos) << "'" << word << "' is missing in: " << error;
      }
      EXPECT_EQ(this->Reader->GetErrorCode(), file.Code);
      ExpectEmptyOutput(this->Reader);
    }
    EXPECT_GT(this->ReadWell(this->Good)->GetNumberOfPoints(), 0);
  }

  /// Expects that each truncated file causes an error, or a warning if the format has no counts.
  void CheckTruncation(const std::string& content, bool hasCounts)
  {
    for (std::size_t i = 0; i < 20; ++i)
    {
      std::size_t length = (content.size() - 2) * i / 19;
      while (!hasCounts && length > 0 && content[length - 1] == '\n')
      {
        ++length; // a missing line cannot be detected
      }
      SCOPED_TRACE(length);
      this->Use(this->Write(content.substr(0, length)));
      Listener listener(this->Reader);
      this->Reader->Update();
      EXPECT_EQ(listener.Errors.size() + (hasCounts ? 0 : listener.Warnings.size()), 1u);
      EXPECT_TRUE(listener.Errors.empty() || this->Reader->GetOutput()->GetNumberOfPoints() == 0);
    }
  }

  /// Expects that the file is read with a warning when the last digit and the line end are missing.
  /// The last number of `content` must have two digits.
  void ExpectWarningIfCut(const std::string& content)
  {
    this->Use(this->Write(content.substr(0, content.size() - 2)));
    Listener listener(this->Reader);
    this->Reader->Update();
    EXPECT_TRUE(listener.Errors.empty());
    ASSERT_EQ(listener.Warnings.size(), 1u);
    EXPECT_NE(listener.Warnings[0].find("may be truncated"), std::string::npos);
  }

  void CheckFilesThatCannotBeRead()
  {
    const auto expect = [this](const std::string& name, unsigned long code, const char* trouble) {
      this->Use(name);
      ExpectError(this->Reader, { name.empty() ? trouble : "Cannot read " + name + ": ", trouble });
      EXPECT_EQ(this->Reader->GetErrorCode(), code);
    };
    ExpectError(this->Reader, { "FileName" });
    EXPECT_EQ(this->Reader->GetErrorCode(), vtkErrorCode::NoFileNameError);
    expect("", vtkErrorCode::NoFileNameError, "Set FileName");
    expect(this->GetPath("none"), vtkErrorCode::FileNotFoundError, "does not exist");
    expect(this->Folder.string(), vtkErrorCode::CannotOpenFileError, "it is a folder");
    expect("/dev/null", vtkErrorCode::CannotOpenFileError, "not an ordinary file");
    expect(this->Write(""), vtkErrorCode::PrematureEndOfFileError, "the file is empty");
    EXPECT_GT(this->ReadWell(this->Good)->GetNumberOfPoints(), 0);
    for (const std::string& path :
      { this->Write(""), this->GetPath("none"), this->Folder.string(), std::string() })
    {
      EXPECT_EQ(ReaderType::CanReadFile(path.c_str()), 0) << path;
    }
    EXPECT_EQ(ReaderType::CanReadFile(nullptr), 0);
    EXPECT_EQ(ReaderType::CanReadFile(this->Write(this->Good).c_str()), 1);
  }

  /// Checks progress and aborts at several stages of reading a large file.
  void CheckProgress(const std::string& content, vtkIdType numberOfPoints)
  {
    this->Use(this->Write(content));
    ProgressWatch watch(this->Reader);
    ExpectSuccess(this->Reader);
    watch.ExpectGrowth(4);
    EXPECT_EQ(watch.Progress.back(), 1.0);
    for (const double stop : { 0.3, 0.9 })
    {
      this->Reader->SetAbortExecute(0);
      this->Reader->Modified();
      watch.StopAt = stop;
      ExpectSuccess(this->Reader);
      EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), 0);
    }
    watch.StopAt = 2.0;
    this->Reader->SetAbortExecute(0);
    this->Reader->Update(); // nothing has changed, but the previous update did not read the file
    EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), numberOfPoints);
  }

  /// Expects that locales do not change the result. `content` contains the point (1.5, 2.25,
  /// 1000.5).
  void CheckLocales(const std::string& content)
  {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    // If no such locale is installed, at least the standard locales must not change the result.
    for (const char* locale : { "C", "de_DE.UTF-8", "fr_FR.UTF-8", "de_DE" })
    {
      if (std::setlocale(LC_ALL, locale))
      {
        const double* p = this->ReadWell(content)->GetPoint(0);
        EXPECT_EQ(std::vector<double>(p, p + 3), (std::vector<double>{ 1.5, 2.25, 1000.5 }));
      }
    }
    std::setlocale(LC_ALL, before.c_str());
  }

  const char* Name; ///< prefix of file names
  std::string Good;
  std::filesystem::path Folder;
  vtkNew<ReaderType> Reader;
};
}

#endif
