// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Understands OFF files, text and binary. Internal to the reader.
#ifndef vtkDGGOFFParser_h
#define vtkDGGOFFParser_h

#include "vtkDGGFileLoader.h" // for errors and progress

#include "vtkDoubleArray.h"       // for points
#include "vtkFloatArray.h"        // for normals and texture coordinates
#include "vtkNew.h"               // for the arrays
#include "vtkUnsignedCharArray.h" // for colours

#include <cstdint> // for std::uint32_t

/// A column of colours. Files give them as fractions of 1 or as integers up to 255, and only the
/// whole file says which: any number with a decimal point or exponent, or no number above 1, means
/// fractions.
struct vtkDGGOFFColors
{
  /// Colours of the records in the given order, in [0, 255].
  vtkNew<vtkUnsignedCharArray> MakeArray(const std::vector<vtkIdType>& order) const;

  std::vector<float> Values; ///< four per record; a negative red: no colour of its own
  int Components = 0;        ///< of the current record
  bool IsUsed = false;
  bool HasAlpha = false;
  bool SawFraction = false;
  bool SawAboveOne = false;
  std::size_t PlaceAboveOne = 0; ///< of the first
};

/// All functions throw vtkDGG::FileError.
class vtkDGGOFFParser
{
public:
  explicit vtkDGGOFFParser(const std::vector<char>& bytes);

  void ReadKeyword();
  /// Read all that follows the keyword.
  void ReadData(const vtkDGG::FileProgress& progress);

  bool HasTCoords = false;
  bool HasColors = false;
  bool HasNormals = false;
  vtkNew<vtkDoubleArray> Points;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkFloatArray> TCoords;
  vtkDGGOFFColors PointColors;
  std::vector<vtkIdType> FaceOffsets; ///< of each face in Connectivity, and the end
  std::vector<vtkIdType> Connectivity;
  vtkDGGOFFColors FaceColors;

private:
  struct Token
  {
    const char* First;
    const char* Last;
  };
  struct RestNumber
  {
    double Value;
    bool IsFraction;
  };

  bool ParseKeyword(const std::string& keyword, bool& isInSpace);
  void ReadCounts();
  void CheckCounts(long long vertices, long long faces);
  void ReadVertex(vtkIdType vertex);
  void ReadFace(vtkIdType face);
  void ReadFaceColor(vtkIdType face);
  void ReadEnd();
  void CheckColors(const vtkDGGOFFColors& colors) const;

  /// The next number; `what` and `record`, unless negative, say in messages which it is.
  double ReadNumber(const char* what, vtkIdType record);
  long long ReadInteger(const char* what, vtkIdType record = -1);
  std::uint32_t ReadBits(const char* what, vtkIdType record);
  /// The numbers left on this line.
  void ReadRestOfLine();
  static void BeginColor(vtkDGGOFFColors& colors);
  void AddColor(vtkDGGOFFColors& colors, const RestNumber& number) const;

  bool IsAtLineEnd() const;
  /// Move to the next token on this line; false when there is none.
  bool FindOnLine();
  /// Move to the next token on this or a later line; false at the end of the file.
  bool FindAnywhere();
  Token TakeToken();
  double ToNumber(const Token& token) const;
  long long ToInteger(const Token& token) const;

  std::size_t GetRemaining() const { return static_cast<std::size_t>(this->End - this->Cursor); }
  std::size_t GetPlace() const;
  [[noreturn]] void Fail(unsigned long code, const std::string& message) const;
  [[noreturn]] void FailAt(std::size_t place, unsigned long code, const std::string& message) const;
  [[noreturn]] void FailEnd(const char* what, vtkIdType record) const;

  const char* const Begin;
  const char* const End;
  const char* Cursor;
  bool IsBinary = false;
  std::size_t Line = 1;
  std::vector<RestNumber> Rest;
  vtkIdType NumberOfVertices = 0;
  vtkIdType NumberOfFaces = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGOFFParser.h
