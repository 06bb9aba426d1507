// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Makes the winding number of a raw vtkPolyData, for the classes that need no mesh.
 */
#pragma once

#include "Clouds/CloudWindingNumber.h"
#include "Common/Stages.h"
#include "Distance/SurfaceDistance.h"
#include "In/StageParameters.h"
#include "Planar/CurveWindingNumber.h"
#include "WindingNumber/SurfacePieces.h"
#include "WindingNumber/SurfaceWindingNumber.h"

#include <vtkType.h>

#include <memory>

class vtkPolyData;

namespace vtkInsideOut
{
struct SurfaceOptions
{
  insideout::CountedChainParameters Chain;
  insideout::Orientation Orientation;
  insideout::WindingNumberParameters WindingNumber;
  std::string NonParticipating; ///< cell array, not 0 where a cell does not count
  std::string Areas = "Area";   ///< point array of a cloud; where there is none they are estimated
  bool Distance = false;        ///< whether that is asked for, too
};

/** The point of a surface nearest to a place. Facets have their numbers in the whole surface. */
struct NearestPoint : insideout::SurfaceDistance::Nearest
{
  vtkIdType Cell; ///< of the input; -1 where the place is not finite
};

/** A piece of a surface. */
struct SurfaceChunk : insideout::CountedPiece
{
  std::vector<vtkIdType> Cells; ///< of the input, for each facet; none where no distance is asked
};

/** The options that those classes have in common. */
template <typename Class>
SurfaceOptions ReadSurfaceOptions(Class* object)
{
  SurfaceOptions options;
  options.Chain = ChainParametersOf(object);
  options.Orientation = OrientationOf(object);
  options.NonParticipating = object->GetNonParticipatingArrayName();
  return options;
}

/** The facets that count of a polygonal surface, as they are meant to face. */
struct Facets
{
  insideout::FacetComplex Surface;
  std::vector<vtkIdType> Cells; ///< of the input, for each facet; none where no distance is asked

  /** As the constructor of InputWindingNumber. */
  Facets(vtkPolyData* input, const SurfaceOptions& options, insideout::Monitor& monitor,
    std::vector<std::string>& warnings);
};

/** The winding number of a surface; of lines without polygons that of the curve in their plane, at
 * the places above and below it too; of points without both that of the cloud. */
class InputWindingNumber
{
public:
  /**
   * The winding number of the facets that count in a surface, which is neither resolved nor meshed.
   *
   * @param[in,out] warnings gains what was passed over or looks wrong
   * @throws insideout::Error that names the cell or point at fault
   */
  InputWindingNumber(vtkPolyData* input, const SurfaceOptions& options, insideout::Monitor& monitor,
    std::vector<std::string>& warnings);

  /** For a piece; without its distance. */
  InputWindingNumber(
    const SurfaceChunk& piece, const SurfaceOptions& options, insideout::Monitor& monitor);

  /** The distance of a piece alone. @param exponent that of the whole surface's points */
  InputWindingNumber(const SurfaceChunk& piece, int exponent);

  /** As of SurfaceWindingNumber. */
  double At(const insideout::Point& p) const;
  std::vector<double> At(const std::vector<insideout::Point>& points, insideout::Monitor& monitor,
    const insideout::ProgressRange& progress = { insideout::Stages::WindingNumbers, 0, 1 }) const;
  insideout::Point Gradient(const insideout::Point& p) const;

  /** As of SurfaceWindingNumber. False, and nothing done, for a curve or cloud. */
  bool InGrid(const insideout::GridPlaces& grid, std::optional<double> sideOf,
    const insideout::SliceVisitor& visit, insideout::Monitor& monitor,
    const insideout::ProgressRange& progress) const;

  ///@{
  /** As of SurfaceDistance; only where the options ask for it. */
  NearestPoint NearestTo(const insideout::Point& p) const;
  std::vector<NearestPoint> NearestTo(const std::vector<insideout::Point>& points,
    insideout::Monitor& monitor, const insideout::ProgressRange& progress) const;
  ///@}

private:
  void OfCurve(vtkPolyData* input, const SurfaceOptions& options, insideout::Monitor& monitor,
    std::vector<std::string>& warnings);
  void OfCloud(vtkPolyData* input, const SurfaceOptions& options, insideout::Monitor& monitor,
    std::vector<std::string>& warnings);
  NearestPoint InCells(const insideout::SurfaceDistance::Nearest& nearest) const;

  std::unique_ptr<const insideout::SurfaceWindingNumber> Surface; ///< one of the three
  std::unique_ptr<const insideout::CurveWindingNumber> Curve;
  std::unique_ptr<const insideout::CloudWindingNumber> Cloud;
  std::unique_ptr<const insideout::SurfaceDistance> Distance;
  std::vector<insideout::Id> WholeFacets; ///< of a piece: those that the distance knows
  std::vector<vtkIdType> CellOfFacet;     ///< of those that the distance knows
};
} // namespace vtkInsideOut
