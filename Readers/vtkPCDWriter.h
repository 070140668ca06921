// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPCDWriter
 * @brief   write point clouds in PCL's format (PCD)
 *
 * <b>Input and output</b>. Writes the points of a vtkPolyData and its point arrays of numbers as a
 * file of version 0.7; cells are not written. The fields are `x`, `y`, `z` (float or double),
 * `normal_x`, `normal_y`, `normal_z` for active normals, `rgb` (with a fourth byte of 255) or
 * `rgba` if the active scalars, or an array `RGB` or `RGBA`, are three or four unsigned chars, and
 * each other array under its name. In names, blanks and control characters become `_`; one that is
 * taken, `_` or empty gets one more `_`. Arrays of strings are left out, with a warning. Width,
 * height and viewpoint are those of the field data, see vtkPCDReader, if they fit.
 *
 * <b>Guarantee and cost</b>. vtkPCDReader reads the same numbers back, from text too; NaN and
 * infinity are `nan` and `inf`.
 *
 * <b>Errors</b>. No input or file name, a file that cannot be written, a full disk, more than 10000
 * fields, or more than 4 GB of compressed data are reported with the name of the file; Write()
 * returns 0, GetErrorCode() is not zero, and a part of a file is removed.
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

#include "vtkDGGReadersModule.h" // for the export macro
#include "vtkWriter.h"

class vtkPolyData;

class VTKDGGREADERS_EXPORT vtkPCDWriter : public vtkWriter
{
public:
  static vtkPCDWriter* New();
  vtkTypeMacro(vtkPCDWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How the points are written.
   */
  enum DataModes
  {
    ASCII = 0,            ///< as text
    BINARY = 1,           ///< as in memory
    BINARY_COMPRESSED = 2 ///< compressed by LZF
  };

  ///@{
  /**
   * Name of the file to write. There is no default.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * How the points are written. The default is BINARY.
   */
  vtkSetClampMacro(DataMode, int, ASCII, BINARY_COMPRESSED);
  vtkGetMacro(DataMode, int);
  void SetDataModeToASCII() { this->SetDataMode(ASCII); }
  void SetDataModeToBinary() { this->SetDataMode(BINARY); }
  void SetDataModeToBinaryCompressed() { this->SetDataMode(BINARY_COMPRESSED); }
  ///@}

  /**
   * Write the file: 1 on success, 0 on failure, also when the input could not be made.
   */
  int Write() override;

  ///@{
  /**
   * The points to write.
   */
  vtkPolyData* GetInput();
  vtkPolyData* GetInput(int port);
  ///@}

protected:
  vtkPCDWriter() = default;
  ~vtkPCDWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkPCDWriter(const vtkPCDWriter&) = delete;
  void operator=(const vtkPCDWriter&) = delete;

  void CheckArrays(); // throws

  char* FileName = nullptr;
  int DataMode = BINARY;
  bool IsWritten = false;
};

#endif
