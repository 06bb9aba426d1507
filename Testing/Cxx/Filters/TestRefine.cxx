// SPDX-License-Identifier: GPL-3.0-or-later
#include "Statistics.h"
#include "vtkRefineTetrahedra.h"
#include "vtkRobustTetrahedralize.h"

#include <vtkCallbackCommand.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkShortArray.h>
#include <vtkStringArray.h>
#include <vtkTrivialProducer.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
using Place = std::array<double, 3>;
/** A face by the places of its corners, and the region on whose side it is. */
using Side = std::pair<std::set<Place>, int>;

Place PlaceOf(vtkDataSet* data, vtkIdType point)
{
  Place place;
  data->GetPoint(point, place.data());
  return place;
}

/** Something linear, which interpolation gives back. */
double Linear(const Place& p)
{
  return 1 + 2 * p[0] - 3 * p[1] + p[2];
}

template <typename Array>
vtkSmartPointer<Array> MakeArray(const char* name, vtkIdType size, int components = 1)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(size);
  return array;
}

/** Cubes of side 1, `size` along each axis, six tetrahedra each, every third of them turned; and a
 * point in no cell. The lower cubes are of region 3, the upper ones of region -7. */
Grid Cubes(int size)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const int steps[3] = { 1, size + 1, (size + 1) * (size + 1) };
  for (int p = 0; p < (size + 1) * steps[2]; ++p)
  {
    points->InsertNextPoint(p % (size + 1), p / steps[1] % (size + 1), p / steps[2]);
  }
  points->InsertNextPoint(0.1, 0.1, 0.1);
  grid->SetPoints(points);
  vtkNew<vtkIntArray> regions;
  regions->SetName("RegionId");
  vtkNew<vtkIntArray> cubes;
  cubes->SetName("Cube");
  for (int cube = 0; cube < size * size * size; ++cube)
  {
    const int z = cube / (size * size);
    const vtkIdType first = cube % size + cube / size % size * steps[1] + z * steps[2];
    for (int i = 0; i < 3; ++i)
    {
      for (const int j : { (i + 1) % 3, (i + 2) % 3 })
      {
        const bool turned = (j == (i + 1) % 3) != (grid->GetNumberOfCells() % 3 == 0);
        const vtkIdType a = first + steps[i];
        const vtkIdType b = a + steps[j];
        const vtkIdType corners[4] = { first, turned ? b : a, turned ? a : b,
          first + steps[0] + steps[1] + steps[2] };
        grid->InsertNextCell(VTK_TETRA, 4, corners);
        regions->InsertNextValue(2 * z < size ? 3 : -7);
        cubes->InsertNextValue(cube);
      }
    }
  }
  grid->GetCellData()->AddArray(regions);
  grid->GetCellData()->AddArray(cubes);
  return grid;
}

int RegionOf(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  return static_cast<int>(grid->GetCellData()->GetArray("RegionId")->GetTuple1(cell));
}

Side SideOf(vtkUnstructuredGrid* grid, vtkIdType cell, int face)
{
  Side side;
  vtkCell* triangle = grid->GetCell(cell)->GetFace(face);
  for (int k = 0; k < 3; ++k)
  {
    side.first.insert(PlaceOf(grid, triangle->GetPointId(k)));
  }
  side.second = RegionOf(grid, cell);
  return side;
}

/** The faces that have one cell in their region, with that cell and its face. */
std::map<Side, std::pair<vtkIdType, int>> Facets(vtkUnstructuredGrid* grid)
{
  std::map<Side, std::pair<vtkIdType, int>> facets;
  std::map<Side, int> counts;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Side side = SideOf(grid, c, k);
      facets[side] = { c, k };
      ++counts[side];
    }
  }
  for (const auto& [side, count] : counts)
  {
    if (count > 1)
    {
      facets.erase(side);
    }
  }
  return facets;
}

double Volume(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkCell* tetrahedron = grid->GetCell(cell);
  Place x[4];
  for (int k = 0; k < 4; ++k)
  {
    x[k] = PlaceOf(grid, tetrahedron->GetPointId(k));
  }
  const auto d = [&](int k, int i) { return x[k][i] - x[0][i]; };
  return (d(1, 0) * (d(2, 1) * d(3, 2) - d(2, 2) * d(3, 1)) +
           d(1, 1) * (d(2, 2) * d(3, 0) - d(2, 0) * d(3, 2)) +
           d(1, 2) * (d(2, 0) * d(3, 1) - d(2, 1) * d(3, 0))) /
    6;
}

