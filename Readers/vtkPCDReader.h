// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPCDReader
 * @brief   read point clouds in PCL's format (PCD)
 *
 * <b>Input and output</b>. Text, binary and compressed files with any fields, up to version 0.7.
 * The output has a point for each of the file, in order, with a vert if it is finite:
 *  - `x`, `y`, `z` become the points, float or double (double when integers or of several types);
 *  - `normal_x`, `normal_y`, `normal_z` the active normals `Normals`;
 *  - `rgb` or `rgba` (four bytes) the active scalars `RGB` or `RGBA` (unsigned char), without the
 *    fourth byte of `rgb`;
 *  - any other field an array of its name, type and number of components, but padding (`_`).
 *
 * The field data get `PCD.Dimensions` (int64: width, height) and `PCD.Viewpoint` (double:
 * translation x, y, z and quaternion w, x, y, z of the sensor). DATA ends the header, whose lines
 * may come in any order; VERSION, COUNT, HEIGHT, VIEWPOINT, one of WIDTH and POINTS, and SIZE
 * together with TYPE may be missing. In text each point has a line of its own; binary data may be
 * followed by zeros.
 *
 * <b>Guarantee and cost</b>. What PCL writes is read as PCL reads it, without PCL: its library of
 * files brings a VTK of its own. Numbers are read the same way in any locale. Counts are compared
 * with the size of the file before memory is allocated.
 *
 * <b>Errors</b>. A file that is missing, cannot be opened or is malformed, with more than 10000
 * fields or data after the last point too, is reported with its name and the line (the byte, in
 * binary data); GetErrorCode() is not zero and the output is empty.
 *
 * @code
 * vtkNew<vtkPCDReader> reader;
 * reader->SetFileName("cloud.pcd");
 * reader->Update();
 * vtkDataArray* intensity = reader->GetOutput()->GetPointData()->GetArray("intensity");
 * @endcode
 *
 * <b>Source</b>. The format is that of the Point Cloud Library (pcl.readthedocs.io).
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
