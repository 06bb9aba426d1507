# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin's proxies work, and say of their properties what the classes do.

    pvbatch TestPlugin.py PLUGIN.so SURFACE.off
"""
import glob
import os
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

from paraview import servermanager, simple, smtrace
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringArray, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import VTK_WEDGE
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import insideout
from insideout.pipeline import statistics_of

PLUGIN, SURFACE = sys.argv[1:3]
simple.LoadPlugin(PLUGIN, remote=False, ns=vars(simple))

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Plugin")
"""Where the files are that tell ParaView of the filters."""

FILTERS = [
    proxy.get("name")
    for file in sorted(glob.glob(os.path.join(FOLDER, "*.xml")))
    for proxy in ElementTree.parse(file).iterfind("ProxyGroup[@name='filters']/SourceProxy")
    if hasattr(insideout, proxy.get("class"))
]

NAMES_IN_STATES = {"Surface": "SurfaceTreatment"}  # of what has another name in the class
NO_OPTIONS = ("ExtractInside", "Summary", "ShownSummary", "ObjectName", *(stage + "ObjectName" for stage in ("Refinement", "Segmentation", "WindingNumber")))


def volume(proxy, port=0):
    """The summed volume of the cells that a filter gives."""
    sizes = simple.CellSize(Input=servermanager.OutputPort(proxy, port))
    data = servermanager.Fetch(sizes)
    array = data.GetCellData().GetArray("Volume")
    return sum(array.GetValue(i) for i in range(array.GetNumberOfTuples()))


def volumes_of_blocks(proxy):
    """The same for each block."""
    data = servermanager.Fetch(simple.CellSize(Input=proxy))
    iterator = data.NewIterator()
    while not iterator.IsDoneWithTraversal():
        array = iterator.GetCurrentDataObject().GetCellData().GetArray("Volume")
        yield sum(array.GetValue(i) for i in range(array.GetNumberOfTuples()))
        iterator.GoToNextItem()


def messages_of(work):
    """The errors and warnings of some work, in full."""
    window, before = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    try:
        work()
    finally:
        vtkOutputWindow.SetInstance(before)
    return window.GetOutput()


def names_of_tags(solid):
    names = servermanager.Fetch(solid, idx=1).GetFieldData().GetAbstractArray("BoundaryTagNames")
    return [names.GetValue(i) for i in range(names.GetNumberOfValues())]


class TestPlugin(unittest.TestCase):
    def setUp(self):
        self.surface = simple.SurfaceReader(FileName=SURFACE)

    def test_the_filter_gives_solid_boundary_and_outliers(self):
        solid = simple.RobustTetrahedralize(Input=self.surface)
        solid.UpdatePipeline()
        self.assertAlmostEqual(volume(solid), 1.75, 12)
        self.assertEqual(solid.CellData["w"].GetNumberOfComponents(), 1)
        boundary = servermanager.Fetch(solid, idx=1)
        self.assertEqual(boundary.GetClassName(), "vtkPolyData")
        self.assertGreater(boundary.GetNumberOfCells(), 0)
        outliers = servermanager.Fetch(solid, idx=2)
        self.assertEqual(outliers.GetNumberOfCells(), 0)

    def test_a_solid_is_refined_by_either_filter(self):
        asked = dict(EdgeLength=0.2, QuadraticCells=1)
        within = simple.RobustTetrahedralize(Input=self.surface, Refine=1, **asked)
        after = simple.RefineTetrahedra(Input=simple.RobustTetrahedralize(Input=self.surface), **asked)
        for proxy in (within, after):
            proxy.UpdatePipeline()
            self.assertAlmostEqual(volume(proxy), 1.75, 12)
        counts = [proxy.GetDataInformation().GetNumberOfCells() for proxy in (within, after)]
        self.assertEqual(*counts)
        self.assertGreater(counts[0], 500)

    def test_layers_are_put_behind_the_whole_boundary_or_behind_tags(self):
        solid = simple.RobustTetrahedralize(Input=self.surface, Refine=1, EdgeLength=0.2)
        tag = names_of_tags(solid)[0]
        for boundary, tags in ((None, ""), (servermanager.OutputPort(solid, 1), tag)):
            layers = simple.BoundaryLayers(Input=solid, Boundary=boundary, Layers=2, FirstHeight=0.01, LayerTags=tags)
            layers.UpdatePipeline()
            self.assertEqual(layers.CellData["Layer"].GetRange(), (0, 2))
            self.assertAlmostEqual(volume(layers), 1.75, 3)  # quads that are not planar are cut
            grid = servermanager.Fetch(layers, idx=0)
            prisms = sum(grid.GetCellType(c) == VTK_WEDGE for c in range(grid.GetNumberOfCells()))
            self.assertGreater(prisms, 0)
            self.assertEqual(prisms, statistics_of(grid)["Prisms"])
            self.assertEqual(servermanager.Fetch(layers, idx=1).GetNumberOfCells() > 0, bool(boundary))

    def test_the_stages_chain(self):
        resolved = simple.ResolveSelfIntersections(Input=self.surface)
        hull = simple.ConstrainedDelaunay3D(Input=resolved)
        hull.UpdatePipeline()
        w = simple.GeneralizedWindingNumber(Input=self.surface)
        solid = simple.GraphCutSegmentation(Input=w)
        solid.UpdatePipeline()
        self.assertAlmostEqual(volume(hull), volume(w), 12)
        self.assertAlmostEqual(volume(solid), 1.75, 12)

    def test_defects_are_marked_and_drawn(self):
        defects = simple.SurfaceDefects(Input=self.surface)
        surface = servermanager.Fetch(defects, idx=0)
        lines = servermanager.Fetch(defects, idx=1)
        self.assertEqual(surface.GetCellData().GetArray("ComponentId").GetRange(), (0, 1))
        self.assertEqual(surface.GetCellData().GetArray("SelfIntersections").GetRange()[0], 0)
        self.assertEqual(lines.GetCellData().GetArray("DefectType").GetRange(), (3, 3))
        self.assertGreater(lines.GetNumberOfCells(), 0)

    def test_the_quality_of_tetrahedra_is_measured(self):
        quality = simple.SolidQuality(Input=simple.RobustTetrahedralize(Input=self.surface))
        quality.UpdatePipeline()
        least, largest = quality.CellData["MinDihedralAngle"].GetRange()
        self.assertTrue(0 < least <= largest <= 70.53, (least, largest))
        self.assertEqual(statistics_of(servermanager.Fetch(quality))["MinDihedralAngle"], least)
        self.assertEqual(quality.FieldData["DihedralAngleHistogram"].GetNumberOfTuples(), 36)

    def test_defects_are_shown_in_their_own_colors(self):
        definitions = servermanager.ProxyManager()
        geometry = definitions.NewProxy("representations", "SurfaceDefectsGeometry")
        array = geometry.GetProperty("ColorArrayName")
        self.assertEqual([array.GetElement(i) for i in (3, 4)], ["1", "DefectColor"])
        self.assertEqual(geometry.GetProperty("MapScalars").GetElement(0), 0)

        defects = simple.SurfaceDefects(Input=self.surface)
        view = simple.CreateView("RenderView")
        for port in (0, 1):
            shown = simple.Show(servermanager.OutputPort(defects, port), view)
            self.assertEqual(shown.GetXMLName(), "SurfaceDefectsRepresentation")
            self.assertEqual(shown.Representation, "Defect Colors")
            self.assertEqual((shown.LineWidth, shown.RenderLinesAsTubes), (4, 1))
        simple.Delete(view)

    def test_the_probe_marks_the_points_inside(self):
        sphere = simple.Sphere(Radius=0.01, Center=[0.5, 0.5, 0.5])
        probe = simple.ProbeWindingNumber(Input=sphere, Surface=self.surface)
        probe.UpdatePipeline()
        self.assertEqual(probe.PointData["Inside"].GetRange(), (1, 1))
        probe.InsideOut = 1
        probe.UpdatePipeline()
        self.assertEqual(probe.PointData["Inside"].GetRange(), (0, 0))

    def test_an_expression_of_several_inputs(self):
        box, hole = simple.Box(), simple.Box(XLength=0.5, YLength=0.5, ZLength=2)
        left = simple.WindingBoolean(Input=[box, hole], Expression="A - B")
        left.UpdatePipeline()
        self.assertAlmostEqual(statistics_of(servermanager.Fetch(left))["Volume"], 0.75, 12)
        self.assertEqual(left.CellData["BodyId"].GetRange(), (0, 1))
        left.Tetrahedra = 1
        self.assertAlmostEqual(volume(left, 1), 0.75, 12)

    def test_a_property_changes_the_result(self):
        solid = simple.RobustTetrahedralize(Input=self.surface)
        self.assertAlmostEqual(volume(solid), 1.75, 12)
        solid.Orientation = "Reverse"  # of a stage
        self.assertEqual(volume(solid), 0)
        solid.Orientation, solid.GenerateHull = "Automatic", 1
        self.assertAlmostEqual(volume(solid), 1.75, 12)
        self.assertAlmostEqual(volume(solid, 3), 2, 12)

    def test_messages_begin_with_the_label_of_the_filter(self):
        """Also those of stages; and no state has these names."""
        solid = simple.RobustTetrahedralize(Input=self.surface)

        def set_and_update(**options):
            simple.SetProperties(solid, **options)
            solid.UpdatePipeline()

        told = messages_of(lambda: set_and_update(Gamma=-3))
        self.assertIn(": Robust Tetrahedralize: Gamma is -3, but must be at least 0: it is taken as 0\n", told)
        self.assertIn(": Robust Tetrahedralize: nothing is inside", messages_of(lambda: set_and_update(Orientation="Reverse")))
        reader = simple.SurfaceReader(FileName="/nowhere.off")
        self.assertIn(": Surface Reader: ", messages_of(reader.UpdatePipeline))
        writing = messages_of(lambda: simple.SaveData("/nowhere/solid.msh", proxy=solid))
        self.assertIn(": Gmsh Writer: ", writing)
        simple.Delete(reader)

    def test_options_of_stages_are_in_states_which_may_be_of_before(self):
        simple.ResetSession()
        surface = simple.SurfaceReader(FileName=SURFACE)
        simple.RobustTetrahedralize(Input=surface, Gamma=0.5, Topology="One Component").UpdatePipeline()
        with tempfile.TemporaryDirectory() as folder:
            state = os.path.join(folder, "state.pvsm")
            simple.SaveState(state)
            with open(state, encoding="utf-8") as file:
                text = file.read()
            begin = text.index('<Property name="ExtractInside"')
            before = text[:begin] + text[begin:].replace('value="1"', 'value="0"', 1)
            for content, hull in ((text, 0), (before, 1)):
                simple.ResetSession()
                with open(state, "w", encoding="utf-8") as file:
                    file.write(content)
                simple.LoadState(state)
                loaded = next(one for (name, _), one in simple.GetSources().items() if name.startswith("RobustTetrahedralize"))
                loaded.UpdatePipeline()
                self.assertEqual((loaded.Gamma, loaded.Topology), (0.5, "One Component"))
                self.assertEqual(volume(loaded, 3) > 0, bool(hull))
            simple.ResetSession()

    def test_outlines_become_triangles(self):
        outline = simple.Disk(InnerRadius=0.5, OuterRadius=1, CircumferentialResolution=6)
        triangles = simple.RobustTriangulate(Input=simple.FeatureEdges(Input=outline, ManifoldEdges=0), GenerateHull=1)
        triangles.UpdatePipeline()
        solid, hull, lines = (servermanager.Fetch(triangles, idx=port) for port in (0, 3, 4))
        self.assertGreater(solid.GetNumberOfCells(), 0)
        self.assertGreater(hull.GetNumberOfCells(), solid.GetNumberOfCells())
        self.assertEqual(lines.GetNumberOfPoints(), 12)
        coarse = solid.GetNumberOfCells()
        triangles.Refine, triangles.EdgeLength, triangles.Surface = 1, 0.1, "Split"
        triangles.UpdatePipeline()
        self.assertGreater(triangles.GetDataInformation().GetNumberOfCells(), 10 * coarse)

    def test_the_reader_is_offered_but_the_default_for_off_alone(self):
        session = servermanager.ActiveConnection.Session
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
        factory.UpdateAvailableReaders()
        with tempfile.TemporaryDirectory() as folder:
            for ending, start in {"off": "OFF", "obj": "v", "ply": "ply", "stl": "solid"}.items():
                file = os.path.join(folder, "any." + ending)
                with open(file, "w", encoding="utf-8") as stream:
                    stream.write(start + "\n")
                readers = factory.GetReaders(file, session)
                names = [readers.GetString(i) for i in range(1, readers.GetLength(), 3)]
                self.assertEqual(len(names), 1, names)  # of several ParaView would ask which
                self.assertEqual(names == ["SurfaceReader"], ending == "off", names)
            for ending in ("OFF", "off.gz", "obj.gz", "ply.gz", "stl.gz", "STL.GZ"):
                file = os.path.join(folder, "any." + ending)
                with open(file, "w", encoding="utf-8") as stream:
                    stream.write("anything\n")
                readers = factory.GetReaders(file, session)
                self.assertIn("SurfaceReader", [readers.GetString(i) for i in range(1, readers.GetLength(), 3)])
        self.assertIn("Surface in Full Precision (Inside Out)", factory.GetSupportedFileTypes(session))

    def test_a_solid_is_saved_for_solvers(self):
        solid = simple.RobustTetrahedralize(Input=self.surface)
        boundary = servermanager.OutputPort(solid, 1)
        tagged = simple.Calculator(Input=boundary, AttributeType="Cell Data", ResultArrayName="BoundaryTag", Function="3")
        with tempfile.TemporaryDirectory() as folder:
            def saved(name, **options):
                path = os.path.join(folder, name)
                simple.SaveData(path, **options)
                with open(path, encoding="utf-8") as file:
                    return file.read()

            for ending, begin in (("msh", "$MeshFormat\n4.1 0 8"), ("inp", "** Written by InsideOut"), ("mesh", "MeshVersionFormatted 2")):
                self.assertTrue(saved("solid." + ending, proxy=solid).startswith(begin), ending)
            self.assertIn('2 1 "surface"', saved("alone.msh", proxy=solid))
            self.assertTrue(saved("old.msh", proxy=solid, MshVersion="2.2").startswith("$MeshFormat\n2.2 0 8"))
            group = simple.GroupDatasets(Input=[solid, tagged])
            self.assertIn('2 4 "tag_3"', saved("group.msh", proxy=group))
            self.assertIn('2 4 "tag_3"', saved("both.msh", proxy=solid, Boundary=tagged))
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
        formats = [f"{name} (Inside Out)(*.{ending} )" for name, ending in
                   (("Gmsh Mesh", "msh"), ("Abaqus and CalculiX Input", "inp"), ("Medit Mesh", "mesh"))]
        for proxy, port, offered in ((solid, 0, True), (group, 0, True), (solid, 1, False)):
            types = factory.GetSupportedFileTypes(proxy.SMProxy, port)
            self.assertEqual([one in types for one in formats], [offered] * 3, types)
        for ending, asked in (("msh", True), ("inp", False), ("mesh", False)):
            writer = factory.CreateWriter("solid." + ending, solid.SMProxy, 0)
            self.assertEqual(writer.GetProperty("MshVersion") is not None, asked, ending)
            self.assertIn("." + ending, writer.GetDocumentation().GetDescription())

    def test_and_opened_again_with_its_boundary(self):
        solid = simple.RobustTetrahedralize(Input=self.surface)
        solid.UpdatePipeline()
        session = servermanager.ActiveConnection.Session
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
        factory.UpdateAvailableReaders()
        with tempfile.TemporaryDirectory() as folder:
            for ending in ("msh", "inp", "mesh"):
                path = os.path.join(folder, "solid." + ending)
                simple.SaveData(path, proxy=solid)
                readers = factory.GetReaders(path, session)
                self.assertIn("SolidReader", [readers.GetString(i) for i in range(1, readers.GetLength(), 3)], ending)
                reader = simple.SolidReader(FileName=path)
                reader.UpdatePipeline()
                self.assertEqual(reader.GetDataInformation().GetNumberOfCells(), solid.GetDataInformation().GetNumberOfCells())
                boundary = reader.GetDataInformation(1)
                self.assertEqual(boundary.GetNumberOfCells(), solid.GetDataInformation(1).GetNumberOfCells())
                self.assertIsNotNone(boundary.GetCellDataInformation().GetArrayInformation("BoundaryTag"))
                self.assertTrue(reader.FieldData.keys() == ["RegionNames"], ending)

    def test_statistics_are_among_the_information(self):
        """ParaView shows no field data whose first array is empty."""
        resolved = simple.ResolveSelfIntersections(Input=self.surface)
        w = simple.GeneralizedWindingNumber(Input=self.surface)
        for one in (simple.RobustTetrahedralize(Input=self.surface), simple.SurfaceDefects(Input=self.surface), resolved,
                    simple.ConstrainedDelaunay3D(Input=resolved), w, simple.GraphCutSegmentation(Input=w),
                    simple.SolidQuality(Input=w)):
            one.UpdatePipeline()
            self.assertTrue({"Statistics", "StatisticsNames"} <= set(one.FieldData.keys()), one)

    def test_a_trace_can_be_replayed(self):
        smtrace.start_trace()
        simple.RobustTetrahedralize(Input=self.surface, registrationName="traced", Gamma=0.25)
        simple.SliceWindingNumber(Input=simple.FindSource("traced"), registrationName="slice of it")
        text = smtrace.stop_trace()
        for name in ("slice of it", "traced"):
            simple.Delete(simple.FindSource(name))
        exec(compile(text, "trace", "exec"), {})
        self.assertEqual(simple.FindSource("traced").Gamma, 0.25)
        simple.FindSource("slice of it").SliceType.Origin = [0.7, 0.7, 0.4]
        simple.FindSource("slice of it").UpdatePipeline()
        self.assertIn("w", simple.FindSource("slice of it").CellData.keys())

    def test_points_with_normals_are_a_surface(self):
        sphere = simple.Sphere(ThetaResolution=40, PhiResolution=40)
        cloud = simple.MaskPoints(Input=sphere, OnRatio=1, MaximumNumberofPoints=5000, GenerateVertices=1)
        places = simple.Wavelet(WholeExtent=[-1, 1] * 3)  # the center, and 26 places outside
        probe = simple.ProbeWindingNumber(Input=places, Surface=cloud)
        probe.UpdatePipeline()
        inside = servermanager.Fetch(probe).GetPointData().GetArray("Inside")
        self.assertEqual([i for i in range(27) if inside.GetValue(i)], [13])

    def test_arrays_are_chosen_from_those_that_fit(self):
        """Cell arrays of one number per cell, and none."""
        marked = self.surface
        for name, association, formula in (
            ("chosen", "Cell Data", "1"), ("of points", "Point Data", "1"), ("vector", "Cell Data", "iHat")
        ):
            marked = simple.Calculator(Input=marked, AttributeType=association, ResultArrayName=name, Function=formula)
        marked.UpdatePipeline()
        seen = []
        for name in FILTERS:
            surface = "Surface" if name == "ProbeWindingNumber" else "Input"
            proxy = servermanager.ProxyManager().NewProxy("filters", name)
            properties = proxy.NewPropertyIterator()
            properties.Begin()
            while not properties.IsAtEnd():
                key, prop = properties.GetKey(), properties.GetProperty()
                properties.Next()
                # One may be the background's alone, one is of points, and is typed.
                if key.endswith("ArrayName") and key not in ("SizingArrayName", "AreaArrayName"):
                    proxy.GetProperty(surface).AddInputConnection(marked.SMProxy, 0)
                    domain = prop.FindDomain("vtkSMArrayListDomain")
                    offered = [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]
                    self.assertEqual(sorted(offered), ["", "chosen"], (name, key))
                    self.assertEqual(prop.GetElement(0), "", "and none of them at first")
                    seen.append((name, key))
        self.assertIn(("RobustTetrahedralize", "ConstrainedFacetsArrayName"), seen)
        self.assertEqual(len(seen), 11)

    def test_tags_are_chosen_among_strings_too(self):
        """And what ParaView's own readers call groups is known."""
        cube, names = vtkCubeSource(), vtkStringArray()
        cube.Update()
        names.SetName("Words")
        for name in ("left", "wall", "wall", "wall", "wall", "right"):
            names.InsertNextValue(name)
        cube.GetOutput().GetCellData().AddArray(names)
        with tempfile.NamedTemporaryFile(suffix=".vtp") as file:
            writer = vtkXMLPolyDataWriter()
            writer.SetFileName(file.name)
            writer.SetInputData(cube.GetOutput())
            writer.Write()
            parts = simple.XMLPolyDataReader(FileName=[file.name])
            parts.UpdatePipeline()
        solid = simple.RobustTetrahedralize(Input=parts)
        domain = solid.GetProperty("TagArrayName").SMProperty.FindDomain("vtkSMArrayListDomain")
        self.assertEqual([domain.GetString(i) for i in range(domain.GetNumberOfStrings())], ["", "Words"])
        solid.TagArrayName = "Words"
        self.assertEqual(names_of_tags(solid), ["left", "wall", "right"])

        with tempfile.NamedTemporaryFile("w", suffix=".obj") as file:
            file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng a\nf 1 3 2\nf 1 2 4\ng b\nf 2 3 4\nf 3 1 4\n")
            file.flush()
            solid = simple.RobustTetrahedralize(Input=simple.WavefrontOBJReader(FileName=file.name))
            self.assertEqual(names_of_tags(solid), ["0", "1"])

    def test_each_block_has_its_solid_and_keeps_its_name(self):
        blocks = simple.GroupDatasets(Input=[self.surface, simple.Box()], BlockNames=["boxes", "box"])
        solid = simple.RobustTetrahedralize(Input=blocks)
        for port in range(3):
            data = servermanager.Fetch(solid, idx=port)
            self.assertEqual(data.GetNumberOfPartitionedDataSets() if data.IsA("vtkPartitionedDataSetCollection") else data.GetNumberOfBlocks(), 2)
            names = [data.GetMetaData(k).Get(data.NAME()) for k in range(2)]
            self.assertEqual(names, ["boxes", "box"])
        self.assertAlmostEqual(sum(volumes_of_blocks(solid)), 2.75, 6)
        solid.UpdatePropertyInformation()
        summary = solid.SMProxy.GetProperty("Summary").GetElement(0)
        self.assertIn("Input Triangles 36, Components 3\nIntersecting Pairs 40\nOpen Edges 0\n", summary)
        self.assertTrue(summary.endswith("\nbounds a solid of volume 2.75"), summary)

    def test_the_verdict_on_a_surface_is_told(self):
        defects = simple.SurfaceDefects(Input=self.surface)
        defects.UpdatePipeline()
        defects.UpdatePropertyInformation()
        self.assertEqual(defects.SMProxy.GetProperty("Summary").GetElement(0), "bounds a solid of volume 1.75")

    def test_time_steps_pass_through(self):
        surface = simple.ExtractSurface(Input=simple.TimeSource(Growing=1))
        solid = simple.RobustTetrahedralize(Input=surface)
        sizes = []
        for time in (0, 0.5):
            solid.UpdatePipeline(time)
            sizes.append(solid.GetDataInformation().GetBounds())
        self.assertNotEqual(*sizes)

    def test_a_probe_follows_its_surface_in_time(self):
        with tempfile.TemporaryDirectory() as folder:
            parts = []
            for step in range(3):
                cube = vtkCubeSource()
                cube.SetBounds(0.5, 1.5 + step, 0.5, 1.5, 0.5, 1.5)
                writer = vtkXMLPolyDataWriter()
                writer.SetInputConnection(cube.GetOutputPort())
                writer.SetDataModeToBinary()
                writer.SetFileName(os.path.join(folder, f"{step}.vtp"))
                writer.Write()
                parts.append(f'<DataSet timestep="{step}" file="{step}.vtp"/>')
            with open(os.path.join(folder, "moving.pvd"), "w", encoding="utf-8") as file:
                file.write(f'<VTKFile type="Collection"><Collection>{"".join(parts)}</Collection></VTKFile>')
            surface = simple.PVDReader(FileName=os.path.join(folder, "moving.pvd"))
            still = simple.Wavelet(WholeExtent=[0, 5, 0, 3, 0, 3])
            for places in (still, simple.GroupDatasets(Input=[still])):
                probe = simple.ProbeWindingNumber(Input=places, Surface=surface)
                for step in (0, 1, 2, 0, 2):
                    probe.UpdatePipeline(step)
                    data = servermanager.Fetch(probe)
                    inside = (data if data.IsA("vtkDataSet") else data.GetBlock(0)).GetPointData().GetArray("Inside")
                    self.assertEqual(sum(inside.GetValue(k) for k in range(inside.GetNumberOfTuples())), 1 + step)

    def test_each_filter_is_in_the_menu_and_has_an_icon_of_its_own(self):
        menu = ElementTree.parse(os.path.join(FOLDER, "InsideOutMenu.xml"))
        filters = [*FILTERS, "SliceWindingNumber"]
        self.assertCountEqual([proxy.get("name") for proxy in menu.iterfind("Category/Proxy")], filters)
        icons = {proxy.get("icon"): proxy.get("name") for proxy in menu.iterfind("Proxy")}
        self.assertCountEqual(icons.values(), filters)
        built = {":/InsideOut/" + file.text for file in ElementTree.parse(os.path.join(FOLDER, "InsideOut.qrc")).iterfind("qresource/file")}
        self.assertLessEqual(set(icons), built)

    def test_defaults_and_documentation_match_the_classes(self):
        for name in FILTERS:
            proxy = servermanager.ProxyManager().NewProxy("filters", name)
            self.assertIsNotNone(proxy, name)
            fresh = getattr(insideout, "vtk" + name)()
            properties = proxy.NewPropertyIterator()
            properties.Begin()
            while not properties.IsAtEnd():
                key, prop = properties.GetKey(), properties.GetProperty()
                properties.Next()
                with self.subTest(filter=name, property=key):
                    self.assertTrue(prop.GetDocumentation().GetDescription().strip())
                    if not isinstance(prop, servermanager.vtkSMInputProperty) and key not in NO_OPTIONS:
                        default = prop.GetElement(0)
                        named = NAMES_IN_STATES.get(key, key)
                        self.assertEqual(default, getattr(insideout.options.owner_of(fresh, named), "Get" + named)())


if __name__ == "__main__":
    program = unittest.main(argv=sys.argv[:1], exit=False)
    sys.exit(not program.result.wasSuccessful())
