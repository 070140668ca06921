// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FieldMethods.h"

#include "BenchmarkTools.h"
#include "PeerVTK.h"
#ifdef DGG_WITH_CGAL
#include "PeerCGAL.h"
#endif
#include "dggFastMarching.h"
#include "dggHeatMethod.h"

namespace
{
std::vector<dgg::GeodesicSource> SourcesAt(dgg::Id vertex)
{
  return { { dgg::SurfacePoint::AtVertex(vertex), 0.0 } };
}

class OurHeat : public FieldMethod
{
public:
  explicit OurHeat(const BenchmarkMesh& mesh)
    : Method(mesh.GetSurface())
  {
  }

  void Prepare() override { Require(this->Method.Prepare({}, nullptr)); }
  void Run(dgg::Id source) override
  {
    Require(this->Method.Run(SourcesAt(source), {}, this->Result));
  }
  std::vector<double> TakeDistances() override { return std::move(this->Result.Distances); }

private:
  dgg::HeatMethod Method;
  dgg::HeatResult Result;
};

class OurMarching : public FieldMethod
{
public:
  explicit OurMarching(const BenchmarkMesh& mesh)
    : Surface(mesh.GetSurface())
  {
  }

  void Prepare() override { this->Method = std::make_unique<dgg::FastMarching>(this->Surface); }
  void Run(dgg::Id source) override
  {
    Require(this->Method->Run(SourcesAt(source), {}, this->Result));
  }
  std::vector<double> TakeDistances() override { return std::move(this->Result.Distances); }

private:
  const dgg::SurfaceMesh& Surface;
  std::unique_ptr<dgg::FastMarching> Method;
  dgg::MarchingResult Result;
};

class VTKEdges : public FieldMethod
{
public:
  explicit VTKEdges(const BenchmarkMesh& mesh)
    : Peer(mesh.GetPolyData())
  {
  }

  void Run(dgg::Id source) override { this->Peer.Run(source); }
  std::vector<double> TakeDistances() override { return this->Peer.GetDistances(); }

private:
  PeerVTK Peer;
};

#ifdef DGG_WITH_CGAL
class CGALExact : public FieldMethod
{
public:
  explicit CGALExact(const BenchmarkMesh& mesh)
    : Peer(mesh.GetArrays())
  {
    Require(this->Peer.GetRefusal());
  }

  void Run(dgg::Id source) override
  {
    this->Peer.SetSourceVertex(source);
    this->Distances = this->Peer.ComputeDistances();
  }
  std::vector<double> TakeDistances() override
  {
    this->Peer.SetSourceVertex(0); // frees the tree of the run
    return std::move(this->Distances);
  }

private:
  PeerCGAL Peer;
  std::vector<double> Distances;
};
#endif

#ifdef DGG_WITH_HEAT
class CGALHeat : public FieldMethod
{
public:
  CGALHeat(const BenchmarkMesh& mesh, PeerHeat::Triangulation triangulation)
    : Peer(mesh.GetArrays(), triangulation)
  {
  }

  void Prepare() override
  {
    this->Peer.Precompute();
    Require(this->Peer.GetRefusal());
  }
  void Run(dgg::Id source) override
  {
    this->Peer.Run(source);
    Require(this->Peer.GetRefusal());
  }
  std::vector<double> TakeDistances() override { return this->Peer.GetDistances(); }

private:
  PeerHeat Peer;
};
#endif

template <typename Method>
std::unique_ptr<FieldMethod> MakeMethod(const BenchmarkMesh& mesh)
{
  return std::make_unique<Method>(mesh);
}

/// Returns the method after its preparation. Only the last one is kept.
FieldMethod& GetPrepared(
  const MeshRecipe& recipe, const BenchmarkMesh& mesh, const NamedMethod& method)
{
  static std::unique_ptr<FieldMethod> kept;
  static std::string name;
  const std::string wanted = recipe.Name + "/" + method.Name;
  if (!kept || name != wanted)
  {
    kept.reset(); // release before the next is allocated
    auto made = method.Make(mesh);
    made->Prepare();
    kept = std::move(made);
    name = wanted;
  }
  return *kept;
}
}

NamedMethod HeatOfOurs()
{
  return { "Heat", MakeMethod<OurHeat> };
}

NamedMethod MarchingOfOurs()
{
  return { "Marching", MakeMethod<OurMarching> };
}

NamedMethod EdgesOfVTK()
{
  return { "VTK", MakeMethod<VTKEdges>, false };
}

#ifdef DGG_WITH_CGAL
NamedMethod ExactOfCGAL()
{
  return { "CGAL", MakeMethod<CGALExact>, false };
}
#endif

#ifdef DGG_WITH_HEAT
NamedMethod HeatOfCGAL(PeerHeat::Triangulation triangulation)
{
  const bool isDirect = triangulation == PeerHeat::Triangulation::Direct;
  return { isDirect ? "HeatDirect" : "HeatDelaunay", [triangulation](const BenchmarkMesh& mesh) {
            return std::make_unique<CGALHeat>(mesh, triangulation);
          } };
}
#endif

void MeasurePreparation(
  benchmark::State& state, const MeshRecipe& recipe, const NamedMethod& method)
{
  const BenchmarkMesh& mesh = OpenMesh(recipe);
  std::unique_ptr<FieldMethod> made;
  const auto make = [&] {
    made.reset();
    made = method.Make(mesh);
  };
  Measure(state, make, [&] { made->Prepare(); });
  ReportMesh(state, mesh);
  make();
  const MemoryProbe probe;
  made->Prepare();
  ReportMemory(state, mesh, probe);
}

void MeasureField(benchmark::State& state, const MeshRecipe& recipe, const NamedMethod& method,
  double limit, int k, int numberOfSources)
{
  BenchmarkMesh& mesh = OpenMesh(recipe, limit);
  FieldMethod& prepared = GetPrepared(recipe, mesh, method);
  const dgg::Id source = mesh.GetSource(k, numberOfSources);
  if (method.IsPrepared)
  {
    prepared.Run(source);
  }
  const MemoryProbe probe;
  Measure(
    state, [] {}, [&] { prepared.Run(source); });
  ReportMemory(state, mesh, probe);
  ReportMesh(state, mesh);
  ReportErrors(state, mesh, source, prepared.TakeDistances());
}