/** A filter with what it says. */
template <typename Filter>
struct Told
{
  explicit Told(vtkDataObject* input)
  {
    this->Command->SetClientData(&this->Said);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* said, void* text)
      { *static_cast<std::string*>(said) += static_cast<const char*>(text); });
    this->Algorithm->AddObserver(vtkCommand::ErrorEvent, this->Command);
    this->Algorithm->AddObserver(vtkCommand::WarningEvent, this->Command);
    this->Silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    this->Algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Silence);
    this->Algorithm->SetInputDataObject(input);
  }

  vtkUnstructuredGrid* Run()
  {
    this->Said.clear();
    this->Algorithm->Update();
    return this->Algorithm->GetOutput();
  }

  double Statistic(const std::string& name) const
  {
    return StatisticOf(this->Algorithm->GetOutput(), name);
  }

  bool Says(const std::string& words) const { return this->Said.find(words) != std::string::npos; }

  std::string Said;
  vtkNew<Filter> Algorithm;

private:
  vtkNew<vtkCallbackCommand> Command;
  vtkNew<vtkCallbackCommand> Silence;
};

using Refine = Told<vtkRefineTetrahedra>;
using Robust = Told<vtkRobustTetrahedralize>;

void ExpectEqual(vtkUnstructuredGrid* one, vtkUnstructuredGrid* other)
{
  ASSERT_EQ(one->GetNumberOfPoints(), other->GetNumberOfPoints());
  ASSERT_EQ(one->GetNumberOfCells(), other->GetNumberOfCells());
  for (vtkIdType p = 0; p < one->GetNumberOfPoints(); ++p)
  {
    ASSERT_EQ(PlaceOf(one, p), PlaceOf(other, p));
  }
  for (vtkIdType c = 0; c < one->GetNumberOfCells(); ++c)
  {
    vtkIdList* corners = one->GetCell(c)->GetPointIds();
    const std::vector<vtkIdType> first(corners->begin(), corners->end());
    corners = other->GetCell(c)->GetPointIds();
    ASSERT_EQ(first, std::vector<vtkIdType>(corners->begin(), corners->end()));
  }
}

/** The lengths of edges whose ends are both new, by their middles. */
std::vector<std::pair<Place, double>> NewEdges(vtkUnstructuredGrid* grid)
{
  vtkDataArray* originals = grid->GetPointData()->GetArray("vtkOriginalPointIds");
  std::set<std::set<vtkIdType>> seen;
  std::vector<std::pair<Place, double>> edges;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    for (int k = 0; k < 6; ++k)
    {
      vtkCell* edge = grid->GetCell(c)->GetEdge(k);
      const vtkIdType ends[2] = { edge->GetPointId(0), edge->GetPointId(1) };
      if (originals->GetTuple1(ends[0]) < 0 && originals->GetTuple1(ends[1]) < 0 &&
        seen.insert({ ends[0], ends[1] }).second)
      {
        const Place a = PlaceOf(grid, ends[0]);
        const Place b = PlaceOf(grid, ends[1]);
        edges.push_back({ { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 },
          std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) });
      }
    }
  }
  return edges;
}

/** The share of them that are within a factor of 1.5 of a wish. */
double ShareAsWished(vtkUnstructuredGrid* grid, const std::function<double(const Place&)>& wish)
{
  const auto edges = NewEdges(grid);
  double good = 0;
  for (const auto& [place, length] : edges)
  {
    const double ratio = length / wish(place);
    good += ratio < 1.5 && ratio > 1 / 1.5;
  }
  return edges.empty() ? 0 : good / static_cast<double>(edges.size());
}

/** The surface of boxes of side 1 that overlap. */
vtkSmartPointer<vtkPolyData> TwoBoxes()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  for (const double low : { 0.0, 0.5 })
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (int i = 0; i < 8; ++i)
    {
      points->InsertNextPoint(low + (i & 1), low + (i >> 1 & 1), low + (i >> 2));
    }
    for (const std::array<vtkIdType, 4>& quad :
      std::vector<std::array<vtkIdType, 4>>{ { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
        { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } })
    {
      quads->InsertNextCell(4);
      for (const vtkIdType corner : quad)
      {
        quads->InsertCellPoint(first + corner);
      }
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(quads);
  return surface;
}
} // namespace

