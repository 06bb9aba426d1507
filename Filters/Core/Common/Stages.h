// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/**
 * The names of stages in reports to a Monitor, for users. A filter lists the stages that it runs.
 */
namespace insideout::Stages
{
constexpr const char* Reading = "reading";                                 ///< ReadSurface
constexpr const char* Validating = "validating";                           ///< CountFacets
constexpr const char* Orienting = "orienting";                             ///< OrientFacets
constexpr const char* FindingIntersections = "finding self-intersections"; ///< FindIntersections
constexpr const char* Resolving = "resolving self-intersections";     ///< ResolveSelfIntersections
constexpr const char* TracingIntersections = "tracing intersections"; ///< TraceIntersections
constexpr const char* Tetrahedralizing = "tetrahedralizing";          ///< ConstrainedDelaunay
constexpr const char* Triangulating = "triangulating";                ///< TriangulateHull
constexpr const char* WindingNumbers = "winding numbers";             ///< in cells, or anywhere
constexpr const char* Distances = "distances";                        ///< SurfaceDistance
constexpr const char* Segmenting = "segmenting";       ///< SegmentMesh, GraphCutSegmentation
constexpr const char* Extracting = "extracting";       ///< all algorithms of the room Output
constexpr const char* Refining = "refining";           ///< RefineTetrahedra, RefineTriangles
constexpr const char* Layering = "making layers";      ///< MakeBoundaryLayers
constexpr const char* Measuring = "measuring quality"; ///< QualityOfMesh
constexpr const char* Writing = "writing";             ///< OutputFile
} // namespace insideout::Stages
