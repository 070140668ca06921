// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Steps of an update: the private implementation of a filter. Internal.
#ifndef DGGFilterInternals_h
#define DGGFilterInternals_h

#include "DGGContext.h" // for the update

#include "dggPreparedSurface.h" // for the domain

#include "vtkDGGFiltersGeodesicModule.h" // for the export macro
#include "vtkSetGet.h"                   // for vtkNotUsed()
#include "vtkSmartPointer.h"             // for the joined input
#include "vtkTable.h"                    // for the report
#include "vtkType.h"                     // for vtkMTimeType

#include <atomic>     // for the progress
#include <functional> // for steps
#include <memory>     // for the mesh
#include <set>        // for the warnings
#include <string>     // for texts
#include <thread>     // for the thread of the update
#include <vector>     // for reached vertices

class DGGMeshAdapter;
class DGGPartedUpdate;
class DGGProcesses;
class vtkGeodesicAlgorithm;
class vtkInformation;
class vtkInformationVector;
class vtkPolyData;
namespace dgg
{
struct Output;
class ProcessGroup;
struct SurfacePiece;
}

/// Update of several processes that have one piece of the surface each.
struct DGGPieceUpdate
{
  const DGGProcesses& Processes;
  dgg::ProcessGroup& Group;
  const dgg::SurfacePiece& Piece; ///< of this process, without ghosts
  vtkInformationVector** Inputs;
  vtkInformationVector* Outputs;
};

/// The steps of an update, which each filter implements, and the work that all filters share. The
/// constructor of a filter creates its own and assigns it to vtkGeodesicAlgorithm::Internals.
class VTKDGGFILTERSGEODESIC_EXPORT DGGFilterInternals
{
public:
  explicit DGGFilterInternals(vtkGeodesicAlgorithm* filter);
  virtual ~DGGFilterInternals();
  DGGFilterInternals(const DGGFilterInternals&) = delete;
  void operator=(const DGGFilterInternals&) = delete;

  ///@{
  /// Steps of an update, in this order. Each may return an error, which is reported, or the status
  /// of an abort; each may throw.
  ///
  /// CheckProperties() is called before the mesh is prepared, Execute() after that.
  /// MakeEmptyOutput() replaces Execute() if the surface has neither points nor cells; by default
  /// it makes outputs without arrays. The context belongs to the whole update (DGGContext.h).
  virtual dgg::Status CheckProperties() const { return dgg::Status::Success(); }
  virtual dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) = 0;
  virtual void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector);
  ///@}

  ///@{
  /// Steps in place of Execute() on several processes with one piece each. CanDistribute() returns
  /// true if the properties allow them. ExecutePiece() is called on all processes; the input of the
  /// context is the piece. `isDone` becomes false on all processes if the pieces must be gathered.
  /// An error or an exception of one process ends the update of all.
  virtual bool CanDistribute() const { return false; }
  virtual dgg::Status ExecutePiece(
    const DGGContext& context, const DGGPieceUpdate& update, bool& isDone);
  ///@}

  /// Resets the results that getters return. Called before each update, so that a failed update
  /// keeps no results of an earlier update. Default: nothing to reset.
  virtual void ForgetResults() {}
  /// Returns true if output 0 is the surface with arrays added and has the pieces of the input.
  /// Default false: output 0 is new geometry, as other outputs are.
  virtual bool PassesSurface() const { return false; }
  /// Returns true if this filter treats the input as a cloud and uses its points only. Default
  /// false; filters that search a graph return true for an input with the graph of a cloud.
  virtual bool IsCloud(vtkPolyData* vtkNotUsed(input)) const { return false; }
  /// Returns advice for the error message when memory is exhausted.
  virtual std::string GetMemoryRemedy() const { return "Use a smaller mesh"; }

  /// Runs an update: gathers pieces and blocks, and runs the steps. The outputs are empty after an
  /// error, which is reported, or an abort.
  void Update(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);

  /// Checks the properties of all filters, and CheckProperties().
  dgg::Status CheckAllProperties() const;

  /// Runs a step outside of updates after bringing the input up to date. Only an error changes the
  /// error code. Returns true if the step succeeded and was not aborted.
  bool AttemptOutsideOfUpdate(const std::function<dgg::Status()>& step);

  /// Gets the input of port 0 with its pieces joined, for use outside of updates; null without
  /// input.
  dgg::Status GetWholeInput(vtkSmartPointer<vtkPolyData>& surface);

  /// Brings the mesh up to date; a null surface is an error. For use outside of updates; the mesh
  /// is up to date in Execute().
  dgg::Status PrepareMesh(vtkPolyData* surface);

  /// Returns the context of an update or a prediction for the surface that was prepared last.
  DGGContext MakeContext(vtkPolyData* surface);

  /// Returns the domain (surface or cloud) that an input is treated as.
  dgg::Domain GetDomain(vtkPolyData* surface) const;

  /// Returns the mesh that is kept between updates, which is empty before the first.
  const DGGMeshAdapter& GetMesh() const { return *this->Mesh; }

  ///@{
  /// Reports warnings, which have no final period and name properties in braces (dggStatus.h).
  /// Empty texts are ignored.
  void Warn(const std::string& text) const;
  void Warn(const std::vector<std::string>& texts) const;
  ///@}

  vtkSmartPointer<vtkTable> ReportTable; ///< holds the result of GetMeshReportTable()

  /// Warns once per mesh if most of the surface is not connected to the reached vertices although
  /// its components nearly touch. For use after a distance.
  void WarnAboutGaps(const std::vector<bool>& isReached);

  /// Reports a reason for inaccurate results once per mesh. Returns true if there is a reason.
  bool WarnAboutQuality(const std::string& reason);

  /// Reports the warnings of an output when all outputs are filled, because observers may read
  /// them.
  void WarnAtEnd(const dgg::Output& output);

  /// Fills an output that is new geometry. Its warnings are reported when all outputs are filled.
  dgg::Status FillOutput(const DGGContext& context, dgg::Output& output,
    vtkInformationVector* outputVector, int port = 0);

  /// Warns that the input lacks something.
  void WarnAboutEmptyInput(const char* lack);

