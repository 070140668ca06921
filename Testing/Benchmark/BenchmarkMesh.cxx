// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMesh.h"

#include "GeneratedMesh.h"
#include "MeshFile.h"
#include "dggExactGeodesics.h"

#include <vtkCleanPolyData.h>
#include <vtkLoopSubdivisionFilter.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>

namespace
{
vtkSmartPointer<vtkPolyData> Generated(const MeshRecipe& recipe)
{
  if (recipe.Rings > 0)
  {
    return ToPolyData(Torus(recipe.Rings, recipe.Rings / 2));
  }
  return ToPolyData(BumpySphere(recipe.Level));
}

/// Removes points without a face; does not merge points.
vtkSmartPointer<vtkPolyData> WithoutUnusedPoints(vtkPolyData* mesh)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(mesh);
  clean->PointMergingOff();
  clean->Update();
  return clean->GetOutput();
}

vtkSmartPointer<vtkPolyData> Decimated(vtkPolyData* mesh, int vertices)
{
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(mesh);
  decimation->SetTargetReduction(1.0 - static_cast<double>(vertices) / mesh->GetNumberOfPoints());
  decimation->VolumePreservationOn();
  decimation->Update();
  return WithoutUnusedPoints(decimation->GetOutput());
}

vtkSmartPointer<vtkPolyData> Subdivided(vtkPolyData* mesh, int steps)
{
  vtkNew<vtkLoopSubdivisionFilter> subdivision;
  subdivision->SetInputData(WithoutUnusedPoints(mesh));
  subdivision->SetNumberOfSubdivisions(steps);
  subdivision->Update();
  return subdivision->GetOutput();
}
}

vtkSmartPointer<vtkPolyData> MeshRecipe::Make() const
{
  vtkSmartPointer<vtkPolyData> mesh =
    this->File.empty() ? Generated(*this) : ReadPolyData(this->File);
  if (this->Vertices > 0)
  {
    mesh = Decimated(mesh, this->Vertices);
  }
  if (this->Subdivisions > 0)
  {
    mesh = Subdivided(mesh, this->Subdivisions);
  }
  return mesh;
}

BenchmarkMesh::BenchmarkMesh(const MeshRecipe& recipe)
  : PolyData(recipe.Make())
{
  this->Arrays = ToArrays(this->PolyData);
  if (this->Arrays.Triangles.empty())
  {
    this->Error = "no triangles in " + recipe.Name;
    return;
  }
  const dgg::Status status = dgg::SurfaceMesh::FromPoints(this->Arrays.Points.data(),
    static_cast<dgg::Offset>(this->Arrays.GetNumberOfVertices()), this->Arrays.Triangles.data(),
    static_cast<dgg::Offset>(this->Arrays.GetNumberOfFaces()), this->Surface);
  this->Error = status.GetMessage();
}

dgg::Id BenchmarkMesh::GetSource(int k, int numberOfSources) const
{
  const dgg::Id count = this->Surface.GetNumberOfVertices();
  dgg::Id source = static_cast<dgg::Id>(static_cast<dgg::Offset>(count) * k / numberOfSources);
  while (this->Surface.Kind(source) == dgg::VertexKind::Isolated)
  {
    source = (source + 1) % count;
  }
  return source;
}

const std::vector<double>& BenchmarkMesh::GetExactDistances(dgg::Id source)
{
  const auto inserted = this->ExactDistances.insert({ source, {} });
  if (inserted.second)
  {
    dgg::ExactGeodesics solver(this->Surface);
    dgg::ExactResult result;
    solver.Run({ { dgg::SurfacePoint::AtVertex(source), 0.0 } }, {}, result);
    inserted.first->second = std::move(result.Distances);
  }
  return inserted.first->second;
}

void BenchmarkMesh::SetExactDistances(dgg::Id source, std::vector<double> distances)
{
  this->ExactDistances[source] = std::move(distances);
}

MeasuredPairs& BenchmarkMesh::GetPairs(const PairRecipe& recipe)
{
  return this->Pairs.try_emplace(recipe, this->Surface, recipe).first->second;
}

MeasuredGraph& BenchmarkMesh::GetGraph(const GraphRecipe& recipe)
{
  if (!this->Graph || this->GraphName != recipe.Name)
  {
    this->Graph.reset(); // release before the next is allocated
    this->Graph = std::make_unique<MeasuredGraph>(this->Surface, recipe.Options);
    this->GraphName = recipe.Name;
  }
  return *this->Graph;
}

vtkPolyData* BenchmarkMesh::GetPolyData() const
{
  return this->PolyData;
}

BenchmarkMesh& GetBenchmarkMesh(const MeshRecipe& recipe)
{
  static std::unique_ptr<BenchmarkMesh> kept;
  static std::string name;
  if (!kept || name != recipe.Name)
  {
    kept.reset(); // release before the next is allocated
    kept = std::make_unique<BenchmarkMesh>(recipe);
    name = recipe.Name;
  }
  return *kept;
}
