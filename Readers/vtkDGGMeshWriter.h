// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGMeshWriter
 * @brief   writes surfaces and point clouds with all digits
 *
 * <b>Input and output</b>. The extension of the file name chooses the format; the case is ignored.
 * Coordinates that are read back are equal to those of the input. The module page,
 * Readers/README.md, lists what each format stores and which cells are errors.
 *  - `.ply`: binary; points, polygons, point arrays and, for polygons, numeric cell arrays. Verts
 *    are skipped. 64-bit integers become double if 32 bits do not suffice, with a warning from 2^53
 *    on. Components of arrays become properties `name_0`, `name_1` and so on; blanks in names
 *    become `_`. Coordinates are float if those of the input are, otherwise double.
 *  - `.obj`: verts, lines, polygons; active normals, texture coordinates, colors without alpha.
 *  - `.off`: as `.obj`, with alpha and colors of cells. A point of a vert is a face of one
 *    corner, a line a face of two.
 *  - `.stl`: at least one triangle. Binary if float32 represents all coordinates, otherwise text;
 *    verts are skipped.
 *  - `.xyz`: points. `.pcd`: points and point arrays, binary; vtkPCDWriter has other modes. Verts
 *    and polygons are skipped in both. Lines are an error of all formats except `.obj` and `.off`.
 *
 * Triangle strips become triangles without cell arrays. Colors are an array `RGB` or `RGBA`, or the
 * active scalars, of three or four unsigned chars.
 *
 * <b>Errors</b>. An error names the file. Write() then returns 0, and GetErrorCode() is
 * vtkErrorCode::NoFileNameError, UnrecognizedFileTypeError (extension), FileFormatError (data that
 * the format cannot store), CannotOpenFileError, OutOfDiskSpaceError, or UnknownError if memory is
 * exhausted or a filter upstream fails. After an abort it is zero. The file is written as
 * `<name>.part` and renamed at the end: after a failure or an abort an older file is unchanged.
 * @code
 * writer->SetInputData(mesh); // a vtkDGGMeshWriter
 * writer->SetFileName("mesh.ply");
 * bool isWritten = writer->Write() == 1;
 * @endcode
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
   * Returns the format, an internal number, by the extension of the file name; -1 if it
   * is unknown.
   */
  virtual int FindFormat() const;
  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkDGGMeshWriter(const vtkDGGMeshWriter&) = delete;
  void operator=(const vtkDGGMeshWriter&) = delete;

  void WarnOfArrays(vtkFieldData* data);

  char* FileName = nullptr;
  bool IsWritten = false;
};

#endif
