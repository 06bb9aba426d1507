// SPDX-License-Identifier: GPL-3.0-or-later
#include "Quality/QualityOfMesh.h"

#include "Common/FaceTable.h"
#include "Common/ParallelLoop.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** What a cell takes. */
constexpr double NanosecondsPerCell = 500;

/**
 * Cells per block. Cells are summed within blocks, and then the blocks: the sum is the same for any
 * number of threads.
 */
constexpr std::size_t CellsPerBlock = 1024;

constexpr double DegreesPerBin = 5;

/** The results of one block. */
struct Block
{
  std::array<std::int64_t, 36> Histogram = {};
  double SumOfMeanRatios = 0;
  double MinMeanRatio = 1;
  Id CellsUnder10 = 0;
  Id CellsUnder5 = 0;
};

Block BlockOf(const CellQuality* first, const CellQuality* last)
{
  Block block;
  for (const CellQuality* cell = first; cell != last; ++cell)
  {
    for (const double angle : cell->DihedralAngles)
    {
      const std::size_t bin = static_cast<std::size_t>(angle / DegreesPerBin);
      ++block.Histogram[std::min(bin, block.Histogram.size() - 1)];
    }
    block.SumOfMeanRatios += cell->MeanRatio;
    block.MinMeanRatio = std::min(block.MinMeanRatio, cell->MeanRatio);
    block.CellsUnder10 += cell->MinDihedralAngle() < 10;
    block.CellsUnder5 += cell->MinDihedralAngle() < 5;
  }
  return block;
}

template <typename Visit>
void ForEachBlock(std::size_t cells, double nanosecondsPerCell, const Visit& visit)
{
  const std::size_t blocks = (cells + CellsPerBlock - 1) / CellsPerBlock;
  ParallelLoop(blocks, CellsPerBlock * nanosecondsPerCell,
    [&](std::size_t block)
    {
      const std::size_t first = block * CellsPerBlock;
      visit(block, first, std::min(first + CellsPerBlock, cells));
    });
}

/**
 * The quantile: the least value that at least this share of the values does not exceed. Reorders
 * the values.
 */
double Quantile(std::vector<double>& values, double share)
{
  const auto rank =
    static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size())));
  const auto place = values.begin() + std::max<std::ptrdiff_t>(rank, 1) - 1;
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/** The index (TetrahedronEdges) of the edge between two points of a cell. */
std::size_t EdgeOfCell(const Tetrahedron& cell, const Edge& ends)
{
  std::size_t edge = 0;
  while (EdgeBetween(cell[TetrahedronEdges[edge][0]], cell[TetrahedronEdges[edge][1]]) != ends)
  {
    ++edge;
  }
  return edge;
}

/** Walks through the solid around an edge, from a boundary face on. */
class WedgeWalk
{
public:
  WedgeWalk(const std::vector<Tetrahedron>& cells, const std::vector<CellQuality>& qualities,
    const FaceTable& faces, double limit)
    : Cells(cells)
    , Qualities(qualities)
    , Faces(faces)
    , Limit(limit)
  {
  }

  /** Find the wedges that begin at a face of this cell, except those found from their other end. */
  void Find(Id cell, std::vector<SharpEdge>& found) const
  {
    if (!(this->Qualities[cell].MinDihedralAngle() < this->Limit))
    {
      return;
    }
    for (int face = 0; face < 4; ++face)
    {
      const Triangle corners = FaceOf(this->Cells[cell], face);
      if (this->Faces.Find(SortedTriangle(corners)).Size() != 1)
      {
        continue;
      }
      for (int k = 0; k < 3; ++k)
      {
        const Edge ends = EdgeBetween(corners[k], corners[(k + 1) % 3]);
        const double angle = this->Angle({ cell, face }, ends);
        if (angle < this->Limit)
        {
          found.push_back({ ends, angle });
        }
      }
    }
  }

private:
  struct Side
  {
    Id Cell;
    int Face;
  };

  /** The other face of the cell at an edge. */
  int OtherFace(const Side& side, const Edge& ends) const
  {
    int other = 0;
    for (int face = 0; face < 4; ++face)
    {
      const Triangle corners = FaceOf(this->Cells[side.Cell], face);
      const bool hasBoth = std::count_if(corners.begin(), corners.end(),
                             [&](Id p) { return p == ends[0] || p == ends[1]; }) == 2;
      other = hasBoth && face != side.Face ? face : other;
    }
    return other;
  }

  /**
   * The angle of a wedge; the limit if it is not smaller, has no end, or is found from its other
   * end.
   */
  double Angle(const Side& first, const Edge& ends) const
  {
    Side side = first;
    double angle = 0;
    while (angle < this->Limit)
    {
      const Tetrahedron& cell = this->Cells[side.Cell];
      angle += this->Qualities[side.Cell].DihedralAngles[EdgeOfCell(cell, ends)];
      side.Face = this->OtherFace(side, ends);
      const FaceTable::Range sharing =
        this->Faces.Find(SortedTriangle(FaceOf(this->Cells[side.Cell], side.Face)));
      if (sharing.Size() == 1)
      {
        const bool isFirstEnd =
          first.Cell < side.Cell || (first.Cell == side.Cell && first.Face < side.Face);
        return isFirstEnd ? angle : this->Limit;
      }
      if (sharing.Size() > 2)
      {
        break;
      }
      const FaceEntry& beyond = sharing.First[sharing.First[0].Cell == side.Cell ? 1 : 0];
      side = { beyond.Cell, beyond.Face };
    }
    return this->Limit;
  }

