// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Mesh/CellMarks.h"

namespace insideout
{
/** Cells that a search collects, each once, in the order in which they are added. */
class CellSet
{
public:
  /** Begin with no cell; ids are below `cells`. */
  void Start(Id cells)
  {
    this->Marks.Start(cells);
    this->Members.clear();
  }

  bool Has(Id cell) const { return this->Marks.Has(cell); }

  /** Add a cell that may be there already. */
  void Add(Id cell)
  {
    if (!this->Has(cell))
    {
      this->Marks.Add(cell);
      this->Members.push_back(cell);
    }
  }

  /** The set no longer has the cell, which Cells() lists until the next Start. */
  void Unmark(Id cell) { this->Marks.Remove(cell); }

  const std::vector<Id>& Cells() const { return this->Members; }

private:
  CellMarks Marks;
  std::vector<Id> Members;
};
} // namespace insideout
