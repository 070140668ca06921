// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicDistanceMatrix
 * @brief   distances along a surface between two sets of points
 *
 * Computes the distance of every point of one set from every point of another one, or of all pairs
 * of a single set, by searches in a discrete geodesic graph. The graph is taken from the input, or
 * built and kept, as in vtkDGGDistance.
 *
 * Input port 0 takes the surface. The rows are points of the surface given by id (SetRowIds()) and
 * the points of a vtkPolyData on port 1, which may lie anywhere on the surface and are projected to
 * it; ids come first. The columns are given in the same way by SetColumnIds() and port 2. Without
 * columns they are the rows: then the matrix is symmetric, bit by bit, with zeros on the diagonal.
 *
 * The result is GetMatrix(), a single array: tuple i, component j is the distance (double, in units
 * of the coordinates) between point i of the rows and point j of the columns. Pairs in different
 * components get UnreachedValue. The output is the same as a vtkTable for the pipeline, whose
 * columns are named "0", "1" and so on (GenerateTable). An id of a point that no polygon uses is a
 * warning: it is connected to nothing but itself.
 *
 * <b>What is promised.</b> Every distance is at least the exact one and at most (1 + accuracy)
 * times that, up to rounding (1e-6), where accuracy is that of the graph, unless its rule has no
 * guarantee. Distances between points of the mesh are those of the graph: a metric, symmetric and
 * with the triangle inequality, which corrected distances are not. That is why there is no
 * correction here.
 *
 * <b>Point clouds.</b> On a cloud with the graph of vtkPointCloudDGG, distances are those in that
 * graph; Accuracy and AcceptCoarserGraph do nothing.
 *
 * <b>Time and memory.</b> There is one search over the whole surface for each point of the smaller
 * set, on all threads of vtkSMPTools; points close together are searched together, eight at a time.
 * Beside the matrix, and the table, which is as large, about 120 bytes are needed for each point of
 * the mesh and each thread.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm:
 *  - no rows; an id out of range; a point that is not finite, or farther from the surface than
 *    ProjectionTolerance; a negative ProjectionTolerance;
 *  - an Accuracy outside [1e-6, 0.5]; a graph or a matrix that would take more memory than
 *    MemoryLimit.
 *
 * @code
 * vtkNew<vtkPLYReader> reader;
 * reader->SetFileName("mesh.ply");
 * vtkNew<vtkGeodesicDistanceMatrix> matrix;
 * matrix->SetInputConnection(reader->GetOutputPort());
 * matrix->SetAccuracy(0.01);
 * matrix->SetRowIds({ 0, 10, 20 });
 * matrix->GenerateTableOff(); // the matrix is enough
 * matrix->Update();
 * std::cout << matrix->GetMatrix()->GetComponent(0, 2) << "\n"; // from 0 to 20
 * @endcode
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
 *
 * @sa vtkDiscreteGeodesicGraph vtkDGGDistance
 */

#ifndef vtkGeodesicDistanceMatrix_h
#define vtkGeodesicDistanceMatrix_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkDGGPropertyMacros.h"        // For the properties of the graph
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the internals
#include <vector> // For ids

class vtkDoubleArray;
class vtkTable;
struct vtkDGGSourceSet;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicDistanceMatrix : public vtkGeodesicAlgorithm
{
public:
  static vtkGeodesicDistanceMatrix* New();
  vtkTypeMacro(vtkGeodesicDistanceMatrix, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Points by id of the input. Ids are copied; none by default. The same id may occur more than
   * once. A null list removes all ids.
   */
  vtkDGGSetIdsMacro(Row);
  vtkDGGSetIdsMacro(Column);
  ///@}

  ///@{
  /**
   * Points anywhere on the surface: those of a vtkPolyData on input port 1 (rows) or 2 (columns);
   * its cells are not used. Null removes them.
   */
  void SetRowConnection(vtkAlgorithmOutput* output);
  void SetRowData(vtkPolyData* points);
  void SetColumnConnection(vtkAlgorithmOutput* output);
  void SetColumnData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * How far from the surface a point of port 1 or 2 may be, as a fraction of the diagonal of the
   * surface's bounding box. A point farther away is an error that names it. Default 0.01; not
   * negative; 0 takes points of the surface alone, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * Distance of pairs that are not connected. Default NaN.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  ///@{
  /**
   * Whether to fill the output, a copy of the matrix with an array for each column. A table of more
   * than 10,000 columns is refused with a warning and stays empty; the matrix is there all the
   * same. Default on. Turn it off when GetMatrix() is all that is wanted.
   */
  vtkSetMacro(GenerateTable, bool);
  vtkGetMacro(GenerateTable, bool);
  vtkBooleanMacro(GenerateTable, bool);
  ///@}

  ///@{
  /**
   * The output: one column for each point of the second set. These hide functions of the same name
   * in vtkPolyDataAlgorithm, which return null for this filter, whose output is a vtkTable.
   */
  vtkTable* GetOutput();
  vtkTable* GetOutput(int port);
  ///@}

  /**
   * The result of the last update as a single array, with a tuple for each row and a component for
   * each column: what was computed, not a copy. Without tuples when there is no result. It stays
   * with the filter until the next update, which makes another array; keep a reference to have it
   * longer.
   */
  vtkDoubleArray* GetMatrix();

  /**
   * Let go of the matrix and the table. GetMatrix() has no tuples then, and the next update
   * computes them anew.
   */
  void ReleaseMatrix();

  ///@{
  /**
   * Properties of the graph, which all filters that search one have, and numbers of it.
   *
   * - Accuracy: largest relative error of the graph that is built when the input has none, in
   *   [1e-6, 0.5]. Default 0.01. Another value is an error of the update even when the graph on the
   *   input is used.
   * - AcceptCoarserGraph: whether a graph on the input that promises less than an Accuracy that was
   *   set is used without a warning. Default off.
   * - MemoryLimit: most bytes that building a graph, or preparing to link points that are not
   *   vertices, or the matrix together with the table may take. Default 0, which stands for 70 % of
   *   the memory that is free at that time; that for the results is taken first.
   * - Of the graph of the last update, zero when there is none: whether it is that on the input,
   *   its accuracy (0 for a SaddleVertexGraph), number of directed edges, and about the bytes with
   *   what searches and links need; they stay what they were when its arrays are changed later.
   *   Whether it keeps to its accuracy, and when this filter built one last.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkGeodesicDistanceMatrix();
  ~vtkGeodesicDistanceMatrix() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override;

private:
  vtkGeodesicDistanceMatrix(const vtkGeodesicDistanceMatrix&) = delete;
  void operator=(const vtkGeodesicDistanceMatrix&) = delete;

  vtkDGGSourceSet GetRows(vtkInformationVector** inputVector) const;
  vtkDGGSourceSet GetColumns(vtkInformationVector** inputVector) const;
  dgg::Status CheckMemory(std::size_t rows, std::size_t columns, bool withTable) const;
  bool WantsTable(std::size_t columns);

  std::vector<vtkIdType> RowIds;
  std::vector<vtkIdType> ColumnIds;
  double ProjectionTolerance;
  double UnreachedValue;
  bool GenerateTable;
  std::unique_ptr<vtkDGGGraphUser> GraphUser;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