TEST(vtkRefineTetrahedra, KeepsTheFacesOfRegionsAndTheirDataBitByBit)
{
  auto grid = Cubes(4);
  const auto facets = Facets(grid);
  auto ids = MakeArray<vtkIdTypeArray>("FacetIds", grid->GetNumberOfCells(), 4);
  auto multiplicities = MakeArray<vtkShortArray>("FacetMultiplicity", grid->GetNumberOfCells(), 4);
  for (vtkIdType v = 0; v < ids->GetNumberOfValues(); ++v)
  {
    ids->SetValue(v, 1000 + v); // on inner faces too
    multiplicities->SetValue(v, static_cast<short>(v % 5 - 2));
  }
  grid->GetCellData()->AddArray(ids);
  grid->GetCellData()->AddArray(multiplicities);
  Refine refine(grid);
  refine.Algorithm->SetEdgeLength(0.6);
  refine.Algorithm->SetSurfaceTreatment(vtkRefineTetrahedra::KEPT);
  vtkUnstructuredGrid* output = refine.Run();
  EXPECT_NE(refine.Said.find("EdgeLength is 0.6, and edges of the surface, which is kept, are up "
                             "to 1.41 long: SurfaceTreatment split or remeshed"),
    std::string::npos);
  ASSERT_GT(output->GetNumberOfCells(), 2 * grid->GetNumberOfCells());

  auto* outputIds = vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray("FacetIds"));
  auto* outputMultiplicities =
    vtkShortArray::SafeDownCast(output->GetCellData()->GetArray("FacetMultiplicity"));
  ASSERT_TRUE(outputIds && outputMultiplicities);
  std::size_t kept = 0;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const auto found = facets.find(SideOf(output, c, k));
      const bool isKept = found != facets.end();
      kept += isKept;
      const vtkIdType value = isKept ? 4 * found->second.first + found->second.second : 0;
      EXPECT_EQ(outputIds->GetTypedComponent(c, k), isKept ? ids->GetValue(value) : -1);
      EXPECT_EQ(outputMultiplicities->GetTypedComponent(c, k),
        isKept ? multiplicities->GetValue(value) : 0);
    }
  }
  EXPECT_EQ(kept, facets.size());
  EXPECT_EQ(Facets(output).size(), facets.size());
}

TEST(vtkRefineTetrahedra, MixesPointsOfASurfaceOfItsOwnPointsOnly)
{
  // A point in the volume has no number, and what is on the surface has one all the same.
  auto grid = Cubes(2);
  const vtkIdType points = grid->GetNumberOfPoints();
  auto linear = MakeArray<vtkDoubleArray>("Linear", points);
  for (vtkIdType p = 0; p < points; ++p)
  {
    const bool isInside = PlaceOf(grid, p) == Place{ 1, 1, 1 };
    linear->SetValue(p, isInside ? std::nan("") : Linear(PlaceOf(grid, p)));
  }
  grid->GetPointData()->AddArray(linear);
  grid->GetCellData()->RemoveArray("RegionId");
  for (const int surface : { vtkRefineTetrahedra::SPLIT, vtkRefineTetrahedra::REMESHED })
  {
    Refine refine(grid);
    refine.Algorithm->SetEdgeLength(0.3);
    refine.Algorithm->SetSurfaceTreatment(surface);
    vtkUnstructuredGrid* output = refine.Run();
    vtkDataArray* mixed = output->GetPointData()->GetArray("Linear");
    int onSurface = 0;
    for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
    {
      const Place place = PlaceOf(output, p);
      if (std::any_of(place.begin(), place.end(),
            [](double x) { return std::abs(x) < 1e-9 || std::abs(x - 2) < 1e-9; }))
      {
        EXPECT_NEAR(mixed->GetTuple1(p), Linear(place), 1e-6) << p;
        ++onSurface;
      }
    }
    EXPECT_GT(onSurface, 100);
  }
}

