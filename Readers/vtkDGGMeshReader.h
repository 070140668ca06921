// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGMeshReader
 * @brief   base class of readers that keep digits, ids and connectivity
 *
 * <b>Output</b>. Points have the order of the file. They are double, or float where the file stores
 * float32 values. Cells are polygons, lines (polylines; faces of two corners) and verts. Normals
 * become the active normals `Normals`, texture coordinates the active texture coordinates
 * `TCoords`, and colors the active scalars `RGB` or `RGBA` (unsigned char). Other values become
 * arrays of their name and type. Cell arrays have the order of cells in vtkPolyData: verts, lines,
 * polygons.
 *
 * <b>Files</b>. A file that is compressed by gzip is decompressed, whatever its name. Numbers are
 * read the same way in any locale. Counts in headers are compared with the size of the file before
 * memory is allocated.
 *
 * <b>Errors</b>. A file that is missing, cannot be opened, is truncated or malformed causes an
 * error with its name and the line (the byte in binary data). The output is then empty, and
 * GetErrorCode() returns vtkErrorCode::NoFileNameError, FileNotFoundError, CannotOpenFileError,
 * UnrecognizedFileTypeError, PrematureEndOfFileError, FileFormatError, or UnknownError if memory is
 * exhausted. A text file without a line end after its last line causes a warning, because its last
 * number may be truncated. After an abort the output is empty and GetErrorCode() is zero.
 *
 * @sa vtkDGGMeshWriter vtkDGGOBJReader vtkDGGOFFReader vtkDGGPLYReader vtkDGGSTLReader
 * vtkDGGXYZReader vtkPCDReader
 */
#ifndef vtkDGGMeshReader_h
#define vtkDGGMeshReader_h

#include "vtkAbstractPolyDataReader.h"
#include "vtkDGGReadersModule.h" // for the export macro

class VTKDGGREADERS_EXPORT vtkDGGMeshReader : public vtkAbstractPolyDataReader
{
public:
  vtkAbstractTypeMacro(vtkDGGMeshReader, vtkAbstractPolyDataReader);

protected:
  /**
   * Constructs a reader of one format, an internal number.
   */
  explicit vtkDGGMeshReader(int format);
  ~vtkDGGMeshReader() override = default;

  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* output) override;

  /**
   * Returns 1 if the beginning of the file has the format, otherwise 0.
   */
  static int CanReadFile(const char* fileName, int format);

private:
  vtkDGGMeshReader(const vtkDGGMeshReader&) = delete;
  void operator=(const vtkDGGMeshReader&) = delete;

  const int Format;
};

#endif
