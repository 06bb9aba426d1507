// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/OptionHashes.h"

#include "Support/Hash.h"
#include "Support/HashGroups.h"

using namespace insideout;

Hashes HashOptions(const TriangleSoup& soup)
{
  const std::pair<std::string, AddGroup*> groups[] = { { "repair", AddRepair },
    { "thickening", AddThickening }, { "parts apart", AddPartsApart }, { "seeds", AddSeeds },
    { "topology", AddTopology }, { "outputs", AddOutputs }, { "parting", AddParting },
    { "bodies", AddBodies }, { "booleans", AddBooleans }, { "refinement", AddRefinement },
    { "plane", AddPlane }, { "refinement in the plane", AddPlanarRefinement } };
  Hashes hashes;
  for (const auto& [name, addGroup] : groups)
  {
    Hashes found;
    try
    {
      addGroup(soup, found);
    }
    catch (const Error& error)
    {
      AddHash("error", found, std::string(error.what()));
    }
    for (const auto& [part, hash] : found)
    {
      hashes[name + ", " + part] = hash;
    }
  }
  return hashes;
}

Hashes HashTetGen(const TriangleSoup& soup)
{
  HullMeshParameters parameters;
  parameters.Budgets.Engine = TetrahedralizationEngine::TetGen;
  Monitor monitor;
  Hashes hashes;
  HullMesh hull = MeshHull(soup, parameters, monitor);
  hull.Warnings.clear(); // they say how TetGen crashed, and builds crash in ways of their own
  AddHull("TetGen", hull, hashes);
  return hashes;
}
