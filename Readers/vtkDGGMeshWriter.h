// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGMeshWriter
 * @brief   write surfaces and point clouds with all digits
 *
 * <b>Input and output</b>. The extension of the file name chooses the format; the case is ignored.
 * Coordinates that are read back are equal to those of the input.
 *  - `.ply`: points, polygons, all point arrays and, for polygons, all cell arrays of numbers.
 *    Binary; coordinates are float if those of the input are, otherwise double. Components of
 *    arrays become properties `name_0`, `name_1` and so on; integers of 64 bits become double if 32
 *    bits do not suffice, with a warning from 2^53 on. Blanks in names become `_`. Verts are
 *    skipped.
 *  - `.obj`: points, verts, lines, polygons, active normals, texture coordinates and colors without
 *    alpha.
 *  - `.off`: the same with alpha, and colors of cells. Each point of a vert is a face of one
 * corner, a line a face of two corners; polylines of more points are an error.
 *  - `.stl`: triangles, at least one; polygons are triangulated, verts are skipped. Binary if
 *    float32 holds all coordinates, otherwise text.
 *  - `.xyz`: points; verts and polygons are skipped.
 *  - `.pcd`: points and point arrays, binary; verts and polygons are skipped. See vtkPCDWriter for
 *    other modes.
 *
 * Lines are an error of all formats but `.obj` and `.off`. Triangle strips become triangles without
 * cell arrays; cells without points are skipped. Arrays of strings cause a warning in formats that
 * store arrays. Colors are an array `RGB` or `RGBA`, or the active scalars, of three or
 * four unsigned chars.
 *
 * <b>Errors</b>. A missing input or file name, another extension, a file that cannot be written or
 * a full disk cause an error with the name of the file. Write() then returns 0, and GetErrorCode()
 * is vtkErrorCode::NoFileNameError, UnrecognizedFileTypeError (extension), FileFormatError (data
 * that the format cannot store), CannotOpenFileError, OutOfDiskSpaceError, or UnknownError if
 * memory is exhausted or a filter upstream fails. After an abort it is zero. The file is written as
 * `<name>.part` and renamed at the end: after a failure or an abort an older file is unchanged.
 *
 * @code
 * vtkNew<vtkDGGMeshWriter> writer;
 * writer->SetInputData(mesh);
 * writer->SetFileName("mesh.ply");
 * bool isWritten = writer->Write() == 1;
 * @endcode
 *
 * @sa vtkDGGOBJReader vtkDGGOFFReader vtkDGGPLYReader vtkDGGSTLReader vtkDGGXYZReader vtkPCDWriter
 */
#ifndef vtkDGGMeshWriter_h
#define vtkDGGMeshWriter_h

#include "vtkDGGReadersModule.h" // for the export macro
#include "vtkWriter.h"

class vtkFieldData;
class vtkPolyData;

class VTKDGGREADERS_EXPORT vtkDGGMeshWriter : public vtkWriter
{
public:
  static vtkDGGMeshWriter* New();
  vtkTypeMacro(vtkDGGMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file to write. There is no default.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Writes the file. Returns 1 on success and 0 on failure, including failures upstream.
   */
  int Write() override;

  ///@{
  /**
   * Returns the input.
   */
  vtkPolyData* GetInput();
  vtkPolyData* GetInput(int port);
  ///@}

protected:
  vtkDGGMeshWriter() = default;
  ~vtkDGGMeshWriter() override;

  /**
   * Returns the format, a value of dgg::FileFormat, by the extension of the file name; -1 if it is
   * unknown.
   */
  virtual int FindFormat() const;
  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkDGGMeshWriter(const vtkDGGMeshWriter&) = delete;
  void operator=(const vtkDGGMeshWriter&) = delete;

  void WarnOfArrays(vtkFieldData* data, bool isPLY);

  char* FileName = nullptr;
  bool IsWritten = false;
};

#endif
