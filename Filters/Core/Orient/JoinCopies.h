// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/PatchSeams.h"
#include "Orient/TurnedSets.h"

namespace insideout
{
/** The copies of patches, numbered patch by patch: those along the patch, then those against it. */
class PatchCopies
{
public:
  explicit PatchCopies(const SeamedPatches& patches);

  Id First(Id patch) const { return this->Firsts[patch]; }
  Id Along(Id patch) const { return this->Alongs[patch]; }
  Id Against(Id patch) const { return this->Size(patch) - this->Alongs[patch]; }
  Id Size(Id patch) const { return this->Firsts[patch + 1] - this->Firsts[patch]; }
  Id Count() const { return this->Firsts.back(); }

private:
  std::vector<Id> Firsts;
  std::vector<Id> Alongs;
};

/**
 * Join copies of patches in pairs at seams where as many run along the seam as against it.
 *
 * Copies already in one set are a pair. Next come the copies of one given surface
 * (FacetComplex::SourceSurfaces) at seams that copies of other surfaces share. If only two remain
 * at a seam they are the next pair, and so on from seam to seam. If more remain, longest seam
 * first, two that bound the same solid wedge at the seam are a pair: going around, the wedge begins
 * behind the first and ends behind the next.
 *
 * @param[in] seams that balance
 * @param[in,out] sets of copies
 */
void JoinCopies(const FacetComplex& surface, const FacetEdges& edges,
  const std::vector<PatchSeam>& seams, const SeamedPatches& patches, const PatchCopies& copies,
  TurnedSets& sets);
} // namespace insideout
