// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPCDWriter
 * @brief   write point clouds in PCL's format (PCD)
 *
 * vtkPCDWriter writes the points of a vtkPolyData and all of their arrays of numbers as a PCD file
 * of version 0.7. Cells are not written. What vtkPCDReader reads is written back as it was: the
 * fields are `x`, `y`, `z` (float or double as the points are, double for any other type),
 * `normal_x`, `normal_y`, `normal_z` when there are active normals, `rgb` or `rgba` when the active
 * scalars, or an array `RGB` or `RGBA`, are three or four unsigned chars, and each other array of
 * point data under its name. The fourth byte of `rgb` is 255, as PCL has it.
 *
 * Names cannot have blanks in a file: blanks and control characters become `_`, and a name that is
 * taken already, `_` or empty gets one more `_`. Arrays of strings are left out, with a warning.
 *
 * The width and height of `PCD.Dimensions` in the field data are written as long as their product
 * is the number of points, otherwise that number and 1; the viewpoint is that of `PCD.Viewpoint`,
 * or the origin.
 *
 * Text files hold the fewest digits that give the same numbers again, so no mode loses anything.
 * NaN and infinity are `nan` and `inf`. A cloud without points makes a file without points.
 * Compressed data may take no more than 4 GB, a limit of the format. A file has 10000 fields at
 * most, as vtkPCDReader refuses more.
 *
 * Errors: no input, no file name, a file that cannot be written or does not fit on the disk are
 * reported with the name of the file; Write() returns 0 and GetErrorCode() says of what kind the
 * error is. A file that is not whole is removed.
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
