// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Table of filters: Green's functions, spectral distances, splines, earth mover's distances.
#include "FilterCases.h"

#include "vtkBiharmonicDistance.h"
#include "vtkDiscreteGreensFunction.h"
#include "vtkHarmonicBSpline.h"
#include "vtkSurfaceEarthMoversDistance.h"

namespace dggtest
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

void AddArray(vtkPolyData* surface, const char* name, const std::function<double(vtkIdType)>& value,
  int components = 1)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (vtkIdType i = 0; i < components * surface->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(value(i));
  }
  surface->GetPointData()->AddArray(array);
  surface->Modified();
}

vtkPolyData* GetSurface(vtkAlgorithm* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetInputDataObject(0, 0));
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeGreens(vtkPolyData* surface)
{
  auto greens = MakeFilter<vtkDiscreteGreensFunction>(surface);
  greens->SetSourceIds(OnRelief(surface, { 40, 29 }));
  greens->SetMethodToInterpolated(); // the surface is too coarse for other methods
  return greens;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeBiharmonic(vtkPolyData* surface)
{
  auto distance = MakeFilter<vtkBiharmonicDistance>(surface);
  distance->SetSourceIds(OnRelief(surface, { 40, 7 }));
  distance->SetNumberOfEigenvalues(12);
  return distance;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeSplines(vtkPolyData* surface)
{
  AddArray(surface, "f", [](vtkIdType i) { return i == 0 ? 0.0 : 2.0 * (i % 2) - 1.0; });
  auto splines = MakeFilter<vtkHarmonicBSpline>(surface);
  splines->SetSourceIds(OnRelief(surface, { 20, 24, 60 }));
  splines->SetRightHandSideArrayName("f");
  splines->SetRightHandSideMeaningToIntegrated();
  return splines;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeBiharmonicSplines(vtkPolyData* surface)
{
  AddArray(surface, "v", [](vtkIdType i) { return i % 5 - 2.0; });
  auto splines = MakeFilter<vtkHarmonicBSpline>(surface);
  splines->SetSourceIds(OnRelief(surface, { 20, 24, 60 }));
  splines->SetOrderToBiharmonic();
  splines->SetSiteValuesArrayName("v");
  return splines;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeMovers(vtkPolyData* surface)
{
  AddArray(surface, "from", [](vtkIdType i) { return i % 3 == 0 ? 1.0 : 0.0; });
  AddArray(surface, "to", [](vtkIdType i) { return i % 4 == 0 ? 1.0 : 0.5; });
  auto movers = MakeFilter<vtkSurfaceEarthMoversDistance>(surface);
  movers->SetFromArrayName("from");
  movers->SetToArrayName("to");
  movers->SetTolerance(0.01);
  return movers;
}

/// Sets sources and evaluation points.
const auto SetSources = PointSetter<vtkSpectralAlgorithm>([](auto* filter, vtkPolyData* points) {
  filter->RemoveAllSources();
  filter->SetSourceData(points);
  filter->SetEvaluationData(points);
});

/// Sets sites. Sites given by ids lie in the first and in the last component.
const auto SetSites = PointSetter<vtkHarmonicBSpline>([](auto* splines, vtkPolyData* points) {
  vtkNew<vtkPolyData> sites;
  sites->ShallowCopy(points);
  AddArray(sites, "v", [](vtkIdType i) { return 1.0 + i; });
  splines->SetSourceIds({ 0, GetSurface(splines)->GetNumberOfPoints() - 1 });
  splines->SetSourceData(sites);
});

/// Sets points with masses.
const auto SetMasses =
  PointSetter<vtkSurfaceEarthMoversDistance>([](auto* movers, vtkPolyData* points) {
    vtkNew<vtkPolyData> ends[2];
    for (const int end : { 0, 1 })
    {
      ends[end]->ShallowCopy(points);
      AddArray(ends[end], "mass", [end](vtkIdType i) { return end == 0 ? 1.0 + i : 5.0 - i; });
    }
    movers->SetFromArrayName(nullptr);
    movers->SetToArrayName(nullptr);
    movers->SetMassArrayName("mass");
    movers->SetFromData(ends[0]);
    movers->SetToData(ends[1]);
  });

/// Returns the refusals common to filters with sources.
std::vector<Refusal> RefuseSources()
{
  using F = vtkSpectralAlgorithm;
  const auto evaluation = [](const std::array<double, 3>& point) {
    return [point](F* f) { f->SetEvaluationData(MakeSourcePoints({ { { 0, 0, 0 } }, point })); };
  };
  return RefuseValues(&F::SetProjectionTolerance, { NaN }, { "ProjectionTolerance" }) +
    std::vector<Refusal>{ RefuseMemoryLimit(1000),
      Refuse<F>([](F* f) { f->AddSourceId(81); }, { "source id 81 ", "out of range" }),
      Refuse<F>(evaluation(FarFromRelief), { "evaluation point 1, at (", "ProjectionTolerance" }) };
}

Refusal RefuseNoSource()
{
  using F = vtkSpectralAlgorithm;
  return Refuse<F>([](F* f) { f->RemoveAllSources(); }, { "no source", "SourceIds" });
}

std::vector<Refusal> RefuseGreens()
{
  using F = vtkDiscreteGreensFunction;
  return RefuseSources() + RefuseValues(&F::SetRadius, { -1.0, NaN, Infinity }, { "Radius" }) +
    RefuseValues(&F::SetResultArrayName, { nullptr }, { "ResultArrayName" }) +
    std::vector<Refusal>{ RefuseNoSource(),
      Refuse<F>(
        [](F* f) {
          f->SetBoundaryToDirichlet();
          f->SetSourceIds({ 40, 3 });
        },
        { "source 1", "boundary", "Neumann" }),
      Refuse<F>(
        [](F* f) {
          f->SetInputData(MakeCube());
          f->SetSourceIds({ 0 });
          f->SetBoundaryToDirichlet();
        },
        { "source 0", "without a boundary", "Neumann" }) };
}

std::vector<Refusal> RefuseBiharmonic()
{
  using F = vtkBiharmonicDistance;
  const auto time = [](double value) {
    return [value](F* f) {
      f->SetKindToDiffusion();
      f->SetMethodToSpectrum();
      f->SetDiffusionTime(value);
    };
  };
  return RefuseSources() +
    std::vector<Refusal>{ RefuseNoSource(),
      Refuse<F>(
        [](F* f) {
          f->SetKindToDiffusion();
          f->SetMethodToExact();
        },
        { "diffusion", "Set Method to Spectrum" }),
      Refuse<F>(time(-1.0), { "DiffusionTime" }), Refuse<F>(time(NaN), { "DiffusionTime" }) } +
    RefuseValues(&F::SetNumberOfEigenvalues, { 0 }, { "NumberOfEigenvalues" });
}

std::vector<Refusal> RefuseSplines()
{
  using F = vtkHarmonicBSpline;
  const auto side = [](const std::function<double(vtkIdType)>& value, int components,
                      const std::vector<std::string>& parts) {
    return Refuse<F>([=](F* f) { AddArray(GetSurface(f), "f", value, components); }, parts);
  };
  const auto names = [](const char* cell, const char* solution, const char* result,
                       const std::vector<std::string>& parts) {
    return Refuse<F>(
      [=](F* f) {
        f->SetCellArrayName(cell);
        f->SetSolutionArrayName(solution);
        f->SetResultArrayName(result);
      },
      parts);
  };
  return RefuseSources() +
    std::vector<Refusal>{ Refuse<F>(
                            [](F* f) { f->AddSourceId(20); }, { "site 3 (vertex 20)", "site 0" }),
      Refuse<F>([](F* f) { f->SetRightHandSideArrayName("missing"); },
        { "no point array 'missing'", "RightHandSideArrayName" }),
      side([](vtkIdType i) { return i == 7 ? NaN : 0.0; }, 1, { "'f'", "point 7", "finite" }),
      side(
        [](vtkIdType i) { return i < 40 ? 1.7e308 : -1.7e308; }, 1, { "right-hand side", "1e290" }),
      side([](vtkIdType) { return 0.0; }, 3, { "'f'", "3 components" }),
      // All points of a single triangle are on its boundary.
      Refuse<F>(
        [](F* f) {
          f->RemoveAllSources();
          f->SetRightHandSideArrayName(nullptr);
          f->SetInputData(
            MakeSurface({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } }, { { 0, 1, 2 } }));
          f->SetBoundaryToDirichlet();
        },
        { "no point can be a site", "Neumann" }),
      names("Same", "Same", "Basis", { "'Same'", "different" }),
      names("Cell", "Heat", "Cell", { "ResultArrayName", "different" }),
      names("Cell", "Heat", "Heat", { "ResultArrayName", "different" }),
      names("Cell", "", "Basis", { "SolutionArrayName", "empty" }),
      names("", "Heat", "Basis", { "CellArrayName", "empty" }) };
}

std::vector<Refusal> RefuseBiharmonicSplines()
{
  using F = vtkHarmonicBSpline;
  const auto value = [](const std::function<double(vtkIdType)>& f,
                       const std::vector<std::string>& parts) {
    return Refuse<F>([=](F* filter) { AddArray(GetSurface(filter), "v", f); }, parts);
  };
  const auto array = [](vtkAbstractArray* values) {
    values->SetName("v");
    return Refuse<F>(
      [values = vtkSmartPointer<vtkAbstractArray>(values)](F* f) {
        GetSurface(f)->GetPointData()->AddArray(values);
        GetSurface(f)->Modified();
      },
      { "'v'", "numbers for each point" });
  };
  vtkNew<vtkStringArray> words;
  words->SetNumberOfValues(81);
  vtkNew<vtkDoubleArray> few;
  few->SetNumberOfTuples(3);
  const auto places = [](int points, bool hasValues, const std::vector<std::string>& parts) {
    return Refuse<F>(
      [=](F* f) {
        // Three points inside the first triangle; the last two coincide.
        double p[3][3];
        for (vtkIdType k = 0; k < 3; ++k)
        {
          GetSurface(f)->GetPoint(k < 2 ? k : 9, p[k]);
        }
        Points inside;
        for (int i = 0; i < points; ++i)
        {
          const double t = 0.1 + 0.05 * std::min(i, points - 2);
          inside.push_back({ { 0, 0, 0 } });
          for (int k = 0; k < 3; ++k)
          {
            inside.back()[k] = t * p[0][k] + 0.3 * p[1][k] + (0.7 - t) * p[2][k];
          }
        }
        auto data = MakeSourcePoints(inside);
        if (hasValues)
        {
          AddArray(data, "v", [](vtkIdType i) { return 1.0 + i; });
        }
        f->SetSourceData(data);
      },
      parts);
  };
  return { Refuse<F>([](F* f) { f->SetSiteValuesArrayName("missing"); },
             { "no point array 'missing'", "SiteValuesArrayName" }),
    value([](vtkIdType i) { return i == 24 ? NaN : 1.0; }, { "'v'", "point 24", "site" }),
    value([](vtkIdType i) { return i == 24 ? Infinity : 1.0; }, { "'v'", "point 24", "site" }),
    value([](vtkIdType i) { return i < 22 ? 1.7e308 : -1.7e308; }, { "too large" }), array(words),
    array(few), places(1, false, { "input port 1", "'v'" }),
    places(2, true, { "site 4 has the same position as site 3" }),
    Refuse<F>([](F* f) { f->AddSourceId(24); }, { "site 3 (vertex 24)", "site 1" }),
    Refuse<F>([](F* f) { f->SetInterpolationArrayName("Cell"); },
      { "InterpolationArrayName", "'Cell'", "different" }),
    Refuse<F>([](F* f) { f->SetInterpolationArrayName(""); }, { "InterpolationArrayName" }),
    RefuseMemoryLimit(1000) };
}

std::vector<Refusal> RefuseMovers()
{
  using F = vtkSurfaceEarthMoversDistance;
  const auto to = [](const std::function<double(vtkIdType)>& value, int components,
                    const std::vector<std::string>& parts) {
    return Refuse<F>([=](F* f) { AddArray(GetSurface(f), "to", value, components); }, parts);
  };
  const auto mass = [](const char* name, const std::vector<std::string>& parts) {
    return Refuse<F>(
      [=](F* f) {
        f->SetFromArrayName(nullptr);
        auto points = MakeSourcePoints({ { { 0, 0, 0 } } });
        AddArray(points, "mass", [](vtkIdType) { return -2.0; });
        f->SetMassArrayName(name);
        f->SetFromData(points);
      },
      parts);
  };
  return RefuseValues(&F::SetProjectionTolerance, { -1.0, NaN }, { "ProjectionTolerance" }) +
    RefuseValues(&F::SetTolerance, { -1.0, NaN }, { "Tolerance" }) +
    RefuseValues(&F::SetFromArrayName, { nullptr },
      { "nothing to move from", "FromArrayName", "input port 1" }) +
    RefuseValues(
      &F::SetToArrayName, { "" }, { "nothing to move to", "ToArrayName", "input port 2" }) +
    RefuseValues(&F::SetToArrayName, { "else" }, { "no point array 'else'", "ToArrayName" }) +
    std::vector<Refusal>{ RefuseMemoryLimit(1000),
      to([](vtkIdType i) { return i == 37 ? -1.0 : 1.0; }, 1, { "'to'", "point 37" }),
      to([](vtkIdType i) { return i == 37 ? NaN : 1.0; }, 1, { "'to'", "point 37" }),
      to([](vtkIdType i) { return i == 37 ? Infinity : 1.0; }, 1, { "'to'", "point 37" }),
      to([](vtkIdType) { return 1.0; }, 2, { "'to'", "2 components" }),
      to([](vtkIdType) { return 0.0; }, 1, { "second distribution has no mass" }),
      Refuse<F>(
        [](F* f) {
          f->SetArrayMeaningToMass();
          AddArray(GetSurface(f), "to", [](vtkIdType) { return 1.7e308; });
        },
        { "sum of the masses is not finite" }),
      Refuse<F>(
        [](F* f) {
          f->SetArrayMeaningToMass();
          f->NormalizeOff();
          AddArray(GetSurface(f), "from", [](vtkIdType) { return 1.0; });
          AddArray(GetSurface(f), "to", [](vtkIdType) { return 2.0; });
        },
        { "the mass 81", "162" }),
      mass("missing", { "input port 1", "'missing'", "MassArrayName" }),
      mass("mass", { "'mass'", "-2" }) };
}
}

std::vector<FilterCase> GetSpectralFilters()
{
  return {
    { "Greens", MakeGreens, SetSources,
      { "Method: SingularitySubtraction", "Boundary: Neumann", "Radius: 0" }, RefuseGreens() },
    { "Biharmonic", MakeBiharmonic, SetSources,
      { "Kind: Biharmonic", "Method: Spectrum", "UnreachedValue: nan" }, RefuseBiharmonic() },
    { "Splines", MakeSplines, SetSites,
      { "Order: Harmonic", "NumberOfSites: 20", "SourceIds: (none)" }, RefuseSplines() },
    { "BiharmonicSplines", MakeBiharmonicSplines, SetSites, {}, RefuseBiharmonicSplines() },
    { "EarthMovers", MakeMovers, SetMasses, { "ArrayMeaning: Density", "Normalize: On" },
      RefuseMovers() },
  };
}
}
