// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/SurfaceDefects.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"
#include "Defects/IntersectionCurves.h"
#include "Defects/JoinSegments.h"
#include "Defects/MeantVolume.h"
#include "Defects/NearPoints.h"
#include "Resolve/FindIntersections.h"
#include "Validate/FacetEdges.h"

#include <algorithm>
#include <cstdio>

namespace insideout
{
namespace
{
/** Points nearer than this fraction of the surface's size are probably meant to coincide: it is
 * some ten float spacings. */
constexpr double NearFraction = 1e-6;

using Segments = std::vector<std::array<Id, 2>>;

/** The signed count of an edge from its lower to its higher point. */
int SignedSum(const FacetEdge* first, const FacetEdge* last, const FacetComplex& surface)
{
  int sum = 0;
  for (const FacetEdge* edge = first; edge != last; ++edge)
  {
    sum += edge->Direction * surface.Multiplicity[edge->Facet];
  }
  return sum;
}

bool RunTheSameWay(const FacetEdge& a, const FacetEdge& b, const FacetComplex& surface)
{
  return a.Direction * surface.Multiplicity[a.Facet] * b.Direction * surface.Multiplicity[b.Facet] >
    0;
}

/** The defective edges, by their ends, and the facets' flags. */
struct EdgeDefects
{
  Segments Open;
  Segments NonManifold;
  Segments Inconsistent;
  std::vector<char> HasInconsistent; ///< per facet
  Id Unbalanced = 0;
};

EdgeDefects FindEdgeDefects(const FacetComplex& surface, const FacetEdges& edges)
{
  EdgeDefects defects;
  defects.HasInconsistent.assign(surface.NumberOfFacets(), 0);
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      const std::array<Id, 2> ends{ { first->Low, first->High } };
      if (last - first == 1)
      {
        defects.Open.push_back(ends);
      }
      else if (last - first > 2)
      {
        defects.NonManifold.push_back(ends);
      }
      else if (RunTheSameWay(first[0], first[1], surface))
      {
        defects.Inconsistent.push_back(ends);
        defects.HasInconsistent[first[0].Facet] = defects.HasInconsistent[first[1].Facet] = 1;
      }
      defects.Unbalanced += SignedSum(first, last, surface) != 0;
    });
  return defects;
}

/** Per component, whether it is given in both orientations everywhere, before the rule for
 * two-sided solids. */
std::vector<char> FindTwoSided(
  const TriangleSoup& soup, const FacetComplex& surface, const FacetComponents& components)
{
  std::vector<char> twoSided(components.Count, 1);
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const auto first = surface.Sources.begin() + surface.SourceOffsets[f];
    const auto last = surface.Sources.begin() + surface.SourceOffsets[f + 1];
    const bool cancels = soup.Multiplicity.empty()
      ? std::any_of(first, last, [](const FacetSource& source) { return source.Reversed; })
      : surface.Multiplicity[f] == 0;
    twoSided[components.Component[f]] &= cancels;
  }
  return twoSided;
}

/** Lines between points of the surface, of which only the used ones are kept. */
class LineCollector
{
public:
  LineCollector(const FacetComplex& surface, SurfaceDefects& defects)
    : Surface(surface)
    , Defects(defects)
    , Index(surface.Points.size(), None)
  {
  }

  void AddEdges(DefectType type, const Segments& edges)
  {
    for (std::vector<Id>& line : JoinSegments(edges))
    {
      for (Id& p : line)
      {
        p = this->Add(p);
      }
      this->Defects.Lines.push_back({ type, std::move(line) });
    }
  }

private:
  Id Add(Id p)
  {
    if (this->Index[p] == None)
    {
      this->Index[p] = static_cast<Id>(this->Defects.Points.size());
      this->Defects.Points.push_back(this->Surface.Points[p]);
      this->Defects.InputPoints.push_back(this->Surface.Origins[p].Points[0]);
    }
    return this->Index[p];
  }

  const FacetComplex& Surface;
  SurfaceDefects& Defects;
  std::vector<Id> Index;
};

void AddCurves(const IntersectionCurves& curves, SurfaceDefects& defects)
{
  const Id offset = static_cast<Id>(defects.Points.size());
  defects.Points.insert(defects.Points.end(), curves.Points.begin(), curves.Points.end());
  defects.InputPoints.resize(defects.Points.size(), None);
  std::vector<char> onLine(curves.Points.size(), 0);
  for (std::vector<Id>& line : JoinSegments(curves.Segments))
  {
    for (Id& p : line)
    {
      onLine[p] = 1;
      p += offset;
    }
    defects.Lines.push_back({ DefectType::IntersectionCurve, std::move(line) });
  }
  for (Id p = 0; p < static_cast<Id>(onLine.size()); ++p)
  {
    if (!onLine[p])
    {
      defects.Lines.push_back({ DefectType::IntersectionCurve, { p + offset } });
    }
  }
}

