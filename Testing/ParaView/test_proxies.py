# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every class has a proxy with documentation, and with the properties and defaults of the class;
every proxy updates."""

import re
import tempfile

import numpy as np
import support
from paraview import servermanager as sm
from support import simple, unittest
from vtkmodules.vtkFiltersSources import vtkPolyLineSource

# Setters without a property, besides names of arrays: ParaView cannot pass a NaN, and shows
# a matrix as a table.
WITHOUT_PROPERTY = {"UnreachedValue", "OutputPointsPrecision", "GenerateTable"}
# Handles may be far from the surface. ParaView always sets the
# accuracy of graphs that are built, so that a warning about a coarser graph would be meaningless.
# Points are visible in the default representation, as with ParaView's own filters of clouds.
OTHER_DEFAULTS = {
    "ProjectionTolerance": ("0.01", "1"),
    "AcceptCoarserGraph": ("Off", "On"),
    "GenerateVertices": ("Off", "On"),
    "Accuracy has been set": ("no", "yes"),
}


def modules():
    """Returns the folders of the modules that are built."""
    folders = ["Filters/Geodesic", "Filters/Spectral", "Readers"]
    if support.os.environ["DGG_WITH_PCL"] == "ON":
        folders.append("Filters/PointCloud")
    return [support.REPOSITORY / folder for folder in folders]


def headers():
    """Returns name and header of each concrete class, as CMake lists them."""
    found = {}
    for folder in modules():
        listed = re.search(r"set\(classes(.*?)\)", (folder / "CMakeLists.txt").read_text(), re.S)
        for name in listed[1].split():
            text = (folder / f"{name}.h").read_text()
            if "vtkAbstractTypeMacro" not in text:
                found[name] = text
    return found


def setters(header):
    """Returns the properties of a class that are one number or a name."""
    names = re.findall(r"vtk(?:DGG)?Set(?:Clamp|Number|FilePath)?Macro\((\w+)", header)
    return set(names + re.findall(r"vtkDGGStringMacro\((\w+)", header)) - {"Ids"}


def properties(proxy):
    """Returns the properties of a proxy by name."""
    iterator = proxy.NewPropertyIterator()
    found = {}
    while not iterator.IsAtEnd():
        found[iterator.GetKey()] = iterator.GetProperty()
        iterator.Next()
    return found


def state(proxy):
    """Returns the lines that the object of a proxy prints."""
    text = str(proxy.GetClientSideObject())
    return text[text.index("Progress Text") :].splitlines()[1:]


class Proxies(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.pxm = sm.ProxyManager()
        cls.headers = headers()
        cls.definitions = {}
        for group in ("sources", "filters", "writers"):
            iterator = cls.pxm.NewDefinitionIterator(group)
            while not iterator.IsDoneWithTraversal():
                xml = iterator.GetProxyDefinition()
                kind = xml.GetAttribute("class")
                if kind in cls.headers:
                    cls.definitions[kind] = (group, xml.GetAttribute("name"))
                iterator.GoToNextItem()

    def prototype(self, kind):
        return self.pxm.GetPrototypeProxy(*self.definitions[kind])

    def test_every_class_has_a_proxy(self):
        self.assertEqual(set(self.headers), set(self.definitions))
        self.assertGreater(len(self.headers), 15)

    def test_menus_and_icons(self):
        for kind, (group, _) in self.definitions.items():
            if group != "filters":
                continue
            menu = self.prototype(kind).GetHints().FindNestedElementByName("ShowInMenu")
            self.assertEqual(menu.GetAttribute("category"), "Geodesics", kind)
            self.assertEqual(menu.GetAttribute("show_in_toolbar"), "1", kind)
            icon = menu.GetAttribute("icon")
            self.assertTrue(icon and icon.startswith(":/Geodesics/"), kind)
            path = support.REPOSITORY / "Wrapping/ParaView/Geodesics/Icons" / icon.split("/")[-1]
            self.assertTrue(path.is_file(), path)

    def test_documentation(self):
        for kind in self.definitions:
            proxy = self.prototype(kind)
            documentation = proxy.GetDocumentation()
            self.assertTrue(documentation.GetShortHelp(), kind)
            self.assertGreater(len(documentation.GetDescription()), 40, kind)
            for name, prop in properties(proxy).items():
                text = prop.GetDocumentation()
                if prop.GetPanelVisibility() != "never":
                    self.assertTrue(text and len(text.GetDescription()) > 5, f"{kind}: {name}")

    def test_every_setter_has_a_property(self):
        bases = {
            name: (support.REPOSITORY / f"Filters/{folder}/{name}.h").read_text()
            for folder, name in (
                ("Geodesic", "vtkGeodesicAlgorithm"),
                ("Geodesic", "vtkGeodesicDistanceAlgorithm"),
                ("Spectral", "vtkSpectralAlgorithm"),
            )
        }
        for kind, header in self.headers.items():
            wanted = setters(header)
            base = re.search(rf"class \w+ {kind}\s+: public (\w+)", header)[1]
            while base in bases:
                wanted |= setters(bases[base])
                base = re.search(rf"class \w+ {base}\s+: public (\w+)", bases[base])[1]
            if "vtkDGGGraphPropertiesMacro" in header:
                wanted |= {"Accuracy", "AcceptCoarserGraph"}
            commands = {p.GetCommand() for p in properties(self.prototype(kind)).values()}
            wanted = {n for n in wanted - WITHOUT_PROPERTY if not n.endswith("ArrayName")}
            missing = {n for n in wanted if "Set" + n not in commands}
            self.assertFalse(missing, kind)

    def test_defaults_are_those_of_the_classes(self):
        xml = "".join(
            f'<SourceProxy class="{kind}" name="Plain{kind}" />' for kind in self.definitions
        )
        with tempfile.NamedTemporaryFile("w", suffix=".xml") as file:
            file.write("<ServerManagerConfiguration><ProxyGroup name='plain'>")
            file.write(f"{xml}</ProxyGroup></ServerManagerConfiguration>")
            file.flush()
            simple.LoadPlugin(file.name, remote=False)
        for kind, (group, name) in self.definitions.items():
            plain = self.pxm.NewProxy("plain", f"Plain{kind}")
            proxy = self.pxm.NewProxy(group, name)
            for p in (plain, proxy):
                p.UpdateVTKObjects()
            lines = state(proxy)
            self.assertGreater(len(lines), 1, kind)
            for line, expected in zip(lines, state(plain), strict=True):
                label, _, value = expected.strip().partition(": ")
                if label in ("Modified Time", "Reference Count"):
                    continue
                theirs, ours = OTHER_DEFAULTS.get(label, (value, value))
                self.assertEqual(value, theirs, kind)
                wanted = f"{label}: {ours}" if value else expected.strip()
                self.assertEqual(line.strip(), wanted, kind)

    def test_setting_a_property_reaches_the_object(self):
        for kind, (group, name) in self.definitions.items():
            proxy = self.pxm.NewProxy(group, name)
            proxy.UpdateVTKObjects()
            for key, prop in properties(proxy).items():
                if not prop.GetCommand() or prop.GetCommand().endswith("Connection"):
                    continue
                if prop.GetCommand() == "SetInputArrayToProcess":
                    continue  # not printed; tested with the isolines of a session
                before = state(proxy)
                if prop.IsA("vtkSMStringVectorProperty"):
                    prop.SetElement(0, "Something")
                elif prop.IsA("vtkSMIdTypeVectorProperty") and prop.GetRepeatCommand():
                    prop.SetNumberOfElements(1)
                    prop.SetElement(0, 3)
                elif prop.IsA("vtkSMDoubleVectorProperty"):
                    old = prop.GetElement(0) if prop.GetNumberOfElements() else 0.0
                    prop.SetElement(0, 0.5 * old + 0.03)
                else:
                    old = prop.GetElement(0)
                    choices = prop.FindDomain("vtkSMEnumerationDomain")
                    if choices:
                        entries = range(choices.GetNumberOfEntries())
                        new = next(v for v in map(choices.GetEntryValue, entries) if v != old)
                    else:
                        new = 0 if old and prop.FindDomain("vtkSMBooleanDomain") else old + 1
                    prop.SetElement(0, new)
                proxy.UpdateVTKObjects()
                self.assertTrue(state(proxy) != before, f"{kind}: {key}")


class Updates(unittest.TestCase):
    """Updates each filter with minimal input."""

    def setUp(self):
        self.mesh = support.bumpy()
        self.mesh.UpdatePipeline()  # handles start within the bounds of the input

    def run_one(self, proxy, ports=(0,)):
        proxy.UpdatePipeline()
        filter_ = proxy.SMProxy.GetClientSideObject()
        self.assertEqual(filter_.GetErrorCode(), 0, proxy.SMProxy.GetXMLName())
        for port in ports:
            data = support.fetch(proxy, port)
            size = data.GetNumberOfElements(0) + data.GetNumberOfElements(6)
            self.assertGreater(size, 0, (proxy.SMProxy.GetXMLName(), port))
        return proxy

    def test_distances(self):
        exact = support.array(
            self.run_one(simple.ExactGeodesicDistance(Input=self.mesh)), "GeodesicDistance"
        )
        self.assertGreater(exact.max(), 2.0)
        bounds = {
            simple.GeodesicDistance: 0.01,
            simple.InstantGeodesicDistance: 0.1,
            simple.HeatGeodesicDistance: 0.3,
            simple.FastMarchingDistance: 0.1,
        }
        for make, bound in bounds.items():
            found = support.array(self.run_one(make(Input=self.mesh)), "GeodesicDistance")
            self.assertLess(np.abs(found - exact).max(), bound * exact.max(), make.__name__)

    def test_graphs(self):
        graph = self.run_one(
            simple.GeodesicGraph(Input=self.mesh, GenerateGraphLines=1), ports=(0, 1)
        )
        distance = self.run_one(simple.GeodesicDistance(Input=graph))
        self.assertIsNotNone(support.fetch(distance).GetFieldData().GetArray("DGG.Targets"))
        self.run_one(simple.GeodesicPath(Input=graph))
        loop = simple.GeodesicLoop(Input=graph, Mode="Rope", Points="Several points")
        loop.Points.Points = [1.1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0]
        self.run_one(loop)
        samples = self.run_one(simple.GeodesicSampler(Input=graph, NumberOfSamples=9))
        cells = simple.GeodesicVoronoiCells(Input=graph, Sites=samples)
        self.run_one(cells, ports=(0, 1, 2, 3))
        matrix = self.run_one(simple.GeodesicDistanceMatrix(Input=graph, Rows=samples))
        self.assertEqual(support.fetch(matrix).GetNumberOfRows(), 9)

    def test_what_is_made_of_distances(self):
        distance = simple.ExactGeodesicDistance(Input=self.mesh, GenerateWindows=1)
        lines = simple.GeodesicIsolines(Input=distance, GenerateRidges=1, GenerateBands=1)
        lines.Distances = [0.5, 1.0]
        self.run_one(lines, ports=(0, 1, 2))
        places = simple.GeodesicSampler(Input=self.mesh, NumberOfSamples=7)
        probe = self.run_one(simple.GeodesicProbe(Input=distance, Places=places))
        self.assertEqual(support.fetch(probe).GetNumberOfPoints(), 7)

    def test_two_surfaces(self):
        other = simple.Transform(Input=self.mesh)
        other.Transform.Rotate = [0, 0, 30]
        samples = simple.GeodesicSampler(Input=self.mesh, NumberOfSamples=5)
        moved = simple.Transform(Input=samples)
        moved.Transform.Rotate = [0, 0, 30]
        lines = vtkPolyLineSource()
        lines.SetNumberOfPoints(5)
        lines.Update()
        layout = simple.TrivialProducer()
        layout.SMProxy.GetClientSideObject().SetOutput(lines.GetOutput())
        curves = simple.GeodesicPatchBoundaries(
            Input=self.mesh,
            SecondSurface=other,
            FirstLandmarks=samples,
            SecondLandmarks=moved,
            Layout=layout,
        )
        self.run_one(curves, ports=(0, 1))

    def test_laplacian(self):
        green = self.run_one(simple.GreensFunction(Input=self.mesh))
        self.assertIsNotNone(support.fetch(green).GetPointData().GetArray("GreensFunction"))
        self.run_one(simple.BiharmonicDistance(Input=self.mesh, NumberOfEigenvalues=20))
        self.run_one(simple.HarmonicBSpline(Input=self.mesh))
        sites = simple.GeodesicSampler(Input=self.mesh, NumberOfSamples=7)
        sites = simple.Calculator(Input=sites, ResultArrayName="Height", Function="coordsZ")
        spline = self.run_one(
            simple.HarmonicBSpline(
                Input=self.mesh, Source=sites, Order="Biharmonic", SiteValuesArrayName="Height"
            )
        )
        self.assertIsNotNone(support.fetch(spline).GetPointData().GetArray("Interpolation"))
        mass = simple.Calculator(Input=self.mesh, ResultArrayName="From", Function="coordsX+2")
        mass = simple.Calculator(Input=mass, ResultArrayName="To", Function="coordsY+2")
        self.run_one(
            simple.EarthMoversDistance(Input=mass, FromArrayName="From", ToArrayName="To")
        )

    def test_vector_graphics(self):
        loop = simple.GeodesicLoop(Input=self.mesh)
        colors = simple.ProgrammableFilter(
            Input=loop,
            Script="""
