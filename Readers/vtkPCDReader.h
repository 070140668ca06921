// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPCDReader
 * @brief   read point clouds in PCL's format (PCD)
 *
 * vtkPCDReader reads the PCD files of the Point Cloud Library: text, binary and compressed binary,
 * with any fields, of version 0.7 and those before it. The output has a point for each point of the
 * file, in the same order:
 * - `x`, `y`, `z` become the points, float or double as in the file (double when they are integers
 *   or of several types);
 * - `normal_x`, `normal_y`, `normal_z` become the active normals `Normals`;
 * - `rgb` or `rgba` (four bytes in a float or an integer) become the active scalars `RGB` (three
 *   unsigned chars) or `RGBA` (four). What is in the fourth byte of `rgb` is dropped;
 * - any other field becomes an array of its name, type and number of components, whatever its
 *   meaning (`intensity`, `curvature`, `fpfh`, ...). Padding, fields named `_`, is passed over.
 *
 * Points with NaN or infinite coordinates are kept. All others have a vertex each, so that they are
 * seen. Two arrays in the field data keep what vtkPolyData has no place for: `PCD.Dimensions`
 * (width and height, of clouds that are images) and `PCD.Viewpoint` (translation x, y, z and
 * quaternion w, x, y, z of the sensor). vtkPCDWriter writes them back.
 *
 * The lines of the header may come in any order, DATA the last. VERSION, COUNT, HEIGHT, VIEWPOINT
 * and one of WIDTH and POINTS may be missing, and SIZE together with TYPE. In text files each point
 * has a line of its own, and numbers are read the same way in any locale. A file has 10000 fields
 * at most. Behind binary data there may be zeros (PCL fills pages with them). More data after the
 * last point are an error, as the counts are wrong then.
 *
 * Errors: a file that does not exist, cannot be opened or is malformed in any way is reported with
 * its name and the line (the byte, in binary data), GetErrorCode() says of what kind the error is,
 * and the output is empty. Counts are compared with the size of the file before memory is
 * allocated.
 *
 * PCL itself is not needed: its reader allocates what the header promises, and its library of files
 * brings a VTK of its own. Whatever it writes is read as it reads it.
 *
 * @sa vtkPCDWriter vtkDGGPointCloudConversions.h
 */
#ifndef vtkPCDReader_h
#define vtkPCDReader_h

#include "vtkAbstractPolyDataReader.h"
#include "vtkDGGReadersModule.h" // for the export macro

class VTKDGGREADERS_EXPORT vtkPCDReader : public vtkAbstractPolyDataReader
{
public:
  static vtkPCDReader* New();
  vtkTypeMacro(vtkPCDReader, vtkAbstractPolyDataReader);

  /**
   * Whether the file begins like one that this class can read: 1 if so, 0 if not.
   */
  static int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkPCDReader() = default;
  ~vtkPCDReader() override = default;

  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* output) override;

private:
  vtkPCDReader(const vtkPCDReader&) = delete;
  void operator=(const vtkPCDReader&) = delete;
};

#endif
