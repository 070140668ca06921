// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What an OFF file holds, as flat arrays, and what can be wrong with it. Internal to the reader.
#ifndef vtkDGGOFFContents_h
#define vtkDGGOFFContents_h

#include "vtkDGGFileLoader.h" // for the error and the progress callback
#include "vtkType.h"          // for vtkIdType

#include <cstddef> // for std::size_t
#include <string>  // for messages
#include <vector>  // for the arrays

using vtkDGGOFFError = vtkDGGFileError;

/// The keyword in the first line: [ST][C][N][4][n]OFF [BINARY].
struct vtkDGGOFFHeader
{
  bool HasTCoords = false;
  bool HasColors = false;
  bool HasNormals = false;
  bool IsHomogeneous = false;  ///< 4OFF: four coordinates
  bool IsAnyDimension = false; ///< nOFF: any number of coordinates

  /// Understand the keyword; false when it is none. The letters may come in any order.
  bool ParseKeyword(const std::string& keyword);
};

/// A column of colours. Files give them as fractions of 1 or as integers up to 255, and only the
/// whole file tells which: any number with a decimal point or exponent, or no number above 1, means
/// fractions.
class vtkDGGOFFColors
{
public:
  /// Begin the colour of the next record; without Add() it is the default, grey.
  void BeginRecord();
  /// Add a component to the current record. False when it is out of range in any case.
  bool Add(double value, bool isFraction, std::size_t place);
  /// All records are there. False when fractions and numbers above 1 are mixed; `place` then says
  /// where the latter are.
  bool Finish(std::size_t& place);

  bool IsUsed() const { return this->Used; }
  int GetNumberOfComponents() const { return this->HasAlpha ? 4 : 3; }
  /// Component c of record i, in [0, 255].
  unsigned char Get(std::size_t i, int c) const;

private:
  std::vector<float> Values; // 4 per record
  int Components = 0;        // of the current record
  bool Used = false;
  bool HasAlpha = false;
  bool SawFraction = false;
  bool SawAboveOne = false;
  std::size_t PlaceAboveOne = 0;
  float Scale = 1.0f;
};

struct vtkDGGOFFContents
{
  vtkDGGOFFHeader Header;
  std::vector<double> Points;          // 3 per vertex
  std::vector<float> Normals;          // 3 per vertex, or empty
  std::vector<float> TCoords;          // 2 per vertex, or empty
  vtkDGGOFFColors PointColors;         // per vertex, when the header says so
  std::vector<vtkIdType> FaceOffsets;  // of each face in Connectivity, and the end
  std::vector<vtkIdType> Connectivity; // vertices of the faces
  vtkDGGOFFColors FaceColors;          // per face, when any has one
};

using vtkDGGOFFProgress = vtkDGGFileProgress;

/// The common part of reading text and binary files: counts, records, progress.
class vtkDGGOFFParser
{
public:
  vtkDGGOFFParser(const char* begin, const char* end, const vtkDGGOFFProgress& progress,
    vtkDGGOFFContents& contents);
  virtual ~vtkDGGOFFParser() = default;
  vtkDGGOFFParser(const vtkDGGOFFParser&) = delete;
  vtkDGGOFFParser& operator=(const vtkDGGOFFParser&) = delete;

  /// Read everything after the keyword. False on error (see GetError()) and when stopped (no error
  /// then).
  bool Parse();
  const vtkDGGOFFError& GetError() const { return this->Error; }

protected:
  virtual bool ReadCounts(long long& vertices, long long& faces) = 0;
  virtual bool ReadVertex(vtkIdType vertex) = 0;
  virtual bool ReadFace(vtkIdType face) = 0;
  virtual bool ReadEnd() = 0;
  /// "line 12" or "byte 345".
  virtual std::string DescribePlace(std::size_t place) const = 0;
  /// The current place.
  virtual std::size_t GetPlace() const = 0;
  /// Fewest bytes that a vertex or a face takes.
  virtual std::size_t GetLeastVertexSize() const = 0;
  virtual std::size_t GetLeastFaceSize() const = 0;

  std::size_t GetRemaining() const { return static_cast<std::size_t>(this->End - this->Cursor); }
  /// Whether a face may have that many corners, and start it.
  bool BeginFace(vtkIdType face, long long corners, std::size_t leastCornerSize);
  bool AddCorner(vtkIdType face, long long vertex);
  bool AddColor(vtkDGGOFFColors& colors, double value, bool isFraction);

  /// Record an error at a place (default: the current one) and return false.
  bool Fail(unsigned long code, const std::string& message);
  bool FailAt(std::size_t place, unsigned long code, const std::string& message);
  bool FailEnd(const std::string& what);

  const char* const Begin;
  const char* const End;
  const char* Cursor;
  vtkDGGOFFContents& Contents;
  vtkIdType NumberOfVertices = 0;
  vtkIdType NumberOfFaces = 0;

private:
  bool CheckCounts(long long vertices, long long faces);
  bool ReportProgress(vtkIdType record);

  const vtkDGGOFFProgress& Progress;
  vtkDGGOFFError Error;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGOFFContents.h