TEST(vtkRefineTetrahedra, CarriesTheDataOfPointsAndCells)
{
  auto grid = Cubes(4);
  const vtkIdType points = grid->GetNumberOfPoints();
  auto linear = MakeArray<vtkDoubleArray>("Linear", points);
  auto numbers = MakeArray<vtkIntArray>("Number", points);
  for (vtkIdType p = 0; p < points; ++p)
  {
    linear->SetValue(p, Linear(PlaceOf(grid, p)));
    numbers->SetValue(p, static_cast<int>(p) + 1);
  }
  grid->GetPointData()->AddArray(linear);
  grid->GetPointData()->AddArray(numbers);
  vtkNew<vtkStringArray> field;
  field->SetName("Title");
  field->InsertNextValue("some");
  grid->GetFieldData()->AddArray(field);
  Refine refine(grid);
  refine.Algorithm->SetEdgeLength(0.6);
  refine.Algorithm->SetSurfaceTreatment(vtkRefineTetrahedra::KEPT);
  vtkUnstructuredGrid* output = refine.Run();
  EXPECT_NE(refine.Said.find("EdgeLength is 0.6, and edges of the surface, which is kept, are up "
                             "to 1.41 long: SurfaceTreatment split or remeshed"),
    std::string::npos);

  double volumes[2] = {};
  int clear = 0;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    EXPECT_GT(Volume(output, c), 0);
    volumes[RegionOf(output, c) == 3] += Volume(output, c);
    Place middle = { 0, 0, 0 };
    bool isClear = true;
    for (int i = 0; i < 3; ++i)
    {
      for (int k = 0; k < 4; ++k)
      {
        middle[i] += PlaceOf(output, output->GetCell(c)->GetPointId(k))[i] / 4;
      }
      isClear = isClear && std::abs(middle[i] - std::round(middle[i])) > 1e-9;
    }
    clear += isClear;
    if (isClear)
    {
      const int cube = static_cast<int>(middle[0]) + 4 * static_cast<int>(middle[1]) +
        16 * static_cast<int>(middle[2]);
      EXPECT_EQ(output->GetCellData()->GetArray("Cube")->GetTuple1(c), cube);
    }
  }
  EXPECT_GT(clear, 0.9 * static_cast<double>(output->GetNumberOfCells()));
  EXPECT_NEAR(volumes[0], 32, 1e-12);
  EXPECT_NEAR(volumes[1], 32, 1e-12);

  vtkDataArray* originals = output->GetPointData()->GetArray("vtkOriginalPointIds");
  std::set<vtkIdType> kept;
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const auto original = static_cast<vtkIdType>(originals->GetTuple1(p));
    const Place place = PlaceOf(output, p);
    EXPECT_NEAR(output->GetPointData()->GetArray("Linear")->GetTuple1(p), Linear(place), 1e-12);
    EXPECT_EQ(output->GetPointData()->GetArray("Number")->GetTuple1(p), original + 1);
    if (original >= 0)
    {
      EXPECT_EQ(place, PlaceOf(grid, original));
      kept.insert(original);
    }
  }
  for (vtkIdType p = 0; p < points - 1; ++p) // the last one is in no cell
  {
    const Place place = PlaceOf(grid, p);
    const bool isOnFacet = place[0] == 0 || place[0] == 4 || place[1] == 0 || place[1] == 4 ||
      place[2] == 0 || place[2] == 2 || place[2] == 4;
    EXPECT_TRUE(!isOnFacet || kept.count(p) == 1) << p;
  }
  EXPECT_EQ(kept.count(points - 1), 0u);
  const auto added =
    static_cast<double>(output->GetNumberOfPoints()) - static_cast<double>(kept.size());
  EXPECT_EQ(refine.Statistic("AddedPoints"), added);
  EXPECT_EQ(refine.Statistic("RemovedPoints"),
    static_cast<double>(points) - static_cast<double>(kept.size()));
  EXPECT_EQ(refine.Statistic("RefinedCells"), output->GetNumberOfCells());
  EXPECT_GE(refine.Statistic("SecondsRefine"), 0);
  EXPECT_EQ(refine.Statistic("CellsAboveMaximumVolume"), -1);
  EXPECT_TRUE(output->GetFieldData()->HasArray("Title"));
}

