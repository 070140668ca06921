// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Layout of stored graphs, and rejection of invalid arrays.
#include "TaskTestTools.h"

#include <cstring>

namespace dggtest
{
namespace
{
using dgg::Offset;
using dgg::StoredArray;
using dgg::StoredGraph;

/// Copies of the arrays of a stored graph, which tests may modify.
struct Arrays
{
  explicit Arrays(const GraphWorld& world)
    : Offsets(world.Graph.Offsets.begin(), world.Graph.Offsets.end())
    , Targets(world.Graph.Targets.begin(), world.Graph.Targets.end())
    , Lengths(world.Graph.Lengths.begin(), world.Graph.Lengths.end())
    , Angles(world.Graph.Angles.begin(), world.Graph.Angles.end())
    , ArrivalAngles(world.Graph.ArrivalAngles.begin(), world.Graph.ArrivalAngles.end())
    , Radii(world.Radii)
  {
    const dgg::Buffer<std::int64_t> info =
      world.Store().MakeInfo(*world.Surface, dgg::ParallelFor());
    this->Info.assign(info.begin(), info.end());
    this->Stored[StoredGraph::Offsets] = Describe(this->Offsets, StoredArray::Int64);
    this->Stored[StoredGraph::Targets] = Describe(this->Targets, StoredArray::Int32);
    this->Stored[StoredGraph::Lengths] = Describe(this->Lengths, StoredArray::Float);
    if (this->Radii.empty())
    {
      this->Stored[StoredGraph::Angles] = Describe(this->Angles, StoredArray::Float);
      this->Stored[StoredGraph::ArrivalAngles] = Describe(this->ArrivalAngles, StoredArray::Float);
    }
    else
    {
      this->Stored[StoredGraph::Radii] = Describe(this->Radii, StoredArray::Double);
    }
    this->Stored[StoredGraph::Info] = Describe(this->Info, StoredArray::Int64);
  }
  Arrays(const Arrays&) = delete;
  Arrays& operator=(const Arrays&) = delete;

  template <typename T>
  static StoredArray Describe(const std::vector<T>& values, StoredArray::ValueType type)
  {
    return { values.data(), static_cast<Offset>(values.size()), type, "a type" };
  }