private:
  dgg::Status Attempt(const std::function<dgg::Status()>& step);
  dgg::Status Try(const std::function<dgg::Status()>& step);
  dgg::Status Follow(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);
  dgg::Status Compute(vtkInformationVector** inputVector, vtkInformationVector* outputVector,
    dgg::ProcessGroup* group = nullptr);
  dgg::Status ComputePiece(const DGGProcesses& processes, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, bool& isDone);
  bool Advance(double fraction);

  vtkGeodesicAlgorithm* Filter;
  std::atomic<double> Reached;             // progress of the update so far
  std::atomic<bool> IsStopped;             // true if observers have requested a stop
  std::thread::id Caller;                  // thread of the update
  vtkMTimeType GapsBuildTime;              // build time of the mesh that was checked for gaps
  vtkMTimeType QualityTime;                // build time of the mesh of QualityReasons
  std::set<std::string> QualityReasons;    // reported for this mesh
  std::vector<std::string> OutputWarnings; // warnings of the outputs filled so far
  std::unique_ptr<DGGMeshAdapter> Mesh;
  std::unique_ptr<DGGPartedUpdate> Parts;
};

/// Private implementation of filters of one class, which extends the steps of `Base`.
template <typename Filter, typename Base = DGGFilterInternals>
class DGGInternalsOf : public Base
{
public:
  explicit DGGInternalsOf(Filter* self)
    : Base(self)
    , Self(self)
  {
  }

protected:
  Filter* const Self;
};

/// Defines the private function of a filter that returns its own private implementation.
#define vtkDGGInternalsMacro(Class)                      \
  Class::vtkInternals& Class::GetInternals() const       \
  {                                                      \
    return static_cast<vtkInternals&>(*this->Internals); \
  }

/// Defines the getter of a result, which the private implementation of the filter holds.
#define vtkDGGResultMacro(Class, Type, Name, value)       \
  Type Class::Get##Name() const                           \
  {                                                       \
    return static_cast<Type>(this->GetInternals().value); \
  }

#endif