TEST(vtkRefineTetrahedra, KeepsTheOriginalIdsThatItIsGiven)
{
  auto grid = Cubes(2);
  auto ids = MakeArray<vtkIdTypeArray>("vtkOriginalPointIds", grid->GetNumberOfPoints());
  for (vtkIdType p = 0; p < ids->GetNumberOfValues(); ++p)
  {
    ids->SetValue(p, 500 - p);
  }
  grid->GetPointData()->AddArray(ids);
  Refine refine(grid);
  refine.Algorithm->SetEdgeLength(0.3);
  refine.Algorithm->SetSurfaceTreatment(vtkRefineTetrahedra::KEPT);
  vtkUnstructuredGrid* output = refine.Run();
  vtkDataArray* outputIds = output->GetPointData()->GetArray("vtkOriginalPointIds");
  int kept = 0;
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const auto id = static_cast<vtkIdType>(outputIds->GetTuple1(p));
    kept += id >= 0;
    EXPECT_TRUE(id == -1 || PlaceOf(output, p) == PlaceOf(grid, 500 - id));
  }
  EXPECT_GE(kept, 26);
  EXPECT_LT(kept, output->GetNumberOfPoints());
}

TEST(vtkRefineTetrahedra, PutsSharedPointsAmidStraightEdges)
{
  auto grid = Cubes(2);
  auto linear = MakeArray<vtkDoubleArray>("Linear", grid->GetNumberOfPoints());
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    linear->SetValue(p, Linear(PlaceOf(grid, p)));
  }
  grid->GetPointData()->AddArray(linear);
  Refine straight(grid);
  straight.Algorithm->SetEdgeLength(0.4);
  vtkUnstructuredGrid* corners = straight.Run();
  Refine refine(grid);
  refine.Algorithm->SetEdgeLength(0.4);
  refine.Algorithm->QuadraticCellsOn();
  vtkUnstructuredGrid* output = refine.Run();
  ASSERT_EQ(output->GetNumberOfCells(), corners->GetNumberOfCells());
  std::map<std::set<vtkIdType>, vtkIdType> middles;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(output->GetCellType(c), VTK_QUADRATIC_TETRA);
    for (int k = 0; k < 4; ++k)
    {
      EXPECT_EQ(output->GetCell(c)->GetPointId(k), corners->GetCell(c)->GetPointId(k));
    }
    for (int k = 0; k < 6; ++k)
    {
      vtkCell* edge = output->GetCell(c)->GetEdge(k); // two ends and what is between
      const vtkIdType middle = edge->GetPointId(2);
      const auto known =
        middles.insert({ { edge->GetPointId(0), edge->GetPointId(1) }, middle }).first;
      EXPECT_EQ(known->second, middle);
      EXPECT_GE(middle, corners->GetNumberOfPoints());
      const Place a = PlaceOf(output, edge->GetPointId(0));
      const Place b = PlaceOf(output, edge->GetPointId(1));
      for (int i = 0; i < 3; ++i)
      {
        EXPECT_EQ(PlaceOf(output, middle)[i], (a[i] + b[i]) / 2);
      }
    }
  }
  EXPECT_EQ(corners->GetNumberOfPoints() + static_cast<vtkIdType>(middles.size()),
    output->GetNumberOfPoints());
  vtkPointData* data = output->GetPointData();
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    EXPECT_NEAR(data->GetArray("Linear")->GetTuple1(p), Linear(PlaceOf(output, p)), 1e-12);
    EXPECT_TRUE(p < corners->GetNumberOfPoints() ||
      data->GetArray("vtkOriginalPointIds")->GetTuple1(p) == -1);
  }
}

TEST(vtkRefineTetrahedra, MakesEdgesAsLongAsAnArraySays)
{
  auto grid = Cubes(4);
  grid->GetCellData()->RemoveArray("RegionId");
  const auto wish = [](const Place& p) { return 0.3 + 0.1 * p[0]; };
  auto sizes = MakeArray<vtkDoubleArray>("Size", grid->GetNumberOfPoints());
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    sizes->SetValue(p, wish(PlaceOf(grid, p)));
  }
  Refine refine(grid);
  const vtkIdType before = refine.Run()->GetNumberOfCells();
  grid->GetPointData()->AddArray(sizes);
  refine.Algorithm->SetSizingArrayName("Size");
  EXPECT_GT(ShareAsWished(refine.Run(), wish), 0.8);
  EXPECT_EQ(refine.Said, "");

  sizes->Fill(std::numeric_limits<double>::quiet_NaN());
  grid->Modified();
  refine.Algorithm->Modified();
  EXPECT_EQ(refine.Run()->GetNumberOfCells(), before) << "NaN is no wish";
}

