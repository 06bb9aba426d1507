// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/MeshReader.h"

namespace insideout
{
Id MeshReader::VertexOffPlane(Id a, Id b, Id c) const
{
  for (const Id vertex : this->Read.Spanning)
  {
    if (this->Orient(a, b, c, vertex) != 0)
    {
      return vertex;
    }
  }
  return None;
}

void MeshReader::Star(Id vertex, std::vector<Id>& cells) const
{
  if (this->Read.HasVertex(vertex))
  {
    this->Read.Mesh::Star(vertex, cells, this->Marks);
    this->Work.Spend(static_cast<std::int64_t>(cells.size()) / CellsPerWork);
  }
}

Id MeshReader::FindEdge(Id u, Id v) const
{
  const std::int64_t before = this->Search.Steps();
  const Id cell = this->Search.Find(this->Read, u, v);
  this->Work.Spend(this->Search.Steps() - before);
  return cell;
}
} // namespace insideout
