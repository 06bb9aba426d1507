// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/WalkedWindingNumber.h"

#include "Common/ParallelLoop.h"
#include "Common/Stages.h"
#include "WindingNumber/Prefetch.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <string>

namespace insideout
{
namespace
{
constexpr int Unknown = std::numeric_limits<int>::min();

[[noreturn]] void ThrowDifferent(Id from, Id to)
{
  throw Error(ErrorCode::Inconsistent,
    "the winding number does not rise by the facets' count between cell " +
      (from == None ? std::string("(outside)") : std::to_string(from)) + " and cell " +
      std::to_string(to));
}

// Prefetch distance: cells are scattered over memory.
constexpr std::size_t StepsAhead = 8;

void PrefetchFaces(const TetrahedralMesh& mesh, Id cell)
{
  Prefetch(&mesh.Neighbors[cell]);
  Prefetch(&mesh.Facets[cell]);
  Prefetch(&mesh.FacetSides[cell]);
}

/**
 * Carry the winding number from the hull into every cell that can be reached, one layer of cells
 * after the other, and compare it wherever a cell is met again. Cells that cannot be reached stay
 * Unknown.
 */
class Walk
{
public:
  /** @throws Error Inconsistent: for any number of threads the one that a single thread meets */
  Walk(const FacetComplex& surface, const TetrahedralMesh& mesh)
    : Walk(surface, mesh, false)
  {
    if (!this->IsConsistent)
    {
      Walk(surface, mesh, true);
    }
  }

  const std::vector<int>& Values() const { return this->W; }

private:
  Walk(const FacetComplex& surface, const TetrahedralMesh& mesh, bool isAlone)
    : Surface(surface)
    , Mesh(mesh)
    , IsAlone(isAlone)
    , W(mesh.Cells.size(), Unknown)
  {
    this->Layer(mesh.Cells.size(),
      [this](std::size_t first, std::size_t last, std::vector<Id>& next)
      {
        for (Id cell = static_cast<Id>(first); cell < static_cast<Id>(last); ++cell)
        {
          this->Enter(cell, next);
        }
      });
    while (!this->Reached.empty() && this->IsConsistent)
    {
      const std::vector<Id> layer = std::move(this->Reached);
      this->Reached.clear();
      this->Layer(layer.size(),
        [this, &layer](std::size_t first, std::size_t last, std::vector<Id>& next)
        {
          for (std::size_t i = first; i < last; ++i)
          {
            if (i + StepsAhead < last)
            {
              this->PrefetchNeighbors(layer[i + StepsAhead]);
            }
            this->Leave(layer[i], next);
          }
        });
    }
  }

  /** Call visit(first, last, next) for all stretches of a layer; `next` are the cells reached. */
  template <class Visit>
  void Layer(std::size_t size, const Visit& visit)
  {
    constexpr std::size_t CellsPerTurn = 1024;
    constexpr double NanosecondsPerCell = 40;
    const std::size_t perTurn = this->IsAlone ? std::max<std::size_t>(size, 1) : CellsPerTurn;
    ParallelLoop((size + perTurn - 1) / perTurn, CellsPerTurn * NanosecondsPerCell,
      [&](std::size_t turn)
      {
        std::vector<Id> next;
        visit(turn * perTurn, std::min((turn + 1) * perTurn, size), next);
        const std::lock_guard<std::mutex> lock(this->Mutex);
        this->Reached.insert(this->Reached.end(), next.begin(), next.end());
      });
  }

  /** From beyond the hull. */
  void Enter(Id cell, std::vector<Id>& next)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (this->Mesh.Neighbors[cell][k] == None)
      {
        this->Reach(None, cell, MultiplicityOnEntering(this->Surface, this->Mesh, cell, k), next);
      }
    }
  }

