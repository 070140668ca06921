// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGOFFReader
 * @brief   read surfaces in the Object File Format (OFF)
 *
 * <b>Input and output</b>. Text and binary files (big endian, 32 bits) with any of the prefixes ST,
 * C and N; 4 and n (points that are not in space) are refused. The output has a point per vertex
 * (double) and a cell per face: polygons, lines (two vertices) and verts (one). Arrays, where the
 * file has them:
 *  - point data `Normals`, `TCoords` and `RGB` or `RGBA` (unsigned char);
 *  - cell data `RGB` or `RGBA`, grey for faces without a colour, in the order of cells in
 *    vtkPolyData: verts, lines, polygons. Indices into a table of colours are ignored.
 *
 * Colours are fractions of 1 if no component of the file exceeds 1, else integers up to 255. In
 * text # starts a comment, and each vertex and face begins on a line of its own; coordinates,
 * normals and the vertices of a face may go on on further lines. Counts may follow the keyword, and
 * the number of edges may be missing.
 *
 * <b>Guarantee and cost</b>. Numbers are read the same way in any locale. Counts are compared with
 * the size of the file before memory is allocated.
 *
 * <b>Errors</b>. A file that is missing, cannot be opened or is malformed, with data after the last
 * face too, is reported with its name and the line (the byte, if binary); GetErrorCode() is not
 * zero and the output is empty.
 *
 * @code
 * vtkNew<vtkDGGOFFReader> reader;
 * reader->SetFileName("mesh.off");
 * reader->Update();
 * vtkPolyData* mesh = reader->GetOutput();
 * @endcode
 *
 * <b>Source</b>. The format is that of geomview (www.geomview.org/docs/html/OFF.html).
 *
 * @sa vtkPLYReader vtkOBJReader
 */
#ifndef vtkDGGOFFReader_h
#define vtkDGGOFFReader_h

#include "vtkAbstractPolyDataReader.h"
#include "vtkDGGReadersModule.h" // for the export macro

class VTKDGGREADERS_EXPORT vtkDGGOFFReader : public vtkAbstractPolyDataReader
{
public:
  static vtkDGGOFFReader* New();
  vtkTypeMacro(vtkDGGOFFReader, vtkAbstractPolyDataReader);

  /**
   * Whether the file begins like one that this class can read: 1 if so, 0 if not.
   */
  static int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkDGGOFFReader() = default;
  ~vtkDGGOFFReader() override = default;

  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* output) override;

private:
  vtkDGGOFFReader(const vtkDGGOFFReader&) = delete;
  void operator=(const vtkDGGOFFReader&) = delete;
};

#endif
