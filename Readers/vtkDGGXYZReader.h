// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGXYZReader
 * @brief   read point clouds in text files (XYZ)
 *
 * <b>Input and output</b>. Each line begins with the coordinates of a point; further words are
 * skipped. Blanks, commas and semicolons separate words; # and // start comments. The first line
 * may be the number of points or a header without any number, such as `x y z`. Finite points have
 * a vert.
 *
 * <b>Errors</b>. As the format has no counts, a file that ends at a line end cannot be recognized
 * as truncated. A last line without a line end causes a warning.
 *
 * @sa vtkDGGMeshReader for output and errors, vtkDGGMeshWriter
 */
#ifndef vtkDGGXYZReader_h
#define vtkDGGXYZReader_h

#include "vtkDGGMeshReader.h"
#include "vtkDGGReadersModule.h" // for the export macro

class VTKDGGREADERS_EXPORT vtkDGGXYZReader : public vtkDGGMeshReader
{
public:
  static vtkDGGXYZReader* New();
  vtkTypeMacro(vtkDGGXYZReader, vtkDGGMeshReader);

  /**
   * Returns 1 if the beginning of the file has this format, otherwise 0.
   */
  static int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkDGGXYZReader();
  ~vtkDGGXYZReader() override = default;

private:
  vtkDGGXYZReader(const vtkDGGXYZReader&) = delete;
  void operator=(const vtkDGGXYZReader&) = delete;
};

#endif
