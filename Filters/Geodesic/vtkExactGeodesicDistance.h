// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExactGeodesicDistance
 * @brief   exact distances along a triangulated surface
 *
 * <b>Input and output</b>. Same as for vtkGeodesicDistanceAlgorithm, with windows on request.
 *
 * <b>Guarantee and cost</b>. Distances on the polyhedron that the triangles form, exact up to
 * rounding (relative errors around 1e-12). Windows of straight paths are propagated over the
 * triangles by one thread; time grows slightly faster than linearly with the number of points.
 * Windows take up to 5 KB per point during the update.
 *
 * <b>Errors</b>. All errors of vtkGeodesicDistanceAlgorithm; windows beyond MemoryLimit. The module
 * page is Filters/Geodesic/Distances.md.
 * @code
 * vtkNew<vtkExactGeodesicDistance> distance;
 * distance->SetInputConnection(reader->GetOutputPort());
 * distance->AddSourceId(0);
 * distance->AddSourceId(10, 0.5); // starts with 0.5
 * distance->Update();
 * vtkDataArray* d = distance->GetOutput()->GetPointData()->GetArray("GeodesicDistance");
 * @endcode
 * <b>Source</b>. J. S. B. Mitchell, D. M. Mount, C. H. Papadimitriou, "The discrete geodesic
 * problem", SIAM J. Comput. 16, 1987; J. Chen, Y. Han, "Shortest paths on a polyhedron", SoCG 1990;
 * order of propagation: Y. Qin et al., "Fast and exact discrete geodesic computation based on
 * triangle-oriented wavefront propagation", ACM Trans. Graph. 35(4), 2016.
 *
 * @sa vtkDGGDistance vtkApolloniusIsolines vtkGeodesicProbe
 */

#ifndef vtkExactGeodesicDistance_h
#define vtkExactGeodesicDistance_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicDistanceAlgorithm.h"

class VTKDGGFILTERSGEODESIC_EXPORT vtkExactGeodesicDistance : public vtkGeodesicDistanceAlgorithm
{
public:
  static vtkExactGeodesicDistance* New();
  vtkTypeMacro(vtkExactGeodesicDistance, vtkGeodesicDistanceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Algorithms of propagation. Both give the same distances.
   */
  enum EngineType
  {
    Reference = 0, ///< one window at a time; simple and slow
    Triangle = 1   ///< triangle by triangle; fast
  };

  ///@{
  /**
   * Algorithm of propagation. Default Triangle; Reference is for verification.
   */
  vtkSetClampMacro(Engine, int, Reference, Triangle);
  vtkGetMacro(Engine, int);
  void SetEngineToReference() { this->SetEngine(Reference); }
  void SetEngineToTriangle() { this->SetEngine(Triangle); }
  ///@}

  ///@{
  /**
   * If on, add the windows to the field data, from which vtkApolloniusIsolines and vtkGeodesicProbe
   * compute the exact distance at any surface point. They take 1 to 2 KB per point. Windows are
   * ignored with a warning after distances or surface have changed. Default off.
   */
  vtkSetMacro(GenerateWindows, bool);
  vtkGetMacro(GenerateWindows, bool);
  vtkBooleanMacro(GenerateWindows, bool);
  ///@}

protected:
  vtkExactGeodesicDistance();
  ~vtkExactGeodesicDistance() override = default;

private:
  vtkExactGeodesicDistance(const vtkExactGeodesicDistance&) = delete;
  void operator=(const vtkExactGeodesicDistance&) = delete;

  class vtkInternals;

  int Engine = Triangle;
  bool GenerateWindows = false;
};

#endif
