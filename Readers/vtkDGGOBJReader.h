// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGOBJReader
 * @brief   read surfaces and curves in Wavefront's format (OBJ)
 *
 * <b>Input and output</b>. The points of the output are the lines `v` of the file, in their order:
 * corners that name different texture coordinates or normals do not split a point. `f` becomes a
 * polygon, `l` a polyline and `p` verts. Ids may be negative, a line may continue after a
 * backslash, and a weight or a color (fractions of 1 or of 255) may follow coordinates.
 *  - `Normals` and `TCoords` (two components) exist if every point has exactly one value in all
 *    cells that use it; otherwise they are discarded.
 *  - `RGB` exists if all points have colors.
 *  - Materials, groups and free-form curves are skipped.
 *
 * <b>Errors</b>. As the format has no counts, a file that ends at a line end cannot be recognized
 * as truncated. A last line without a line end causes a warning.
 *
 * @sa vtkDGGMeshReader for output and errors, vtkDGGMeshWriter
 */
#ifndef vtkDGGOBJReader_h
#define vtkDGGOBJReader_h

#include "vtkDGGMeshReader.h"
#include "vtkDGGReadersModule.h" // for the export macro

class VTKDGGREADERS_EXPORT vtkDGGOBJReader : public vtkDGGMeshReader
{
public:
  static vtkDGGOBJReader* New();
  vtkTypeMacro(vtkDGGOBJReader, vtkDGGMeshReader);

  /**
   * Returns 1 if the beginning of the file has this format, otherwise 0.
   */
  static int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkDGGOBJReader();
  ~vtkDGGOBJReader() override = default;

private:
  vtkDGGOBJReader(const vtkDGGOBJReader&) = delete;
  void operator=(const vtkDGGOBJReader&) = delete;
};

#endif
