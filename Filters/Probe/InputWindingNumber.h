// SPDX-License-Identifier: GPL-3.0-or-later
/** @file The winding number of a raw vtkPolyData, for the classes without a mesh. */
#pragma once

#include "Clouds/CloudWindingNumber.h"
#include "Common/Stages.h"
#include "Data/VtkClasses.h"
#include "Distance/SurfaceDistance.h"
#include "In/StageParameters.h"
#include "Planar/CurveWindingNumber.h"
#include "WindingNumber/SurfacePieces.h"
#include "WindingNumber/SurfaceWindingNumber.h"

#include <vtkType.h>

#include <memory>

namespace vtkInsideOut
{
struct SurfaceOptions
{
  insideout::CountedChainParameters Chain;
  insideout::Orientation Orientation;
  insideout::WindingNumberParameters WindingNumber;
  std::string NonParticipating; ///< cell array, not 0 for cells that do not count
  std::string Areas = "Area";   ///< point array of a cloud; without it areas are estimated
  bool Distance = false;        ///< whether to compute the distance, too
  bool CountsAsGiven = false;   ///< each polygon, also copies and both sides of two-sided parts
};

/** The point of a surface nearest to a query point. Facets are numbered in the whole surface. */
struct NearestPoint : insideout::SurfaceDistance::Nearest
{
  vtkIdType Cell; ///< cell of the input; -1 if the place is not finite
};

/** A chunk of a surface: facets of the whole, then caps. */
struct SurfaceChunk : insideout::CountedPiece
{
  std::vector<vtkIdType> Cells; ///< input cell per facet; empty if no distance is wanted
};

/** The common options of those classes. */
template <typename Class>
SurfaceOptions ReadSurfaceOptions(Class* object)
{
  SurfaceOptions options;
  options.Chain = ChainParametersOf(object);
  options.Orientation = OrientationOf(object);
  options.NonParticipating = object->GetNonParticipatingArrayName();
  return options;
}

/** The facets of a polygonal surface that count, oriented. */
struct Facets
{
  insideout::FacetComplex Surface;
  std::vector<vtkIdType> Cells; ///< of the input, for each facet; empty if no distance is wanted

  /** As the constructor of InputWindingNumber. */
  Facets(vtkPolyData* input, const SurfaceOptions& options, insideout::Monitor& monitor,
    std::vector<std::string>& warnings);
};

/** The winding number of a surface; for lines without polygons that of the planar curve, projected
 * to its plane; for points without both that of the cloud. */
class InputWindingNumber
{
public:
  /**
   * The winding number of a surface's facets that count, without resolving or meshing.
   *
   * @param[in,out] warnings gains skipped or suspicious cells
   * @throws insideout::Error that names the invalid cell or point
   */
  InputWindingNumber(vtkPolyData* input, const SurfaceOptions& options, insideout::Monitor& monitor,
    std::vector<std::string>& warnings);

  /** For a piece with its boundary, without its distance. */
  InputWindingNumber(const insideout::CountedPiece& piece, const SurfaceOptions& options,
    insideout::Monitor& monitor);

  /** The distance of a chunk only. @param exponent that of the whole surface's points */
  InputWindingNumber(const SurfaceChunk& piece, int exponent);

  /** As of SurfaceWindingNumber. */
  double At(const insideout::Point& p) const;
  std::vector<double> At(const std::vector<insideout::Point>& points, insideout::Monitor& monitor,
    const insideout::ProgressRange& progress = { insideout::Stages::WindingNumbers, 0, 1 }) const;
  insideout::Point Gradient(const insideout::Point& p) const;

  /** As of SurfaceWindingNumber. Returns false, without effect, for a curve or cloud. */
  bool InGrid(const insideout::GridPlaces& grid, std::optional<double> sideOf,
    const insideout::SliceVisitor& visit, insideout::Monitor& monitor,
    const insideout::ProgressRange& progress) const;

  ///@{
  /** As of SurfaceDistance; only if the options request it. */
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
  std::vector<insideout::Id> WholeFacets; ///< of a chunk: facets known to the distance
  std::vector<vtkIdType> CellOfFacet;     ///< of facets known to the distance
};
} // namespace vtkInsideOut