TEST(vtkRefineTetrahedra, MakesEdgesAsLongAsABackgroundSaysAndOutsideItAsBefore)
{
  auto grid = Cubes(4);
  grid->GetCellData()->RemoveArray("RegionId");
  // An image that ends in the interior of the cubes.
  vtkNew<vtkImageData> background;
  background->SetOrigin(2, -1, -1);
  background->SetSpacing(1, 2, 2);
  background->SetDimensions(4, 4, 4);
  const auto wish = [](const Place& p) { return 0.2 + 0.05 * p[0]; };
  auto sizes = MakeArray<vtkDoubleArray>("Size", background->GetNumberOfPoints());
  for (vtkIdType p = 0; p < background->GetNumberOfPoints(); ++p)
  {
    sizes->SetValue(p, wish(PlaceOf(background, p)));
  }
  background->GetPointData()->AddArray(sizes);

  Refine refine(grid);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(background);
  refine.Algorithm->SetBackgroundConnection(producer->GetOutputPort());
  refine.Algorithm->SetSizingArrayName("Size");
  refine.Algorithm->SetSurfaceTreatment(vtkRefineTetrahedra::KEPT);
  vtkUnstructuredGrid* output = refine.Run();
  EXPECT_EQ(refine.Said, "");
  int within = 0;
  int good = 0;
  double shortestOutside = 9;
  for (const auto& [place, length] : NewEdges(output))
  {
    if (place[0] > 2.5)
    {
      ++within;
      good += length < 1.5 * wish(place) && length > wish(place) / 1.5;
    }
    else if (place[0] < 1.3)
    {
      shortestOutside = std::min(shortestOutside, length);
    }
  }
  EXPECT_GT(within, 500);
  EXPECT_GT(good, 0.8 * within);
  EXPECT_GT(shortestOutside, 0.35);
}

TEST(vtkRefineTetrahedra, SaysHowManyCellsStayTooLarge)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  for (const Place& place :
    { Place{ 0, 0, 0 }, Place{ 6, 0, 0 }, Place{ 0, 6, 0 }, Place{ 0, 0, 6 } })
  {
    points->InsertNextPoint(place.data());
  }
  grid->SetPoints(points);
  const vtkIdType corners[4] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, corners);
  Refine refine(grid);
  refine.Algorithm->SetMaximumVolume(0.125);
  vtkUnstructuredGrid* output = refine.Run();
  int large = 0;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    large += Volume(output, c) > 0.125;
  }
  ASSERT_GT(large, 0);
  EXPECT_EQ(refine.Statistic("CellsAboveMaximumVolume"), large);
  EXPECT_TRUE(refine.Says(std::to_string(large) + " of " +
    std::to_string(output->GetNumberOfCells()) + " cells are larger than MaximumVolume, 0.125"))
    << refine.Said;
  refine.Algorithm->SetMaximumVolume(36);
  refine.Run();
  EXPECT_EQ(refine.Said, "");
  EXPECT_EQ(refine.Statistic("CellsAboveMaximumVolume"), 0);
}

