// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicDistanceMatrix
 * @brief   distances along a surface between two sets of points
 *
 * <b>Input and output</b>. Rows are point ids (SetRowIds()) and the points of a vtkPolyData on
 * input port 1, projected to the surface; ids come first. Columns are set by SetColumnIds() and
 * port 2; without any they equal the rows, and the matrix is symmetric. The graph is taken from the
 * input or built by this filter, see vtkGeodesicAlgorithm. GetMatrix() has a tuple per row and a
 * component per column: the distance (double, units of the coordinates), UnreachedValue if not
 * connected. Between points of the mesh distances are a metric, unless Correction is on. The output
 * is a vtkTable: the same numbers in columns "0", "1" and so on, or a sparse matrix
 * (CompressedRows). A point that no polygon uses is connected only to itself, with a warning.
 *
 * <b>Guarantee and cost</b>. exact distance <= result <= (1 + accuracy) * exact distance, up to
 * rounding (1e-6), if the rule of the graph has a guarantee. There is one search per point of the
 * smaller set, on all threads of vtkSMPTools, with about 120 bytes per point of the mesh and
 * thread. With the module DGG::FiltersParallel, all processes of Controller search.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm; no rows; an id out of range; a point that is
 * not finite or beyond ProjectionTolerance; columns with CompressedRows; a graph, matrix or
 * compressed rows beyond MemoryLimit. The module page is Filters/Geodesic/Distances.md.
 * @code
 * vtkNew<vtkGeodesicDistanceMatrix> matrix;
 * matrix->SetInputConnection(reader->GetOutputPort());
 * matrix->SetRowIds({ 0, 10, 20 });
 * matrix->GenerateTableOff(); // GetMatrix() suffices
 * matrix->Update();
 * std::cout << matrix->GetMatrix()->GetComponent(0, 2) << "\n"; // from 0 to 20
 * @endcode
 *
 * <b>Source</b>. See vtkDiscreteGeodesicGraph.
 *
 * @sa vtkDiscreteGeodesicGraph vtkDGGDistance
 */

#ifndef vtkGeodesicDistanceMatrix_h
#define vtkGeodesicDistanceMatrix_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <limits> // For UnreachedValue
#include <vector> // For ids

class vtkDoubleArray;
class vtkTable;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicDistanceMatrix : public vtkGeodesicAlgorithm
{
public:
  static vtkGeodesicDistanceMatrix* New();
  vtkTypeMacro(vtkGeodesicDistanceMatrix, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Points by id of the input. None by default; ids may repeat. A null list removes all.
   */
  vtkDGGSetIdsMacro(Row);
  vtkDGGSetIdsMacro(Column);
  ///@}

  ///@{
  /**
   * Points anywhere on the surface: the points of a vtkPolyData on input port 1 (rows) or 2
   * (columns). Null removes them.
   */
  void SetRowConnection(vtkAlgorithmOutput* output);
  void SetRowData(vtkPolyData* points);
  void SetColumnConnection(vtkAlgorithmOutput* output);
  void SetColumnData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * Largest distance of a point of port 1 or 2 from the surface, as a fraction of the diagonal of
   * the surface's bounding box; a farther point is an error. Default 0.01; not negative. 0 accepts
   * points on the surface, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * Distance at which a search stops, in units of the coordinates. Default: no limit; negative
   * values and NaN are errors.
   */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * Distance of pairs that are not connected or farther apart than MaximumDistance. Default NaN.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  ///@{
  /**
   * If on, the output is a copy of the matrix. With more than 10,000 columns the output stays
   * empty, with a warning; GetMatrix() contains the result. Default on.
   */
  vtkSetMacro(GenerateTable, bool);
  vtkGetMacro(GenerateTable, bool);
  vtkBooleanMacro(GenerateTable, bool);
  ///@}

  ///@{
  /**
   * If on, the output is a sparse matrix of the rows and all points of the input; GetMatrix() is
   * empty and columns must not be set. The table has a row for each pair within MaximumDistance,
   * including the pair of a point with itself: "Column" (int, point id; ascending in each row of
   * the matrix) and "GeodesicDistance". The field data array "RowOffsets" (64-bit integers) has one
   * tuple more than the matrix has rows: row i begins at RowOffsets[i] and ends before
   * RowOffsets[i + 1]. The cost is proportional to the number of pairs. GenerateTable has no
   * effect. Without MaximumDistance every reached point is stored. Default off.
   */
  vtkSetMacro(CompressedRows, bool);
  vtkGetMacro(CompressedRows, bool);
  vtkBooleanMacro(CompressedRows, bool);
  ///@}

  ///@{
  /**
   * If on, CompressedRows contain the corrected estimates of vtkDGGDistance. These are closer to
   * the exact distances, but neither symmetric nor a metric. Not used otherwise, nor for clouds.
   * Default off.
   */
  vtkSetMacro(Correction, bool);
  vtkGetMacro(Correction, bool);
  vtkBooleanMacro(Correction, bool);
  ///@}

  ///@{
  /**
   * Return the output. These hide functions of vtkPolyDataAlgorithm, which return null for this
   * filter.
   */
  vtkTable* GetOutput();
  vtkTable* GetOutput(int port);
  ///@}

  /**
   * Returns the result of the last update, not a copy; without tuples if there is none. The next
   * update creates another array.
   */
  vtkDoubleArray* GetMatrix();

  /**
   * Releases matrix and table; the next update computes them again.
   */
  void ReleaseMatrix();

  ///@{
  /**
   * Properties of the graph, see vtkDGGDistance: Accuracy of a graph that is built (default 0.01;
   * outside [1e-6, 0.5] an error), AcceptCoarserGraph (default off), and values of the graph of the
   * last update.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkGeodesicDistanceMatrix();
  ~vtkGeodesicDistanceMatrix() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;

private:
  vtkGeodesicDistanceMatrix(const vtkGeodesicDistanceMatrix&) = delete;
  void operator=(const vtkGeodesicDistanceMatrix&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  std::vector<vtkIdType> RowIds;
  std::vector<vtkIdType> ColumnIds;
  double ProjectionTolerance = 0.01;
  double MaximumDistance = VTK_DOUBLE_MAX;
  double UnreachedValue = std::numeric_limits<double>::quiet_NaN();
  bool GenerateTable = true;
  bool CompressedRows = false;
  bool Correction = false;
};

#endif
