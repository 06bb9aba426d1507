// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** One mark per cell, for consecutive searches. */
class CellMarks
{
public:
  /** Unmark all cells, whose ids are below `cells`. */
  void Start(Id cells)
  {
    if (this->Marks.size() < static_cast<std::size_t>(cells))
    {
      this->Marks.resize(static_cast<std::size_t>(cells), 0);
    }
    ++this->Epoch;
  }

  bool Has(Id cell) const { return this->Marks[cell] == this->Epoch; }
  void Add(Id cell) { this->Marks[cell] = this->Epoch; }
  void Remove(Id cell) { this->Marks[cell] = 0; }

private:
  std::vector<std::uint32_t> Marks;
  std::uint32_t Epoch = 0;
};
} // namespace insideout