TEST(vtkRefineTetrahedra, NamesWhatItCannotRefine)
{
  using Change = std::function<void(vtkUnstructuredGrid*, vtkRefineTetrahedra*)>;
  const auto expectError = [](const std::string& words, const Change& change)
  {
    auto grid = Cubes(2);
    Refine refine(grid);
    change(grid, refine.Algorithm);
    EXPECT_EQ(refine.Run()->GetNumberOfCells(), 0) << words;
    EXPECT_TRUE(refine.Says(words)) << words << ": " << refine.Said;
  };
  const auto addSizes = [](vtkDataSet* data, double value)
  {
    auto sizes = MakeArray<vtkDoubleArray>("Size", data->GetNumberOfPoints());
    sizes->Fill(1);
    sizes->SetValue(5, value);
    data->GetPointData()->AddArray(sizes);
  };
  expectError("the grid has no cells",
    [](vtkUnstructuredGrid* grid, vtkRefineTetrahedra*) { grid->Initialize(); });
  expectError("cell 48 is a vtkVoxel; only tetrahedra (vtkTetra) can be refined",
    [](vtkUnstructuredGrid* grid, vtkRefineTetrahedra*)
    {
      const vtkIdType corners[8] = { 0, 1, 3, 4, 9, 10, 12, 13 };
      grid->GetCellData()->Initialize();
      grid->InsertNextCell(VTK_VOXEL, 8, corners);
    });
  expectError("point 4 is not finite",
    [](vtkUnstructuredGrid* grid, vtkRefineTetrahedra*)
    { grid->GetPoints()->SetPoint(4, 0, std::nan(""), 0); });
  expectError("cell 7 has the point 99, which is not there",
    [](vtkUnstructuredGrid* grid, vtkRefineTetrahedra*)
    {
      const vtkIdType corners[4] = { 0, 1, 2, 99 };
      grid->GetCells()->ReplaceCellAtId(7, 4, corners);
    });
  expectError("cell 0 has no volume",
    [](vtkUnstructuredGrid* grid, vtkRefineTetrahedra*)
    { grid->GetPoints()->SetPoint(grid->GetCell(0)->GetPointId(3), 0, 0, 0); });
  expectError("the cell array RegionId is not one integer per cell",
    [](vtkUnstructuredGrid* grid, vtkRefineTetrahedra*)
    { grid->GetCellData()->AddArray(MakeArray<vtkDoubleArray>("RegionId", 48)); });
  expectError("the grid has no point array Size of edge lengths",
    [](vtkUnstructuredGrid*, vtkRefineTetrahedra* filter) { filter->SetSizingArrayName("Size"); });
  expectError("the grid's point array Size is not positive at point 5",
    [&](vtkUnstructuredGrid* grid, vtkRefineTetrahedra* filter)
    {
      addSizes(grid, 0);
      filter->SetSizingArrayName("Size");
    });
  expectError("the grid's point array Size is not one edge length per point",
    [](vtkUnstructuredGrid* grid, vtkRefineTetrahedra* filter)
    {
      grid->GetPointData()->AddArray(
        MakeArray<vtkDoubleArray>("Size", grid->GetNumberOfPoints(), 3));
      filter->SetSizingArrayName("Size");
    });
  const auto background = Cubes(1);
  expectError("the background has no point array Size of edge lengths",
    [&](vtkUnstructuredGrid*, vtkRefineTetrahedra* filter)
    {
      filter->SetBackgroundData(background);
      filter->SetSizingArrayName("Size");
    });
  expectError("SizingArrayName has to say which point array of the background",
    [&](vtkUnstructuredGrid*, vtkRefineTetrahedra* filter)
    { filter->SetBackgroundData(background); });
  expectError("the background's point array Size is not positive at point 5",
    [&](vtkUnstructuredGrid*, vtkRefineTetrahedra* filter)
    {
      addSizes(background, -1);
      filter->SetBackgroundData(background);
      filter->SetSizingArrayName("Size");
    });
}

TEST(vtkRefineTetrahedra, LeavesOutArraysOfTheWrongLengthWithAWarning)
{
  auto grid = Cubes(1);
  grid->GetCellData()->AddArray(MakeArray<vtkIntArray>("FacetIds", 2, 4));
  grid->GetPointData()->AddArray(MakeArray<vtkIntArray>("Short", 2));
  Refine refine(grid);
  vtkUnstructuredGrid* output = refine.Run();
  EXPECT_GT(output->GetNumberOfCells(), 0);
  EXPECT_FALSE(output->GetCellData()->HasArray("FacetIds"));
  EXPECT_TRUE(refine.Says("the input's array FacetIds has 2 tuples where 6 are needed"));
  EXPECT_TRUE(refine.Says("the input's array Short has 2 tuples where 9 are needed"));
}

