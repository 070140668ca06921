// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Text OFF files. Internal to the reader.
#ifndef vtkDGGOFFTextParser_h
#define vtkDGGOFFTextParser_h

#include "vtkDGGOFFContents.h" // for vtkDGGOFFParser

/// Also reads the keyword of binary files, which is text.
class vtkDGGOFFTextParser : public vtkDGGOFFParser
{
public:
  using vtkDGGOFFParser::vtkDGGOFFParser;

  /// Read the keyword. When BINARY follows it, `binary` is set to where the data begin.
  bool ReadKeyword(const char*& binary);

protected:
  bool ReadCounts(long long& vertices, long long& faces) override;
  bool ReadVertex(vtkIdType vertex) override;
  bool ReadFace(vtkIdType face) override;
  bool ReadEnd() override;
  std::string DescribePlace(std::size_t place) const override;
  std::size_t GetPlace() const override { return this->Line; }
  std::size_t GetLeastVertexSize() const override;
  std::size_t GetLeastFaceSize() const override { return 4; } // "1 0" and a line end

private:
  struct Token
  {
    const char* First;
    const char* Last;
  };
  bool IsAtLineEnd() const { return *this->Cursor == '\n' || this->IsLoneReturn(); }
  bool IsLoneReturn() const;
  /// Move to the next token on this line; false when there is none.
  bool FindOnLine();
  /// Move to the next token on this or a later line; false at the end of the file.
  bool FindAnywhere();
  Token TakeToken();
  bool ReadNumber(const char* what, vtkIdType record, double& value);
  bool ReadInteger(const char* what, long long& value);
  bool ToNumber(const Token& token, double& value);
  bool ToInteger(const Token& token, long long& value);
  /// The numbers left on this line.
  bool ReadRestOfLine();
  bool AddColors(vtkDGGOFFColors& colors, std::size_t count);

  std::size_t Line = 1;
  struct RestNumber
  {
    double Value;
    bool IsFraction;
  };
  std::vector<RestNumber> Rest;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGOFFTextParser.h