import numpy as np
n = output.GetNumberOfCells()
for name, color in (("LeftColor", (1, 0, 0)), ("RightColor", (0, 0, 1))):
    output.CellData.append(np.tile(np.array(color, float), (n, 1)), name)
""",
        )
        graphics = simple.PoissonVectorGraphics(Input=self.mesh, Curves=colors)
        self.run_one(graphics)

    @unittest.skipUnless(support.IS_COMPILED, "readers are compiled classes")
    def test_files(self):
        off = simple.OpenDataFile(str(support.DATA / "tetrahedron.off"))
        self.assertEqual(support.fetch(off).GetNumberOfPoints(), 4)
        if support.os.environ["DGG_WITH_PCL"] != "ON":
            return
        name = str(support.OUTPUT / "plugin.pcd")
        simple.SaveData(name, proxy=self.mesh)
        cloud = simple.OpenDataFile(name)
        np.testing.assert_allclose(support.points(cloud), support.points(self.mesh), rtol=1e-6)
        graph = self.run_one(simple.PointCloudGraph(Input=cloud))
        self.run_one(simple.GeodesicDistance(Input=graph))

    def test_points_without_cells_can_be_seen(self):
        if support.os.environ["DGG_WITH_PCL"] != "ON":
            return
        points = simple.MaskPoints(Input=self.mesh, OnRatio=1, MaximumNumberofPoints=10000)
        self.assertEqual(support.fetch(points).GetNumberOfCells(), 0)
        distance = simple.GeodesicDistance(Input=simple.PointCloudGraph(Input=points))
        output = support.fetch(distance)
        self.assertEqual(output.GetNumberOfVerts(), 1)
        self.assertEqual(output.GetCell(0).GetNumberOfPoints(), output.GetNumberOfPoints())


if __name__ == "__main__":
    support.main()
