// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGOFFReader
 * @brief   read surfaces in the Object File Format (OFF)
 *
 * <b>Input and output</b>. Text and binary files (big endian, 32 bits) with any of the prefixes ST,
 * C and N; 4 and n (points of other dimensions than three) are refused. Faces of two corners become
 * lines, those of one corner verts.
 *  - Point data: `Normals`, `TCoords` and `RGB` or `RGBA`.
 *  - Cell data: `RGB` or `RGBA`, gray for faces without a color. Indices into a table of colors are
 *    ignored.
 *  - Colors are fractions of 1 if no component of the file exceeds 1, otherwise integers up to 255.
 *  - In text # starts a comment, and each vertex and face begins on a line of its own; coordinates,
 *    normals and the vertices of a face may continue on further lines.
 *  - Dialects: counts may follow the keyword, with or without a blank (`OFF25 32 0`); the number of
 *    edges or the keyword may be missing; the keyword may be in lower case; colors may follow
 *    vertices without the prefix C.
 *
 * <b>Errors</b>. Data after the last face are an error.
 *
 * <b>Source</b>. The format is that of geomview (www.geomview.org/docs/html/OFF.html). VTK has an
 * OFF reader from 9.4 on.
 *
 * @sa vtkDGGMeshReader for output and errors, vtkDGGMeshWriter
 */
#ifndef vtkDGGOFFReader_h
#define vtkDGGOFFReader_h

#include "vtkDGGMeshReader.h"
#include "vtkDGGReadersModule.h" // for the export macro

class VTKDGGREADERS_EXPORT vtkDGGOFFReader : public vtkDGGMeshReader
{
public:
  static vtkDGGOFFReader* New();
  vtkTypeMacro(vtkDGGOFFReader, vtkDGGMeshReader);

  /**
   * Returns 1 if the file begins with the keyword of the format, otherwise 0. Files without a
   * keyword can be read but are not recognized.
   */
  static int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkDGGOFFReader();
  ~vtkDGGOFFReader() override = default;

private:
  vtkDGGOFFReader(const vtkDGGOFFReader&) = delete;
  void operator=(const vtkDGGOFFReader&) = delete;
};

#endif