void MarkTriangles(const FacetComplex& surface, const FacetComponents& components,
  const std::vector<char>& twoSided, const EdgeDefects& edges, const Segments& pairs,
  SurfaceDefects& defects)
{
  std::vector<Id> met(surface.NumberOfFacets(), 0);
  for (const std::array<Id, 2>& pair : pairs)
  {
    ++met[pair[0]];
    ++met[pair[1]];
  }
  defects.IntersectingFacets = static_cast<Id>(met.size() - std::count(met.begin(), met.end(), 0));

  TriangleDefects degenerate;
  degenerate.Degenerate = true; // unless it is a facet's
  defects.Triangles.assign(defects.Counts.InputTriangles, degenerate);
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    TriangleDefects facet;
    facet.Component = components.Component[f];
    facet.SelfIntersections = met[f];
    facet.Inconsistent = edges.HasInconsistent[f];
    facet.TwoSided = twoSided[facet.Component];
    facet.Shell = defects.Turns.Shell[f];
    facet.Turned = defects.Turns.Turned[f];
    facet.Sheet = defects.Turns.IsSheet[f];
    facet.Membrane = defects.Turns.IsMembrane[f];
    for (Id s = surface.SourceOffsets[f]; s < surface.SourceOffsets[f + 1]; ++s)
    {
      facet.Duplicate = s > surface.SourceOffsets[f];
      defects.Triangles[surface.Sources[s].Triangle] = facet;
    }
  }
}

bool LiesInOnePlane(const FacetComplex& surface)
{
  const std::array<Point, 3> plane = CornersOf(surface.Points, surface.Facets.front());
  return std::all_of(surface.Points.begin(), surface.Points.end(),
    [&](const Point& p) { return Orient3D(plane[0], plane[1], plane[2], p) == 0; });
}

void AddInterval(const std::string& name, const VolumeInterval& volume, Statistics& statistics)
{
  statistics.emplace_back(name, volume.Value);
  statistics.emplace_back(name + "Low", volume.Low);
  statistics.emplace_back(name + "High", volume.High);
}

std::string AdviceOnNearPoints(const NearPoints& near)
{
  char distance[32];
  std::snprintf(distance, sizeof(distance), "%.2g", near.Distance);
  return std::to_string(near.Count) + " points lie nearer than " + distance +
    " to another, a millionth of the surface's size: if they are meant to be one, set "
    "MergeTolerance to " +
    distance;
}
} // namespace

SurfaceDefects FindSurfaceDefects(
  const TriangleSoup& soup, double mergeTolerance, Orientation orientation, Monitor& monitor)
{
  CountedChainParameters parameters;
  parameters.MergeTolerance = mergeTolerance;
  const CountedChain chain = CountFacets(soup, parameters, monitor);
  const FacetComplex& surface = chain.Surface;
  SurfaceDefects defects;
  defects.Counts = chain.Counts;
  defects.Planar = LiesInOnePlane(surface);
  defects.Turns = FindFacetTurns(surface, chain.Edges, orientation, monitor);
  defects.Warnings = defects.Turns.Warnings;
  const std::vector<std::string>& uncounted = defects.Turns.UncountedWarnings;
  defects.Warnings.insert(defects.Warnings.end(), uncounted.begin(), uncounted.end());

  const Segments pairs = FindIntersections(surface.Points, surface.Facets, monitor);
  defects.IntersectingPairs = static_cast<Id>(pairs.size());
  if (!defects.Planar)
  {
    defects.Volumes = FindMeantVolume(surface, defects.Turns.Multiplicity, pairs, monitor);
  }

  const FacetEdges& edges = chain.Edges;
  const FacetComponents components = ComponentsOfFacets(surface.NumberOfFacets(), edges);
  const EdgeDefects edgeDefects = FindEdgeDefects(surface, edges);
  defects.InconsistentEdges = static_cast<Id>(edgeDefects.Inconsistent.size());
  defects.UnbalancedEdges = edgeDefects.Unbalanced;
  MarkTriangles(
    surface, components, FindTwoSided(soup, surface, components), edgeDefects, pairs, defects);

  LineCollector lines(surface, defects);
  lines.AddEdges(DefectType::OpenBoundary, edgeDefects.Open);
  lines.AddEdges(DefectType::NonManifoldEdge, edgeDefects.NonManifold);
  lines.AddEdges(DefectType::InconsistentEdge, edgeDefects.Inconsistent);
  AddCurves(TraceIntersections(surface.Points, surface.Facets, pairs, monitor), defects);

  const NearPoints near = FindNearPoints(surface.Points, NearFraction);
  defects.NearPoints = near.Count;
  defects.NearDistance = near.Distance;
  if (near.Count > 0)
  {
    defects.Warnings.push_back(AdviceOnNearPoints(near));
  }
  if (chain.Coordinates.AreTooCoarse())
  {
    defects.Warnings.push_back(WarningAbout(chain.Coordinates));
  }
  return defects;
}

void AddDefects(const SurfaceDefects& defects, Statistics& statistics)
{
  AddCounts(defects.Counts, statistics);
  AddTurns(defects.Turns, statistics);
  AddInterval("EnclosedVolume", defects.Volumes.Solid, statistics);
  AddInterval("OverlapVolume", defects.Volumes.Overlap, statistics);
  statistics.emplace_back("IntersectingPairs", defects.IntersectingPairs);
  statistics.emplace_back("IntersectingFacets", defects.IntersectingFacets);
  statistics.emplace_back("InconsistentEdges", defects.InconsistentEdges);
  statistics.emplace_back("UnbalancedEdges", defects.UnbalancedEdges);
  statistics.emplace_back("Planar", defects.Planar);
  statistics.emplace_back("NearPoints", defects.NearPoints);
  statistics.emplace_back("NearDistance", defects.NearDistance);
}
} // namespace insideout
