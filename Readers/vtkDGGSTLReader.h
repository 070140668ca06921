// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGSTLReader
 * @brief   read triangles in the format of stereolithography (STL)
 *
 * <b>Input and output</b>. Text and binary files. Corners with equal coordinates become one point;
 * the ids of points have the order of first appearance. Cell i is triangle i of the file. Normals,
 * names of solids and the two attribute bytes are skipped.
 *
 * <b>Errors</b>. A binary file of n triangles must have exactly 84 + 50 n bytes. Each solid of a
 * text must end with endsolid.
 *
 * @sa vtkDGGMeshReader for output and errors, vtkDGGMeshWriter
 */
#ifndef vtkDGGSTLReader_h
#define vtkDGGSTLReader_h

#include "vtkDGGMeshReader.h"
#include "vtkDGGReadersModule.h" // for the export macro

class VTKDGGREADERS_EXPORT vtkDGGSTLReader : public vtkDGGMeshReader
{
public:
  static vtkDGGSTLReader* New();
  vtkTypeMacro(vtkDGGSTLReader, vtkDGGMeshReader);

  /**
   * Returns 1 if the beginning of the file has this format, otherwise 0.
   */
  static int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkDGGSTLReader();
  ~vtkDGGSTLReader() override = default;

private:
  vtkDGGSTLReader(const vtkDGGSTLReader&) = delete;
  void operator=(const vtkDGGSTLReader&) = delete;
};

#endif