TEST(vtkRefineTetrahedra, CanBeStoppedAtEveryReportAndRunAgain)
{
  struct Stopper
  {
    int At;
    int Reports = 0;
  };
  const auto grid = Cubes(2);
  Refine undisturbed(grid);
  undisturbed.Algorithm->SetEdgeLength(0.71);
  vtkUnstructuredGrid* whole = undisturbed.Run();
  ASSERT_GT(whole->GetNumberOfCells(), 0);
  bool isStopped = true;
  int stops = 0;
  while (isStopped)
  {
    Stopper stopper = { stops + 1 };
    vtkNew<vtkCallbackCommand> observer;
    observer->SetClientData(&stopper);
    observer->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void*)
      {
        auto* algorithm = static_cast<vtkAlgorithm*>(caller);
        auto* wanted = static_cast<Stopper*>(data);
        if (algorithm->GetProgressText() && ++wanted->Reports == wanted->At)
        {
          algorithm->SetAbortExecute(1);
        }
      });
    Refine refine(grid);
    refine.Algorithm->SetEdgeLength(0.71);
    const unsigned long tag = refine.Algorithm->AddObserver(vtkCommand::ProgressEvent, observer);
    vtkUnstructuredGrid* output = refine.Run();
    EXPECT_EQ(refine.Said, "");
    isStopped = stopper.Reports >= stopper.At;
    stops += isStopped;
    if (isStopped)
    {
      EXPECT_EQ(stopper.Reports, stopper.At) << "it goes on";
      EXPECT_EQ(output->GetNumberOfCells(), 0);
      EXPECT_EQ(output->GetNumberOfPoints(), 0);
      refine.Algorithm->RemoveObserver(tag);
      refine.Algorithm->SetAbortExecute(0);
      refine.Algorithm->Modified();
      output = refine.Run();
    }
    ExpectEqual(output, whole);
  }
  EXPECT_GT(stops, 5);
}

TEST(vtkRobustTetrahedralize, RefinesTheSolidAsTheFilterForItDoes)
{
  const auto surface = TwoBoxes();
  Robust plain(surface);
  Refine refine(plain.Run());
  refine.Algorithm->SetEdgeLength(0.3);
  refine.Algorithm->SetSurfaceTreatment(vtkRefineTetrahedra::KEPT);
  refine.Algorithm->SetGrading(0.5);
  refine.Algorithm->SetMaximumVolume(0.01);
  refine.Algorithm->QuadraticCellsOn();
  vtkUnstructuredGrid* expected = refine.Run();

  Robust robust(surface);
  robust.Algorithm->SetEdgeLength(0.3);
  robust.Algorithm->GetRefinement()->SetSurfaceTreatment(vtkRefineTetrahedra::KEPT);
  robust.Algorithm->GetRefinement()->SetGrading(0.5);
  robust.Algorithm->GetRefinement()->SetMaximumVolume(0.01);
  robust.Algorithm->GetRefinement()->QuadraticCellsOn();
  ExpectEqual(robust.Run(), plain.Algorithm->GetOutput()); // which do nothing without
  robust.Algorithm->RefineOn();
  ExpectEqual(robust.Run(), expected);
  EXPECT_TRUE(refine.Says("cells are larger than MaximumVolume"));
  EXPECT_TRUE(robust.Says("cells are larger than MaximumVolume"));
  EXPECT_EQ(robust.Statistic("AddedPoints"), refine.Statistic("AddedPoints"));
  EXPECT_EQ(robust.Statistic("RefinedCells"), expected->GetNumberOfCells());
  EXPECT_EQ(robust.Statistic("InsideCells"), plain.Algorithm->GetOutput()->GetNumberOfCells());
  EXPECT_NEAR(robust.Statistic("Volume"), 15.0 / 8, 1e-12);
  EXPECT_EQ(robust.Algorithm->GetBoundary()->GetNumberOfCells(),
    plain.Algorithm->GetBoundary()->GetNumberOfCells());
  EXPECT_TRUE(expected->GetCellData()->HasArray("w"));
}

TEST(vtkRobustTetrahedralize, HasNothingToRefineWhereNothingIsInside)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (const Place& place : { Place{ 0, 0, 0 }, Place{ 1, 0, 0 }, Place{ 0, 1, 0 },
         Place{ 5, 5, 5 }, Place{ 6, 5, 5 }, Place{ 5, 6, 6 } })
  {
    const vtkIdType p = points->InsertNextPoint(place.data());
    if (p % 3 == 2)
    {
      const vtkIdType corners[3] = { p - 2, p - 1, p };
      triangles->InsertNextCell(3, corners);
    }
  }
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  Robust robust(surface);
  robust.Algorithm->RefineOn();
  EXPECT_EQ(robust.Run()->GetNumberOfCells(), 0);
  EXPECT_FALSE(robust.Says("the grid has no cells")) << robust.Said;
  EXPECT_EQ(robust.Statistic("InsideCells"), 0);
}
