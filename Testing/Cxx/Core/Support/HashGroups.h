// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "HullMesh.h"
#include "Support/StageHashes.h"

/** The groups of HashOptions: each adds hashes of what one kind of options makes of a surface. */
using AddGroup = void(const insideout::TriangleSoup& soup, Hashes& hashes);
AddGroup AddRepair, AddThickening, AddPartsApart, AddSeeds, AddTopology, AddOutputs, AddParting,
  AddBodies, AddBooleans, AddRefinement, AddPlane, AddPlanarRefinement;

/** MeshHull without TetGen. */
insideout::HullMesh ExactHull(
  const insideout::TriangleSoup& soup, insideout::HullMeshParameters parameters = {});

/** Add what MeshHull gives. */
void AddHull(const std::string& name, const insideout::HullMesh& hull, Hashes& hashes);

/** The length of the diagonal of the box around all points. */
double DiagonalOf(const insideout::TriangleSoup& soup);

/** The point at these fractions of the sides of the box around all points. */
insideout::Point PointIn(const insideout::TriangleSoup& soup, double x, double y, double z);
