// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGPLYReader
 * @brief   read surfaces and point clouds in Stanford's format (PLY)
 *
 * <b>Input and output</b>. Text and binary files of either byte order. The element `vertex` becomes
 * points, `face` cells and `tristrips` triangles; other elements and lists are skipped.
 *  - `nx`, `ny`, `nz` become `Normals`; `u`, `v` or `s`, `t` or `texture_u`, `texture_v` become
 *    `TCoords`; `red`, `green`, `blue` and `alpha` of one byte become `RGB` or `RGBA`.
 *  - Each other number of a vertex or face becomes a point or cell array of its name and type.
 *    Cell arrays are discarded if there are triangle strips.
 *  - Coordinates in text are double whatever type the header names.
 *
 * @sa vtkDGGMeshReader for output and errors, vtkDGGMeshWriter
 */
#ifndef vtkDGGPLYReader_h
#define vtkDGGPLYReader_h

#include "vtkDGGMeshReader.h"
#include "vtkDGGReadersModule.h" // for the export macro

class VTKDGGREADERS_EXPORT vtkDGGPLYReader : public vtkDGGMeshReader
{
public:
  static vtkDGGPLYReader* New();
  vtkTypeMacro(vtkDGGPLYReader, vtkDGGMeshReader);

  /**
   * Returns 1 if the beginning of the file has this format, otherwise 0.
   */
  static int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkDGGPLYReader();
  ~vtkDGGPLYReader() override = default;

private:
  vtkDGGPLYReader(const vtkDGGPLYReader&) = delete;
  void operator=(const vtkDGGPLYReader&) = delete;
};

#endif