  const std::vector<Tetrahedron>& Cells;
  const std::vector<CellQuality>& Qualities;
  const FaceTable& Faces;
  const double Limit;
};
} // namespace

std::vector<CellQuality> QualityOfCells(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, Monitor& monitor, const ProgressRange& progress)
{
  std::vector<CellQuality> qualities(cells.size());
  ParallelLoop(cells.size(), NanosecondsPerCell, monitor, progress,
    [&](std::size_t c) { qualities[c] = QualityOfCell(points, cells[c]); });
  return qualities;
}

std::vector<SharpEdge> SharpBoundaryEdges(const std::vector<Tetrahedron>& cells,
  const std::vector<CellQuality>& qualities, std::size_t numberOfPoints, double limit)
{
  const FaceTable faces(numberOfPoints, cells);
  const WedgeWalk walk(cells, qualities, faces, limit);
  std::vector<std::vector<SharpEdge>> blocks((cells.size() + CellsPerBlock - 1) / CellsPerBlock);
  ForEachBlock(cells.size(), NanosecondsPerCell,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t c = first; c < last; ++c)
      {
        walk.Find(static_cast<Id>(c), blocks[block]);
      }
    });
  std::vector<SharpEdge> all;
  for (const std::vector<SharpEdge>& block : blocks)
  {
    all.insert(all.end(), block.begin(), block.end());
  }
  return all;
}

MeshQuality SummarizeQuality(const std::vector<Tetrahedron>& cells,
  const std::vector<CellQuality>& qualities, std::size_t numberOfPoints, Monitor& monitor,
  const ProgressRange& progress)
{
  MeshQuality quality;
  quality.Cells = static_cast<Id>(qualities.size());
  if (qualities.empty())
  {
    return quality;
  }
  std::vector<Block> blocks((qualities.size() + CellsPerBlock - 1) / CellsPerBlock);
  std::vector<double> angles(6 * qualities.size());
  std::vector<double> ratios(qualities.size());
  ForEachBlock(qualities.size(), 50,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      blocks[block] = BlockOf(qualities.data() + first, qualities.data() + last);
      for (std::size_t c = first; c < last; ++c)
      {
        std::copy_n(qualities[c].DihedralAngles.data(), 6, angles.data() + 6 * c);
        ratios[c] = qualities[c].RadiusEdgeRatio;
      }
    });
  quality.MinMeanRatio = 1;
  for (const Block& block : blocks)
  {
    for (std::size_t bin = 0; bin < block.Histogram.size(); ++bin)
    {
      quality.Histogram[bin] += block.Histogram[bin];
    }
    quality.AverageMeanRatio += block.SumOfMeanRatios;
    quality.MinMeanRatio = std::min(quality.MinMeanRatio, block.MinMeanRatio);
    quality.CellsUnder10Degrees += block.CellsUnder10;
    quality.CellsUnder5Degrees += block.CellsUnder5;
  }
  monitor.Check(progress, 0.2);
  quality.AverageMeanRatio /= static_cast<double>(qualities.size());
  quality.MinDihedralAngle = Quantile(angles, 0);
  quality.DihedralAngle1Percent = Quantile(angles, 0.01);
  quality.MaxDihedralAngle = Quantile(angles, 1);
  quality.RadiusEdgeRatio99Percent = Quantile(ratios, 0.99);
  quality.MaxRadiusEdgeRatio = Quantile(ratios, 1);
  monitor.Check(progress, 0.4);
  for (const SharpEdge& edge : SharpBoundaryEdges(cells, qualities, numberOfPoints, 10))
  {
    ++quality.SurfaceEdgesUnder10Degrees;
    quality.SurfaceEdgesUnder5Degrees += edge.Angle < 5;
  }
  return quality;
}

MeshQuality QualityOfMesh(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells,
  Monitor& monitor, const ProgressRange& progress)
{
  const ProgressRange first = { progress.Stage, progress.Begin, progress.At(0.4) };
  const ProgressRange second = { progress.Stage, first.End, progress.End };
  const std::vector<CellQuality> qualities = QualityOfCells(points, cells, monitor, first);
  return SummarizeQuality(cells, qualities, points.size(), monitor, second);
}

void AppendQuality(const MeshQuality& quality, Statistics& statistics, const std::string& prefix)
{
  const auto append = [&](const char* name, double value)
  { statistics.emplace_back(prefix + name, value); };
  append("MinDihedralAngle", quality.MinDihedralAngle);
  append("DihedralAngle1Percent", quality.DihedralAngle1Percent);
  append("MaxDihedralAngle", quality.MaxDihedralAngle);
  append("RadiusEdgeRatio99Percent", quality.RadiusEdgeRatio99Percent);
  append("MaxRadiusEdgeRatio", quality.MaxRadiusEdgeRatio);
  append("MinMeanRatio", quality.MinMeanRatio);
  append("AverageMeanRatio", quality.AverageMeanRatio);
  append("CellsUnder10Degrees", quality.CellsUnder10Degrees);
  append("CellsUnder5Degrees", quality.CellsUnder5Degrees);
  append("SurfaceEdgesUnder10Degrees", quality.SurfaceEdgesUnder10Degrees);
  append("SurfaceEdgesUnder5Degrees", quality.SurfaceEdgesUnder5Degrees);
}
} // namespace insideout