  /** Into the neighbors. */
  void Leave(Id cell, std::vector<Id>& next)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (this->Mesh.Neighbors[cell][k] != None)
      {
        this->Reach(cell, this->Mesh.Neighbors[cell][k],
          this->W[cell] - MultiplicityOnEntering(this->Surface, this->Mesh, cell, k), next);
      }
    }
  }

  /** The thread that is there first has the cell in the next layer. */
  void Reach(Id from, Id to, int value, std::vector<Id>& next)
  {
    int known = __atomic_load_n(&this->W[to], __ATOMIC_RELAXED);
    if (known == Unknown &&
      __atomic_compare_exchange_n(
        &this->W[to], &known, value, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
    {
      next.push_back(to);
      PrefetchFaces(this->Mesh, to);
    }
    else if (known != value && this->IsAlone)
    {
      ThrowDifferent(from, to);
    }
    else if (known != value)
    {
      this->IsConsistent = false;
    }
  }

  void PrefetchNeighbors(Id cell) const
  {
    for (const Id neighbor : this->Mesh.Neighbors[cell])
    {
      if (neighbor != None)
      {
        Prefetch(&this->W[neighbor]);
      }
    }
  }

  const FacetComplex& Surface;
  const TetrahedralMesh& Mesh;
  const bool IsAlone; ///< one thread takes all cells in turn
  std::vector<int> W;
  std::atomic<bool> IsConsistent{ true };
  std::mutex Mutex;
  std::vector<Id> Reached; ///< in the layer after the one that is left
};

/** Walk from a part's first cell to all others. */
void WalkPart(const FaceCounts& counts, const TetrahedralMesh& mesh,
  const std::vector<char>& touched, Id first, UntouchedParts& parts)
{
  const Id part = static_cast<Id>(parts.FirstCell.size());
  parts.FirstCell.push_back(first);
  parts.OfCell[first].Part = part;
  std::vector<Id> reached = { first };
  for (std::size_t next = 0; next < reached.size(); ++next)
  {
    for (int k = 0; next + StepsAhead < reached.size() && k < 4; ++k)
    {
      const Id ahead = mesh.Neighbors[reached[next + StepsAhead]][k];
      if (ahead != None)
      {
        Prefetch(&touched[ahead]);
        Prefetch(&parts.OfCell[ahead]);
      }
    }
    const Id cell = reached[next];
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = mesh.Neighbors[cell][k];
      if (neighbor == None || touched[neighbor])
      {
        continue;
      }
      const int rise = parts.OfCell[cell].Rise - counts.OnEntering(cell, k);
      UntouchedParts::Place& place = parts.OfCell[neighbor];
      if (place.Part == None)
      {
        place = { part, rise };
        reached.push_back(neighbor);
        PrefetchFaces(mesh, neighbor);
      }
      else if (place.Rise != rise)
      {
        ThrowDifferent(cell, neighbor);
      }
    }
  }
}
} // namespace

std::vector<double> WalkedWindingNumbers(
  const FacetComplex& surface, const TetrahedralMesh& mesh, Monitor& monitor)
{
  monitor.Check(Stages::WindingNumbers, 0);
  const Walk walk(surface, mesh);
  const std::vector<int>& walked = walk.Values();
  monitor.Check(Stages::WindingNumbers, 0.5);
  const auto missing = std::find(walked.begin(), walked.end(), Unknown);
  if (missing != walked.end())
  {
    throw Error(ErrorCode::Inconsistent,
      "cell " + std::to_string(missing - walked.begin()) + " cannot be reached from the hull");
  }
  monitor.Check(Stages::WindingNumbers, 1);
  return std::vector<double>(walked.begin(), walked.end());
}

FaceCounts::FaceCounts(const FacetComplex& surface, const TetrahedralMesh& mesh)
  : Mesh(mesh)
  , Count(surface.Multiplicity.begin(), surface.Multiplicity.end())
{
  for (const Id facet : mesh.LostFacets)
  {
    this->Count[facet] = 0;
  }
}

ChainOfFacets FaceCounts::Chain() const
{
  ChainOfFacets faces;
  for (Id cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      const int count = this->OnEntering(cell, k);
      if (count != 0 && this->Mesh.Neighbors[cell][k] < cell)
      {
        faces.Triangles.push_back({ FaceOf(this->Mesh.Cells[cell], k), count });
        faces.Facets.push_back(this->Mesh.Facets[cell][k]);
      }
    }
  }
  return faces;
}

void FaceCounts::LeaveOut(const std::vector<char>& facets)
{
  for (std::size_t f = 0; f < this->Count.size(); ++f)
  {
    if (facets[f])
    {
      this->Count[f] = 0;
    }
  }
}

UntouchedParts WalkParts(
  const FaceCounts& counts, const TetrahedralMesh& mesh, const std::vector<char>& touched)
{
  UntouchedParts parts;
  parts.OfCell.assign(mesh.Cells.size(), { None, 0 });
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    if (!touched[cell] && parts.OfCell[cell].Part == None)
    {
      WalkPart(counts, mesh, touched, cell, parts);
    }
  }
  return parts;
}
} // namespace insideout
