// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Graphs of point clouds: their errors, with all schemes, beside fast marching in the same band;
/// what noise, uneven sampling, holes and close sheets do to them; what they take, beside graphs of
/// meshes with as many points. All in one run.
///
/// Usage: BenchmarkCloud [--benchmark_...] [--name=value...] [mesh...]
///   --clouds=square:40000,cylinder:40000,sphere:10000,sphere:40000,torus:57000
///                        random points: shape and number
///   --torus=600          rings of the torus that points are taken from: many, so that it is smooth
///   --large=             the same of which only scheme C is measured
///   --schemes=A,B,C
///   --accuracy=0.001     of the graphs
///   --fine_accuracy=0.0001  scheme C with arcs is measured with that accuracy as well; 0 leaves
///                        it out
///   --sources=5          of queries and marches
///   --curves=5000        points of a sphere and a torus on which alpha and the radius of balls are
///                        varied; 0 leaves this out
///   --guards=20000       points of the clouds that are not easy; 0 leaves them out
///   --speed=200000       points of the clouds whose graphs are timed; 0 leaves them out
///   --speed_mesh=FILE    a mesh that is decimated to as many points for that
///   --terrain=FILE       a terrain on a grid: the vertices of 257 by 257 lines are measured as
///                        well
///   --threads=2          of graphs; queries and marches are on one
/// Meshes as for BenchmarkExact: their vertices are the points, and exact distances along their
/// faces the truth; faces with an edge longer than three median ones are left out.
///
/// Names of the results are
///   Cloud/CLOUD/SCHEME/WEIGHTS/CASE   CloudCases.h; WEIGHTS are arc, chord, or fine for arcs with
///                                     the fine accuracy
///   Cloud/CLOUD/Band/march/Query/K    fast marching in the band of scheme C
///   Guard/CLOUD/SCHEME/arc/CASE
///   Curve/CLOUD/SCHEME/WEIGHTS/PARAMETER/VALUE/CASE  with PARAMETER Alpha or Offset
///   Speed/CLOUD/C/arc/CASE            the graph of the cloud
///   Speed/CLOUD/Mesh/CASE             GraphCases.h; that of the mesh with the same points
/// Times of graphs of clouds are seconds on the wall, all others CPU seconds on one thread.
/// summarize_cloud.py makes tables of it, plot_cloud.py a plot.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "CloudCases.h"
#include "GraphCases.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace
{
using dgg::CloudScheme;

/// A sphere that random points are taken from: so fine that it is smooth to them.
constexpr int HolesLevel = 7;
constexpr int NumberOfHoles = 12;
/// Longer edges, in median ones, are of faces over gaps between points that are not bridged.
constexpr double LongestEdge = 3.0;
/// Grid lines of a terrain, both ways.
constexpr int TerrainLines = 257;
/// Sheets are 3 h apart.
constexpr int SheetsOffset = 3;
constexpr const char* CurveShapes[] = { "sphere", "torus" };
constexpr int CurveSources = 3;
constexpr int SpeedSources = 3;

struct Settings
{
  std::vector<CloudRecipe> Clouds;
  std::vector<CloudRecipe> LargeClouds;
  int TorusRings = 0;
  std::vector<CloudScheme> Schemes;
  double Accuracy = 0.0;
  double FineAccuracy = 0.0;
  int Sources = 0;
  int Curves = 0;
  int Guards = 0;
  int Speed = 0;
  std::string SpeedMesh;
  int Threads = 0;
};

const std::map<std::string, CloudScheme> SchemesByName = {
  { "A", CloudScheme::Curvature },
  { "B", CloudScheme::Constant },
  { "C", CloudScheme::Spacing },
};

std::string NameOf(CloudScheme scheme)
{
  return scheme == CloudScheme::Curvature ? "A" : scheme == CloudScheme::Constant ? "B" : "C";
}

std::string Labelled(const std::string& shape, int points)
{
  return shape + "-" +
    (points < 1000 ? std::to_string(points) : std::to_string((points + 500) / 1000) + "K");
}

/// A value without needless zeros.
std::string TextOf(double value)
{
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
}

MeshRecipe TorusMesh(int rings)
{
  MeshRecipe mesh;
  mesh.Name = "torus-of-" + std::to_string(rings);
  mesh.Rings = rings;
  return mesh;
}

/// A torus that random points are taken from, made of so many rings. False when there is no such
/// shape.
bool MakeCloud(const std::string& shape, int points, int rings, CloudRecipe& cloud)
{
  static const std::map<std::string, CloudShape> shapes = { { "square", CloudShape::Square },
    { "cylinder", CloudShape::Cylinder }, { "sphere", CloudShape::Sphere },
    { "torus", CloudShape::Samples } };
  const auto found = shapes.find(shape);
  if (found == shapes.end() || points < 10)
  {
    return false;
  }
  cloud = CloudRecipe();
  cloud.Name = Labelled(shape, points);
  cloud.Shape = found->second;
  cloud.Points = points;
  if (cloud.Shape == CloudShape::Samples)
  {
    cloud.Mesh = TorusMesh(rings);
  }
  return true;
}

CloudRecipe VerticesOf(const MeshRecipe& mesh)
{
  CloudRecipe cloud;
  cloud.Name = mesh.Name;
  cloud.Shape = CloudShape::Vertices;
  cloud.Mesh = mesh;
  return cloud;
}

/// Build() and all queries.
void RegisterGraph(
  const std::string& prefix, const CloudGraphRecipe& recipe, int sources, double queryTime = 0.1)
{
  const CaseGroup cases(prefix, queryTime);
  cases.For(Once).Add("Build", MeasureCloudBuild, recipe);
  cases.AddSources("Query", sources, MeasureCloudQuery, recipe);
}

CloudGraphRecipe GraphOf(const CloudRecipe& cloud, CloudScheme scheme, const std::string& weights,
  const Settings& settings)
{
  CloudGraphRecipe recipe;
  recipe.Cloud = cloud;
  recipe.Name = NameOf(scheme) + "/" + weights + "/";
  recipe.Options.Scheme = scheme;
  recipe.Options.ArcLengthWeights = weights != "chord";
  recipe.Options.Accuracy = weights == "fine" ? settings.FineAccuracy : settings.Accuracy;
  recipe.Threads = settings.Threads;
  return recipe;
}

void RegisterCloud(const CloudRecipe& cloud, const Settings& settings)
{
  const std::string prefix = "Cloud/" + cloud.Name + "/";
  for (const CloudScheme scheme : settings.Schemes)
  {
    for (const char* weights : { "chord", "arc" })
    {
      const CloudGraphRecipe recipe = GraphOf(cloud, scheme, weights, settings);
      RegisterGraph(prefix + recipe.Name, recipe, settings.Sources);
    }
  }
  if (settings.FineAccuracy > 0.0)
  {
    const CloudGraphRecipe recipe = GraphOf(cloud, CloudScheme::Spacing, "fine", settings);
    RegisterGraph(prefix + recipe.Name, recipe, settings.Sources);
  }
  const CloudGraphRecipe recipe = GraphOf(cloud, CloudScheme::Spacing, "arc", settings);
  CaseGroup(prefix, Once)
    .AddSources("Band/march/Query", settings.Sources, MeasureBandMarching, recipe);
}

std::vector<CloudRecipe> ListGuards(int points)
{
  std::vector<CloudRecipe> clouds;
  CloudRecipe cloud;
  cloud.Points = points;
  // Parts of the bounding box, which has sides of length 2.
  for (const double percent : { 0.5, 1.0 })
  {
    cloud.Name = "noise_" + TextOf(percent);
    cloud.Noise = 2.0 * percent / 100.0;
    clouds.push_back(cloud);
  }
  cloud.Name = "density_10";
  cloud.Noise = 0.0;
  cloud.Density = 10.0;
  clouds.push_back(cloud);
  cloud.Name = "holes";
  cloud.Shape = CloudShape::Samples;
  cloud.Mesh.Name = "bumpy_sphere_with_holes";
  cloud.Mesh.Level = HolesLevel;
  cloud.Mesh.Holes = NumberOfHoles;
  clouds.push_back(cloud);
  return clouds;
}

/// Two voxels per spacing, and unit squares that are three radii of balls apart.
void RegisterSheets(const Settings& settings)
{
  const int voxels = static_cast<int>(std::lround(2.0 * std::sqrt(0.5 * settings.Guards)));
  CloudRecipe cloud;
  cloud.Name = "sheets";
  cloud.Shape = CloudShape::Sheets;
  cloud.Points = settings.Guards;
  cloud.Gap = 3.0 * SheetsOffset / voxels;
  for (const CloudScheme scheme : settings.Schemes)
  {
    CloudGraphRecipe recipe = GraphOf(cloud, scheme, "arc", settings);
    recipe.Options.OffsetInVoxels = SheetsOffset;
    recipe.Options.Resolution = voxels;
    recipe.VoxelSize = 1.0 / voxels;
    RegisterGraph("Guard/sheets/" + recipe.Name, recipe, settings.Sources);
  }
}

void RegisterGuards(const Settings& settings)
{
  for (const CloudRecipe& cloud : ListGuards(settings.Guards))
  {
    for (const CloudScheme scheme : settings.Schemes)
    {
      const CloudGraphRecipe recipe = GraphOf(cloud, scheme, "arc", settings);
      RegisterGraph("Guard/" + cloud.Name + "/" + recipe.Name, recipe, settings.Sources);
    }
  }
  RegisterSheets(settings);
}

/// Values of alpha that make sense in a scheme.
std::vector<double> AlphasOf(CloudScheme scheme)
{
  switch (scheme)
  {
    case CloudScheme::Curvature:
      return { 0.5, 0.7, 1.0, 1.4, 2.0, 3.0 };
    case CloudScheme::Constant:
      return { 1.0, 2.0, 3.0, 5.0, 7.0, 9.0, 12.0, 16.0, 21.0 };
    case CloudScheme::Spacing:
      break;
  }
  return { 2.5, 3.5, 5.0, 6.5, 8.5, 10.5, 13.0, 16.0 };
}

void RegisterCurves(const CloudRecipe& cloud, const Settings& settings)
{
  const int resolution = static_cast<int>(std::lround(128.0 * std::sqrt(1e-4 * cloud.Points)));
  for (const CloudScheme scheme : settings.Schemes)
  {
    for (const char* weights : { "chord", "arc" })
    {
      const CloudGraphRecipe base = GraphOf(cloud, scheme, weights, settings);
      const auto add = [&](const char* parameter, double value, const CloudGraphRecipe& changed) {
        CloudGraphRecipe recipe = changed;
        recipe.Name += std::string(parameter) + "/" + TextOf(value) + "/";
        RegisterGraph("Curve/" + cloud.Name + "/" + recipe.Name, recipe, CurveSources, Once);
      };
      for (const double alpha : AlphasOf(scheme))
      {
        CloudGraphRecipe recipe = base;
        recipe.Options.Alpha = alpha;
        add("Alpha", alpha, recipe);
      }
      for (const double offset : { 1.5, 2.0, 3.0, 4.0, 6.0, 8.0 })
      {
        CloudGraphRecipe recipe = base;
        recipe.Options.OffsetInVoxels = offset;
        recipe.Options.Resolution = resolution;
        add("Offset", offset, recipe);
      }
    }
  }
}

void RegisterSpeedOfMesh(const std::string& prefix, const MeshRecipe& mesh)
{
  GraphRecipe recipe;
  recipe.Mesh = mesh;
  recipe.Name = "graph"; // the only one
  const CaseGroup cases(prefix);
  cases.For(Once).Add("Build", MeasureBuild, recipe);
  cases.AddSources("Query", SpeedSources, MeasureQuery, recipe, dgg::SearchMethod::Certified, true);
}

void RegisterSpeed(const Settings& settings)
{
  std::vector<CloudRecipe> clouds(1);
  MakeCloud("sphere", settings.Speed, 0, clouds[0]);
  MeshRecipe torus = TorusMesh(static_cast<int>(std::lround(std::sqrt(2.0 * settings.Speed))));
  torus.Name = Labelled("torus", settings.Speed);
  clouds.push_back(VerticesOf(torus));
  if (!settings.SpeedMesh.empty())
  {
    MeshRecipe mesh = MeshFromFile(settings.SpeedMesh);
    mesh.Name = Labelled(mesh.Name, settings.Speed);
    mesh.Vertices = settings.Speed;
    clouds.push_back(VerticesOf(mesh));
  }
  for (CloudRecipe& cloud : clouds)
  {
    const std::string prefix = "Speed/" + cloud.Name + "/";
    cloud.Name += " (speed)"; // another cloud than that of the same name
    const CloudGraphRecipe recipe = GraphOf(cloud, CloudScheme::Spacing, "arc", settings);
    CaseGroup(prefix + "C/arc/", Once).Add("Estimate", MeasureCloudEstimate, recipe);
    RegisterGraph(prefix + "C/arc/", recipe, SpeedSources);
    if (cloud.Shape == CloudShape::Vertices)
    {
      RegisterSpeedOfMesh(prefix + "Mesh/", cloud.Mesh);
    }
  }
}

/// Each text is a shape, a colon and a number.
std::vector<CloudRecipe> ReadClouds(const std::vector<std::string>& texts, int rings)
{
  std::vector<CloudRecipe> clouds;
  for (const std::string& text : texts)
  {
    const auto colon = text.find(':');
    CloudRecipe cloud;
    Require(colon != std::string::npos &&
        MakeCloud(text.substr(0, colon), std::atoi(text.c_str() + colon + 1), rings, cloud),
      "clouds are square, cylinder, sphere or torus, a colon and a number of points, at least 10: "
      "not " +
        text);
    clouds.push_back(cloud);
  }
  return clouds;
}

/// Clouds are kept by their names.
void RequireOwnNames(const Settings& settings)
{
  std::vector<CloudRecipe> clouds = settings.Clouds;
  clouds.insert(clouds.end(), settings.LargeClouds.begin(), settings.LargeClouds.end());
  std::map<std::string, int> points;
  for (const CloudRecipe& cloud : clouds)
  {
    Require(points.insert({ cloud.Name, cloud.Points }).second,
      "two clouds have the name " + cloud.Name + ": numbers of points differ by 1000 at least");
  }
  for (const char* shape : CurveShapes)
  {
    const auto found = points.find(Labelled(shape, settings.Curves));
    Require(settings.Curves <= 0 || found == points.end() || found->second == settings.Curves,
      "curves are of another cloud with the name " + Labelled(shape, settings.Curves));
  }
}

Settings ReadSettings(const BenchmarkArguments& arguments)
{
  Settings settings;
  settings.TorusRings = TorusOfRings(arguments.GetInteger("torus")).Rings;
  settings.Clouds = ReadClouds(arguments.GetList("clouds"), settings.TorusRings);
  settings.LargeClouds = ReadClouds(arguments.GetList("large"), settings.TorusRings);
  for (const MeshRecipe& mesh : arguments.GetMeshes())
  {
    CloudRecipe cloud = VerticesOf(mesh);
    cloud.Mesh.LongestEdge = LongestEdge;
    settings.Clouds.push_back(cloud);
  }
  if (!arguments.Get("terrain").empty())
  {
    MeshRecipe terrain = MeshFromFile(arguments.Get("terrain"));
    terrain.Name = Labelled(terrain.Name, TerrainLines * TerrainLines);
    terrain.GridLines = TerrainLines;
    settings.Clouds.push_back(VerticesOf(terrain));
  }
  for (const std::string& name : arguments.GetList("schemes"))
  {
    const auto found = SchemesByName.find(name);
    Require(found != SchemesByName.end(), "schemes are A, B and C: not " + name);
    settings.Schemes.push_back(found->second);
  }
  settings.Accuracy = arguments.GetNumber("accuracy");
  settings.FineAccuracy = arguments.GetNumber("fine_accuracy");
  settings.Sources = arguments.GetInteger("sources");
  settings.Curves = arguments.GetInteger("curves");
  settings.Guards = arguments.GetInteger("guards");
  settings.Speed = arguments.GetInteger("speed");
  settings.SpeedMesh = arguments.Get("speed_mesh");
  settings.Threads = arguments.GetInteger("threads");
  for (const double accuracy : { settings.Accuracy, settings.FineAccuracy })
  {
    dgg::CloudGraphOptions options;
    options.Accuracy = accuracy;
    Require(dgg::CloudGraphBuilder::Check(options));
  }
  Require(
    std::min(settings.Sources, settings.Threads) >= 1, "sources and threads must be at least 1");
  for (const int points : { settings.Curves, settings.Guards, settings.Speed })
  {
    Require(
      points == 0 || points >= 100, "curves, guards and speed have at least 100 points, or 0");
  }
  RequireOwnNames(settings);
  return settings;
}

void RegisterAll(const BenchmarkArguments& arguments)
{
  const Settings settings = ReadSettings(arguments);
  for (const CloudRecipe& cloud : settings.Clouds)
  {
    RegisterCloud(cloud, settings);
  }
  Settings spacing = settings;
  spacing.Schemes = { CloudScheme::Spacing };
  for (const CloudRecipe& cloud : settings.LargeClouds)
  {
    RegisterCloud(cloud, spacing);
  }
  if (settings.Guards > 0)
  {
    RegisterGuards(settings);
  }
  for (const char* shape : CurveShapes)
  {
    CloudRecipe cloud;
    if (settings.Curves > 0 && MakeCloud(shape, settings.Curves, settings.TorusRings, cloud))
    {
      RegisterCurves(cloud, settings);
    }
  }
  if (settings.Speed > 0)
  {
    RegisterSpeed(settings);
  }
}
}

int main(int argc, char** argv)
{
  return RunBenchmarks(argc, argv,
    { { "clouds", "square:40000,cylinder:40000,sphere:10000,sphere:40000,torus:57000" },
      { "large", "" }, { "torus", "600" }, { "schemes", "A,B,C" }, { "accuracy", "0.001" },
      { "fine_accuracy", "0.0001" }, { "sources", "5" }, { "curves", "5000" },
      { "guards", "20000" }, { "speed", "200000" }, { "speed_mesh", "" }, { "terrain", "" },
      { "threads", "2" } },
    RegisterAll);
}
