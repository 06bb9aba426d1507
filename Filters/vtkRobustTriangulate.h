// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkRobustTriangulate
 * @brief   from broken outlines in a plane to triangles of the area that they mean
 *
 * Takes a vtkPolyData in any plane: lines and polylines, closed or open, whose direction counts; or
 * polygons and strips, whose edges all count and whose interiors may overlap. Outlines may cross,
 * overlap and have gaps. Segments are cut where they meet, and the convex hull is triangulated so
 * that each segment is a union of edges. The triangles are labelled inside or outside by the
 * winding number of the outlines and a graph cut, as vtkRobustTetrahedralize does it in space.
 * Every input point keeps its exact coordinates.
 *
 * Output 0, the solid: vtkTriangle with the cell arrays w, Inside, RegionId, and FacetIds and
 * FacetMultiplicity of 3 components (see vtkConstrainedDelaunay3D). Output 1, its boundary:
 * polylines with the inside on their left, and the cell arrays vtkOriginalCellIds, Turned and
 * BoundaryTag. Output 2, the outliers: polylines that are no edge of a triangle inside, with
 * OutlierReason (see vtkRobustTetrahedralize). Outputs 3 and 4 are made with GenerateHull: all
 * triangles of the convex hull, with w, Inside and RegionId; and the input as polylines that meet
 * in shared points only, with FacetMultiplicity after Orientation is applied. All carry the input's
 * point data and vtkOriginalPointIds, the lines its cell data.
 *
 * Field data of output 0: LeftOutCellIds, TurnedCellIds, and
 * - RegionArea, RegionCenterOfMass (double, field data): area and center of each region, density 1
 *
 * Statistics are those of vtkRobustTetrahedralize, with Area instead of Volume. Refine adds
 * AddedPoints, SurfacePoints, RefinedCells, MinAngle, Angle1Percent and MaxAngle, and the same
 * angles before refinement, by names that begin with Before. If a curve is open, w is evaluated in
 * the new triangles.
 *
 * GetSegmentation() returns the stage with the options of the cut, GetRefinement() that of the
 * refinement; a change of a stage modifies this filter. The filter keeps the hull of its input:
 * such a change does not triangulate again.
 *
 * Errors, which name the culprit, leave all outputs empty.
 *
 * @sa vtkRobustTetrahedralize vtkGraphCutSegmentation vtkRefineTetrahedra
 */
#ifndef vtkRobustTriangulate_h
#define vtkRobustTriangulate_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutCounting.h"      // for the options of counting
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkSmartPointer.h"           // for the stages
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkGraphCutSegmentation;
class vtkPolyData;
class vtkRefineTetrahedra;

class VTKFILTERSINSIDEOUT_EXPORT vtkRobustTriangulate : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkRobustTriangulate* New();
  vtkTypeMacro(vtkRobustTriangulate, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether an input is for this filter rather than for vtkRobustTetrahedralize: lines without
   * polygons, or polygons that lie in a plane, exactly or up to rounding in double precision.
   */
  static bool IsInAPlane(vtkPolyData* input);

  ///@{
  /** The outputs beside the solid: its boundary (1), the outliers (2), and with GenerateHull the
   * hull (3) and the resolved lines (4). */
  vtkPolyData* GetBoundary();
  vtkPolyData* GetOutliers();
  vtkUnstructuredGrid* GetHull();
  vtkPolyData* GetResolvedLines();
  ///@}

  ///@{
  /**
   * The stage with the options of the cut: Gamma, Sigma, DataTerm, ConstrainFacets, NonManifold,
   * LargestRegions, MinimumRegionVolume (an area here), SeededRegions, FillCavities (holes here)
   * and Topology. Its inputs, its outputs and its ExtractInside are not used. Setting null does
   * nothing.
   */
  void SetSegmentation(vtkGraphCutSegmentation* segmentation);
  vtkGraphCutSegmentation* GetSegmentation();
  ///@}

  ///@{
  /**
   * The stage with the options of Refine: EdgeLength, Grading, MaximumVolume (an area here) and
   * SurfaceTreatment. KEPT: the boundary and all lines at inside triangles stay. SPLIT: they are
   * cut, so that no angle is below 20.7 degrees except at sharp corners; a warning tells where such
   * corners are too close to each other. AUTOMATIC: SPLIT where EdgeLength is given, else KEPT.
   * REMESHED and QuadraticCells are errors. Its inputs and outputs are not used. Setting null does
   * nothing.
   */
  void SetRefinement(vtkRefineTetrahedra* refinement);
  vtkRefineTetrahedra* GetRefinement();
  ///@}

  ///@{
  /** The most common options of the stages. */
  void SetGamma(double gamma);
  double GetGamma();
  void SetConstrainFacets(bool constrain);
  bool GetConstrainFacets();
  vtkBooleanMacro(ConstrainFacets, bool);
  void SetNonManifold(int nonManifold);
  int GetNonManifold();
  void SetEdgeLength(double length);
  double GetEdgeLength();
  ///@}

  ///@{
  /** Fill outputs 3 and 4: the hull, with w and Inside, and the resolved lines. Default off. */
  vtkSetMacro(GenerateHull, bool);
  vtkGetMacro(GenerateHull, bool);
  vtkBooleanMacro(GenerateHull, bool);
  ///@}

  ///@{
  /** Replace the triangles inside by better ones, as the options of refinement say. Default off. */
  vtkSetMacro(Refine, bool);
  vtkGetMacro(Refine, bool);
  vtkBooleanMacro(Refine, bool);
  ///@}

  ///@{
  /** Cell array of the input that selects the cells kept by ConstrainFacets: those where it is not
   * 0. Default empty: all. */
  vtkSetStdStringFromCharMacro(ConstrainedFacetsArrayName);
  vtkGetCharFromStdStringMacro(ConstrainedFacetsArrayName);
  ///@}

  ///@{
  /**
   * Optional second input: seeds, points that must be inside or outside, by their point array
   * Inside (1 or 0), as for vtkRobustTetrahedralize.
   */
  void SetSeedsData(vtkDataObject* seeds);
  void SetSeedsConnection(vtkAlgorithmOutput* output);
  ///@}

  ///@{
  /** How the input is counted: vtkInsideOutCounting.h describes these options. */
  vtkInsideOutOrientationMacro() vtkInsideOutMergeToleranceMacro()
    vtkInsideOutCountDuplicatesMacro() vtkInsideOutNonParticipatingMacro()
    ///@}

    ///@{
    /**
     * Cell array of the input that tags the boundary, one integer or string per cell. Default
     * empty: tags are groups, materials or blocks. The tags become the boundary's array
     * BoundaryTag; see vtkRobustTetrahedralize.
     */
    vtkSetStdStringFromCharMacro(TagArrayName);
  vtkGetCharFromStdStringMacro(TagArrayName);
  ///@}

  /** The latest change of the filter and of its stages. */
  vtkMTimeType GetMTime() override;

protected:
  vtkRobustTriangulate();
  ~vtkRobustTriangulate() override;

  void ReportReferences(vtkGarbageCollector* collector) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkGraphCutSegmentation> Segmentation;
  vtkSmartPointer<vtkRefineTetrahedra> Refinement;
  bool GenerateHull = false;
  bool Refine = false;
  std::string ConstrainedFacetsArrayName;
  std::string TagArrayName;

private:
  void CheckOptions();

  class Cache;
  std::unique_ptr<Cache> Hulls;

  vtkRobustTriangulate(const vtkRobustTriangulate&) = delete;
  void operator=(const vtkRobustTriangulate&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