  std::vector<Offset> Offsets;
  std::vector<Id> Targets;
  std::vector<float> Lengths;
  std::vector<float> Angles;
  std::vector<float> ArrivalAngles;
  std::vector<double> Radii;
  std::vector<std::int64_t> Info;
  StoredGraph::Arrays Stored;
};

/// Expects modified arrays to be refused with a message, as damaged or not.
void ExpectRefused(const GraphWorld& world, const dgg::PreparedSurface& surface,
  const std::function<void(Arrays&)>& change, const std::string& text, bool isDamaged = true)
{
  SCOPED_TRACE(text);
  Arrays arrays(world);
  change(arrays);
  StoredGraph read = world.Store();
  EXPECT_TRUE(Says(read.Read(arrays.Stored, surface, WithThreads(2)), text));
  EXPECT_EQ(!read.GetDamage().empty(), isDamaged) << read.GetDamage();
  EXPECT_EQ(read.GetView().Offsets, nullptr);
  EXPECT_EQ(read.GetBand().Radii, nullptr);
}

GraphWorld PlaneWorld()
{
  return GraphWorld(Plane(4, 4, 0.2, 7), 0.05);
}
}

TEST(StoredGraph, ReadsWhatWasStored)
{
  for (const bool isCloud : { false, true })
  {
    const GraphWorld world = isCloud ? CornerWorld() : PlaneWorld();
    const Arrays arrays(world);
    EXPECT_EQ(StoredGraph::IsOfCloud(arrays.Stored[StoredGraph::Info]), isCloud);
    StoredGraph read;
    ASSERT_TRUE(Ok(read.Read(arrays.Stored, *world.Surface, WithThreads(2))));
    EXPECT_EQ(read.GetDamage(), "");
    const dgg::GraphView& view = read.GetView();
    EXPECT_EQ(view.Offsets, arrays.Offsets.data());
    EXPECT_EQ(view.Targets, arrays.Targets.data());
    EXPECT_EQ(view.Lengths, arrays.Lengths.data());
    EXPECT_EQ(view.Angles, isCloud ? nullptr : arrays.Angles.data());
    EXPECT_EQ(view.Info.Accuracy, world.Graph.Info.Accuracy);
    EXPECT_EQ(view.Info.Construction, world.Graph.Info.Construction);
    EXPECT_EQ(read.GetBand().Radii, isCloud ? arrays.Radii.data() : nullptr);
    EXPECT_EQ(read.GetBand().VoxelSize, isCloud ? 0.25 : 0.0);
    const dgg::GraphSummary summary(view);
    EXPECT_EQ(summary.NumberOfEdges, static_cast<Offset>(arrays.Targets.size()));
    EXPECT_EQ(summary.MemorySize, world.Graph.GetMemorySize());
  }
  // Arrays of meshes beside the graph of a cloud are not read.
  const GraphWorld cloud = CornerWorld();
  Arrays arrays(cloud);
  arrays.Stored[StoredGraph::Angles] = { nullptr, 3, StoredArray::Other, "a type" };
  StoredGraph read;
  EXPECT_TRUE(Ok(read.Read(arrays.Stored, *cloud.Surface, WithThreads(2))));
}

TEST(StoredGraph, LayoutOfInfo)
{
  // Files contain these values, so their positions must never change.
  const GraphWorld world = PlaneWorld();
  const Arrays arrays(world);
  double accuracy = 0.0;
  std::memcpy(&accuracy, &arrays.Info[3], sizeof(accuracy));
  EXPECT_EQ(accuracy, 0.05);
  ASSERT_EQ(arrays.Info.size(), 12u);
  const std::vector<std::int64_t> start(arrays.Info.begin(), arrays.Info.begin() + 3);
  EXPECT_EQ(start, (std::vector<std::int64_t>{ 1, 0, 0 })); // version, kind, construction
  for (int k = 0; k < 2; ++k)
  {
    EXPECT_EQ(static_cast<std::uint64_t>(arrays.Info[6 + k]), world.Surface->GetSignature()[k]);
  }
}

TEST(StoredGraph, RefusesMissingShortAndMistypedArrays)
{
  for (const bool isCloud : { false, true })
  {
    const GraphWorld world = isCloud ? CornerWorld() : PlaneWorld();
    for (int role = 0; role < StoredGraph::NumberOfRoles; ++role)
    {
      if (!world.Store().HasRole(role))
      {
        continue;
      }
      const std::string name = StoredGraph::GetName(role);
      const auto refuse = [&](const std::function<void(StoredArray&)>& change,
                            const std::string& text, bool isDamaged = true) {
        ExpectRefused(
          world, *world.Surface, [&](Arrays& arrays) { change(arrays.Stored[role]); }, text,
          isDamaged);
      };
      if (!isCloud || role != StoredGraph::Info) // otherwise read as a mesh graph
      {
        refuse([](StoredArray& array) { array = StoredArray(); },
          "the field array " + name + " is missing");
        refuse([](StoredArray& array) { array.Type = StoredArray::Other; },
          name + " has the type a type ");
      }
      // A missing target makes the other arrays too long. The number of points follows from the
      // offsets.
      const bool isOffsets = role == StoredGraph::Offsets;
      refuse([](StoredArray& array) { --array.Size; },
        role == StoredGraph::Targets ? "but DGG.Targets has "
          : isOffsets                ? "does not fit: DGG.Offsets has "
                                     : name + " has ",
        !isOffsets);
    }
  }
}

TEST(StoredGraph, RefusesDamagedInfo)
{
  const GraphWorld world = PlaneWorld();
  const auto refuse = [&](int slot, std::int64_t value, const std::string& text, bool isDamaged) {
    ExpectRefused(
      world, *world.Surface, [&](Arrays& arrays) { arrays.Info[slot] = value; }, text, isDamaged);
  };
  refuse(0, 2, "has the format version 2", false);
  refuse(1, 7, "its kind is 7", true);
  refuse(2, 4, "its construction is 4", true);
  refuse(2, -1, "its construction is -1", true);
  refuse(3, -1, "its accuracy is ", true);
  refuse(4, 1, "its checksum is wrong", true);
  refuse(9, -1, "its merge tolerance is ", true);
  refuse(11, 0, "its checksum is wrong", true);
}

TEST(StoredGraph, RefusesImpossibleValues)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::pair<std::function<void(Arrays&)>, const char*> cases[] = {
    { [](Arrays& a) { a.Targets[17] = 25; }, "leads to vertex 25 of 25" },
    { [](Arrays& a) { a.Targets[17] = -1; }, "leads to vertex -1" },
    { [](Arrays& a) { a.Targets[0] = 0; }, "own vertex" },
    { [](Arrays& a) { a.Offsets[0] = 1; }, "offsets" },
    { [](Arrays& a) { a.Offsets[10] = Offset(1) << 50; }, "offsets" },
    { [](Arrays& a) { a.Offsets[10] = -(Offset(1) << 50); }, "offsets" },
    { [](Arrays& a) { a.Lengths[17] = 0.0f; }, "length" },
    { [=](Arrays& a) { a.Lengths[17] = nan; }, "length" },
    { [=](Arrays& a) { a.Angles[2] = nan; }, "angle" },
    { [](Arrays& a) { a.Angles[2] = 9.0f; }, "sorted by angle" },
    { [=](Arrays& a) { a.ArrivalAngles[2] = nan; }, "angle" },
  };
  const GraphWorld world = PlaneWorld();
  for (const auto& [change, text] : cases)
  {
    ExpectRefused(world, *world.Surface, change, text);
  }
}

