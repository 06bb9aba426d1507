// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Layers/LayerWall.h"
#include "Layers/LayeredMesh.h"
#include "Layers/PushWall.h"
#include "Layers/WallRims.h"

#include <vector>

namespace insideout
{
/** A solid whose wall was pushed inward to make room for layers. */
struct PushedSolid
{
  const TetrahedralMesh& Input;
  const std::vector<Id>& Regions;
  const std::vector<Id>& WallFaces; ///< of the input
  const RefinableMesh& Mesh;
  const LayerWall& Wall;
  const std::vector<RimEdge>& Rim;
  const PushedWall& Pushed;
  const std::vector<double>& Fractions;
};

/**
 * Make the points and cells of the layers, between a wall and its pushed position, and those
 * behind.
 *
 * @throws Error Stopped
 */
LayeredMesh MakeLayeredMesh(const PushedSolid& solid, Monitor& monitor);
} // namespace insideout
