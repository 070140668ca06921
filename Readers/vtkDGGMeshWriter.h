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
 *    bits do not suffice. Blanks in names become `_`. Verts are skipped, lines are an error.
 *  - `.obj`: points, verts, lines, polygons, active normals, texture coordinates and colors.
 *  - `.off`: the same, and colors of cells. Lines are faces of two corners, or more, which read
 * back as polygons.
 *  - `.stl`: triangles, at least one; polygons are triangulated. Binary if float32 holds all
 *    coordinates, otherwise text.
 *  - `.xyz`: points.
 *  - `.pcd`: points and point arrays, binary; see vtkPCDWriter for other modes.
 *
 * Triangle strips become triangles without cell arrays. Everything else is skipped; arrays of
 * strings cause a warning. Colors are an array `RGB` or `RGBA`, or the active scalars, of three or
 * four unsigned chars.
 *
 * <b>Errors</b>. A missing input or file name, another extension, a file that cannot be written or
 * a full disk cause an error with the name of the file. Write() then returns 0, GetErrorCode() is
 * not zero, and no part of a file is left.
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
   * Write the file: 1 on success, 0 on failure, also when the input could not be made.
   */
  int Write() override;

  ///@{
  /**
   * The data to write.
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

  char* FileName = nullptr;
  bool IsWritten = false;
};

#endif