TEST(StoredGraph, NoticesEveryChangedValue)
{
  for (const bool isCloud : { false, true })
  {
    const GraphWorld world = isCloud ? CornerWorld() : GraphWorld(Plane(2, 2, 0.2, 7), 0.05);
    StoredGraph read;
    Arrays arrays(world);
    const auto flip = [&](auto& values) {
      for (auto& value : values)
      {
        auto* lowest = reinterpret_cast<unsigned char*>(&value);
        *lowest ^= 1;
        EXPECT_FALSE(read.Read(arrays.Stored, *world.Surface, dgg::ParallelFor()).IsOk());
        *lowest ^= 1;
      }
    };
    flip(arrays.Offsets);
    flip(arrays.Targets);
    flip(arrays.Lengths);
    flip(arrays.Angles);
    flip(arrays.ArrivalAngles);
    flip(arrays.Radii);
    flip(arrays.Info);
    EXPECT_TRUE(Ok(read.Read(arrays.Stored, *world.Surface, dgg::ParallelFor())));
  }
}

TEST(StoredGraph, RefusesOtherSurfaces)
{
  const GraphWorld world = PlaneWorld();
  const auto unchanged = [](Arrays&) {};
  const TestMesh mesh = Plane(4, 4, 0.2, 7);
  const auto refuse = [&](
                        const TestMesh& other, const dgg::Domain& domain, const std::string& text) {
    ExpectRefused(world, *Prepare(other, domain), unchanged, text, false);
  };
  refuse(Plane(4, 4, 0.2, 8), {}, "is out of date: points or cells have changed");
  refuse(Plane(4, 3), {}, "does not fit: DGG.Offsets has 26 values, but 20 points need 21");
  refuse(mesh, { dgg::Domain::Cloud, 0.0 }, "is that of a mesh");

  // Two triangles with a seam whose points merge.
  TestMesh seam;
  seam.Points = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 0, 1, 0 };
  seam.Triangles = { 0, 1, 2, 3, 5, 4 };
  const auto merged = [](double tolerance) {
    return dgg::Domain{ dgg::Domain::MergedSurface, tolerance };
  };
  ExpectRefused(GraphWorld(seam), *Prepare(seam, merged(0.0)), unchanged,
    "was built with MergeCoincidentPoints off, but the surface has it on", false);
  GraphWorld tolerant(seam);
  tolerant.Surface = Prepare(seam, merged(0.001));
  tolerant.Graph = BuildGraph(tolerant.Surface->GetMesh(), 0.05);
  tolerant.Graph.Info.Surface = tolerant.Surface->GetSignature();
  ExpectRefused(tolerant, *Prepare(seam), unchanged,
    "was built with MergeCoincidentPoints on, but the surface has it off", false);
  seam.Points[1] = 1e-3; // a different surface
  ExpectRefused(tolerant, *Prepare(seam, merged(0.0)), unchanged,
    "was built with a MergeTolerance of 0.001, but the surface has 0", false);
}

TEST(StoredGraph, RefusesBandsOfClouds)
{
  for (const double radius : { -1.0, dgg::Infinity, std::numeric_limits<double>::quiet_NaN() })
  {
    GraphWorld world = CornerWorld();
    world.Radii[1] = radius; // before the checksum is computed
    ExpectRefused(
      world, *world.Surface, [](Arrays&) {}, "the radius of point 1 in DGG.Radii is ");
  }
  const GraphWorld world = CornerWorld();
  ExpectRefused(
    world, *Prepare(Plane(1, 1)), [](Arrays&) {}, "is that of a point cloud", false);
}
}
