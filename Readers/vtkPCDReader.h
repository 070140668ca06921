// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPCDReader
 * @brief   read point clouds in PCL's format (PCD)
 *
 * <b>Input and output</b>. Text, binary and compressed files with any fields, up to version 0.7.
 * The output has the points of the file in their order, with a vert for each finite point.
 *  - `x`, `y`, `z` become the points: float if all three are, otherwise double.
 *  - `normal_x`, `normal_y`, `normal_z` become the active normals `Normals`.
 *  - `rgb` or `rgba` (four bytes) become the active scalars `RGB` or `RGBA` (unsigned char). The
 *    fourth byte of `rgb` is skipped.
 *  - Each other field, except padding (`_`), becomes an array of its name, type and number of
 *    components.
 *
 * The field data contain `PCD.Dimensions` (int64: width, height) and `PCD.Viewpoint` (double:
 * translation x, y, z and quaternion w, x, y, z of the sensor). DATA ends the header, whose lines
 * may come in any order; VERSION, COUNT, HEIGHT, VIEWPOINT, one of WIDTH and POINTS, and SIZE
 * together with TYPE may be missing. In text each point has a line of its own; binary data may be
 * followed by zeros. Files of PCL are read as PCL reads them, without PCL.
 *
 * <b>Errors</b>. More than 10000 fields and data after the last point are errors.
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
 * @sa vtkDGGMeshReader for output and errors, vtkPCDWriter, vtkDGGPointCloudConversions.h
 */
#ifndef vtkPCDReader_h
#define vtkPCDReader_h

#include "vtkDGGMeshReader.h"
#include "vtkDGGReadersModule.h" // for the export macro

class VTKDGGREADERS_EXPORT vtkPCDReader : public vtkDGGMeshReader
{
public:
  static vtkPCDReader* New();
  vtkTypeMacro(vtkPCDReader, vtkDGGMeshReader);

  /**
   * Returns 1 if the beginning of the file has this format, otherwise 0.
   */
  static int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkPCDReader();
  ~vtkPCDReader() override = default;

private:
  vtkPCDReader(const vtkPCDReader&) = delete;
  void operator=(const vtkPCDReader&) = delete;
};

#endif
