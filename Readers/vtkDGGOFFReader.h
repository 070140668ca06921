// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGOFFReader
 * @brief   read surfaces in the Object File Format (OFF)
 *
 * vtkDGGOFFReader reads the OFF files of geomview and of geometry processing at large, text and
 * binary (keyword followed by BINARY; big endian, 32 bits), with any of the prefixes ST (texture
 * coordinates), C (colours) and N (normals): OFF, COFF, NOFF, CNOFF, STOFF and so on. Each vertex
 * has, in this order, its coordinates, normal, colour and texture coordinates. The prefixes 4 and n
 * (points that are not in space) are refused.
 *
 * The output has one point per vertex (double) and one cell per face: polygons, lines (faces of two
 * vertices) and vertices (faces of one). Optional arrays:
 * - point data: normals `Normals`, texture coordinates `TCoords`, scalars `RGB` or `RGBA` (unsigned
 *   char) from colours;
 * - cell data: scalars `RGB` or `RGBA` when any face has a colour; faces without one are grey. An
 *   index into a table of colours, a single number, is passed over. Cell data follow the order of
 *   cells in vtkPolyData: vertices, lines, polygons.
 *
 * Colours are fractions of 1, or integers up to 255. A file in which no colour component exceeds 1
 * is taken to have fractions.
 *
 * In text files everything from # to the end of the line is a comment, blank lines are passed over,
 * all kinds of line ends are accepted, the counts may follow the keyword on its line, and the
 * number of edges may be missing. The coordinates and normal of a vertex and the vertices of a face
 * may be spread over lines; what follows them (colour, texture coordinates) ends their last line,
 * so that each vertex and each face begins on a line of its own. Numbers are read the same way in
 * any locale. More data after the last face are an error, as the counts are wrong then.
 *
 * Errors: a file that does not exist, cannot be opened or is malformed in any way is reported with
 * its name and the line (the byte, when binary), GetErrorCode() says of what kind the error is, and
 * the output is empty. Counts are compared with the size of the file before memory is allocated.
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
