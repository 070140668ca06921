// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPCDWriter
 * @brief   write point clouds in PCL's format (PCD)
 *
 * <b>Input and output</b>. Writes the points and the point arrays of numbers as a file of version
 * 0.7, whatever the extension of the file name. Verts and polygons are skipped, lines are an error.
 *  - `x`, `y`, `z` are float if the points are, otherwise double.
 *  - Active normals become `normal_x`, `normal_y`, `normal_z`.
 *  - Arrays `RGB` and `RGBA`, or active scalars, of three or four unsigned chars become `rgb` (with
 *    a fourth byte of 255) and `rgba`.
 *  - Each other array becomes a field of its name. Blanks and control characters in names become
 *    `_`; a name that is taken, `_` or empty gets one more `_`.
 *  - Width, height and viewpoint are those of the field data, see vtkPCDReader, if they fit.
 *
 * vtkPCDReader reads the same numbers back, from text too; NaN and infinity are `nan` and `inf`.
 *
 * <b>Errors</b>. Those of vtkDGGMeshWriter, more than 10000 fields, and more than 4 GB of
 * compressed data.
 *
 * @code
 * vtkNew<vtkPCDWriter> writer;
 * writer->SetInputData(cloud);
 * writer->SetFileName("cloud.pcd");
 * writer->SetDataModeToBinaryCompressed();
 * bool isWritten = writer->Write() == 1;
 * @endcode
 *
 * <b>Source</b>. The format is that of the Point Cloud Library (pcl.readthedocs.io).
 *
 * @sa vtkPCDReader vtkDGGPointCloudConversions.h
 */
#ifndef vtkPCDWriter_h
#define vtkPCDWriter_h

#include "vtkDGGMeshWriter.h"
#include "vtkDGGReadersModule.h" // for the export macro

class VTKDGGREADERS_EXPORT vtkPCDWriter : public vtkDGGMeshWriter
{
public:
  static vtkPCDWriter* New();
  vtkTypeMacro(vtkPCDWriter, vtkDGGMeshWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Encoding of the points
   */
  enum DataModes
  {
    ASCII = 0,            ///< as text
    BINARY = 1,           ///< as in memory
    BINARY_COMPRESSED = 2 ///< compressed by LZF
  };

  ///@{
  /**
   * Encoding of the points. The default is BINARY.
   */
  vtkSetClampMacro(DataMode, int, ASCII, BINARY_COMPRESSED);
  vtkGetMacro(DataMode, int);
  void SetDataModeToASCII() { this->SetDataMode(ASCII); }
  void SetDataModeToBinary() { this->SetDataMode(BINARY); }
  void SetDataModeToBinaryCompressed() { this->SetDataMode(BINARY_COMPRESSED); }
  ///@}

protected:
  vtkPCDWriter() = default;
  ~vtkPCDWriter() override = default;

  int FindFormat() const override;

private:
  vtkPCDWriter(const vtkPCDWriter&) = delete;
  void operator=(const vtkPCDWriter&) = delete;

  int DataMode = BINARY;
};

#endif
