// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkRobustTetrahedralize
 * @brief   from a broken surface to tetrahedra of the solid that it means
 *
 * Takes any triangle or polygon surface, with holes, self-intersections, duplicates or non-manifold
 * edges. Facets are cut where they cross, and the convex hull is tetrahedralized so that each facet
 * is a union of faces. The tetrahedra are labelled inside or outside by the generalized winding
 * number and a graph cut (Jacobson, Kavan and Sorkine-Hornung 2013). Every input vertex is a point
 * of the hull, with its exact coordinates. Lines, and polygons in one plane, are errors: use
 * vtkRobustTriangulate.
 *
 * Output 0, the solid: vtkTetra with Inside, the arrays of vtkGeneralizedWindingNumber and
 * - RegionId (int, cells): the part connected through faces, or the body, numbered from 0 by first
 *   cell; -1 outside
 * - RegionVolume, RegionCenterOfMass, RegionInertia (double, field data): mass of each region,
 *   density 1; inertia XX, YY, ZZ, XY, YZ, XZ about its own center
 *
 * Output 1, its boundary: triangles, oriented outward and watertight.
 * - vtkOriginalCellIds (vtkIdType, cells): the input's cell, -1 where a hole was closed
 * - Turned (unsigned char, cells): 1 where that cell was turned over, see Orientation
 * - BoundaryTag (int, cells): that cell's group, material, solid, block or value of TagArrayName
 * - BoundaryTagNames (string, field data): the names of these tags
 *
 * Output 2, the outliers: the pieces of input facets that are no face of a cell inside.
 * - OutlierReason (unsigned char, cells): 0 segmented as outside, 1 lost by the mesh, 2 left out by
 *   the resolver, 3 degenerate
 * - OutlierReasonNames (string, field data): these reasons in words
 *
 * Output 3, made with GenerateHull: all cells of the convex hull, as they were before NonManifold
 * Split, SeparateOverlaps and Refine. All outputs carry the input's point data and
 * vtkOriginalPointIds, the surfaces its cell data. Normals and texture coordinates stay active.
 *
 * Three stages have further options: GetWindingNumber() those of the surface and its winding
 * number, GetSegmentation() those of the cut, GetRefinement() those of the refinement. A change of
 * a stage modifies this filter. The most common options are methods of this filter, too.
 *
 * A surface without tags has one tag, surface. Triangles that close a hole have the last tag, hole
 * (hole_2 where the input has it). Slabs and their rims have the tag of their sheet's facet.
 *
 * BodyArrayName or BlocksAreBodies assigns the facets to several bodies, which become one mesh.
 * Each body is oriented, has its winding number and is cut as if it were alone; self-intersections
 * of all are resolved together. Cells inside any body are the solid, and w is the sum over the
 * bodies. Output 1 is the boundary of all, followed by the interfaces between regions, each
 * triangle once. A tag names both sides, as in "bone|fat" and "fat|outside"; with TagArrayName,
 * triangles with nothing outside have its tags instead. RegionId follows from RegionRule.
 * - BodyW, InBody (double and unsigned char, cells): winding number, and 1 inside, in a component
 *   for each body, of its name
 * - BodyNames, BodyVolume (string and double, field data): each body's name, and its volume alone
 *   before refinement
 * - RegionNames, RegionBodies (string and unsigned char, field data): the bodies of each region, as
 *   names joined by "+", and as a component for each body
 * - RegionIds (int, cells of output 1, 2 components): regions behind and in front of the triangle,
 *   -1 for outside
 * - BodyIds (int, cells of outputs 1 and 2): with BlocksAreBodies, the block
 *
 * Facets that no cell of their own bodies touches are outliers. The point array Body of the seeds
 * (a string or a number) names the body of each; a seed that is to be outside may name none.
 * LargestRegions and Topology apply to each body. MergeCoplanarPieces, SplitSeams, SeparateOverlaps
 * and NONMANIFOLD_SPLIT are errors then.
 *
 * The filter keeps the hull of its input: a change of the segmentation, its seeds or the refinement
 * does not mesh again. ReleaseDataFlagOn() releases that memory.
 *
 * Statistics are those of the stages, and more. SharedPoints: points that NONMANIFOLD_SPLIT copied
 * on the boundary only. SeparateOverlaps: Overlaps, SeparatedOverlaps, CopiedCells. KeptByOptions:
 * 1 if options keep the surface. Outliers: OutlierFacets, a count for each reason, and LostShare,
 * their share of the surface's area. Solid, with density 1 and in units of the input: Regions,
 * Volume, CenterOfMassX to Z. The inertia tensor about that center is InertiaXX to InertiaXZ (XX is
 * the integral of y^2 + z^2, XY of -x y).
 * Topology: SolidComponents, SolidTunnels and SolidCavities, the Betti numbers of the closed cells;
 * SolidEulerCharacteristic; the same with Boundary instead of Solid; Genus, half of
 * BoundaryTunnels.
 *
 * Refine replaces the solid's cells and arrays, see vtkRefineTetrahedra; InsideCells counts the
 * cells before. If a body is open, its w is evaluated in the new cells. Unless SurfaceTreatment is
 * KEPT output 1 is their boundary, with interpolated point data.
 *
 * If no cell is inside, a warning gives the range of w, the likely cause and the option to set.
 * Errors, which name the culprit, leave all outputs empty.
 *
 * @sa vtkGeneralizedWindingNumber vtkGraphCutSegmentation vtkRefineTetrahedra vtkRobustTriangulate
 */
#ifndef vtkRobustTetrahedralize_h
#define vtkRobustTetrahedralize_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutCounting.h"      // for TouchTolerance
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkSmartPointer.h"           // for the stages
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory>
#include <string>

namespace vtkInsideOut
{
class AlgorithmMonitor;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkGeneralizedWindingNumber;
class vtkGraphCutSegmentation;
class vtkPolyData;
class vtkRefineTetrahedra;

class VTKFILTERSINSIDEOUT_EXPORT vtkRobustTetrahedralize : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkRobustTetrahedralize* New();
  vtkTypeMacro(vtkRobustTetrahedralize, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Why a facet is an outlier: the cell array OutlierReason of output 2. */
  enum OutlierReasonType
  {
    OUTLIER_BY_ENERGY = 0, ///< the segmentation put the cells on both sides outside
    OUTLIER_LOST = 1,      ///< the tetrahedra do not follow the facet
    OUTLIER_LEFT_OUT = 2,  ///< it still crossed others when resolving gave up
    OUTLIER_DEGENERATE = 3 ///< it has no area
  };

  ///@{
  /** Outputs 1, 2 and 3, and a summary of the statistics in six lines. */
  vtkPolyData* GetBoundary();
  vtkPolyData* GetOutliers();
  vtkUnstructuredGrid* GetHull();
  std::string GetSummary();
  ///@}

  ///@{
  /** The stages with further options. Their inputs and outputs are not used, but for the background
   * of GetRefinement(), nor is their ExtractInside. Setting null does nothing. */
  void SetWindingNumber(vtkGeneralizedWindingNumber* windingNumber);
  vtkGeneralizedWindingNumber* GetWindingNumber();
  void SetSegmentation(vtkGraphCutSegmentation* segmentation);
  vtkGraphCutSegmentation* GetSegmentation();
  void SetRefinement(vtkRefineTetrahedra* refinement);
  vtkRefineTetrahedra* GetRefinement();
  ///@}

  ///@{
  /** Options of GetWindingNumber(). */
  void SetOrientation(int orientation);
  int GetOrientation();
  void SetThicken(double thickness);
  double GetThicken();
  void SetNonParticipatingArrayName(const char* name);
  const char* GetNonParticipatingArrayName();
  ///@}

  ///@{
  /** An option of GetWindingNumber() that also closes gaps between bodies, with a warning for each
   * kind. A facet is moved into the plane of a facet of an earlier body if all its corners are
   * within this distance. Cells between two bodies that are nowhere farther than it from either
   * join the last body in the order of Priority (statistics GapCells, GapVolume). */
  void SetMergeTolerance(double tolerance);
  double GetMergeTolerance();
  ///@}

  ///@{
  /** Options of GetSegmentation(), described there. NONMANIFOLD_SPLIT requires one body and, with
   * Refine, SurfaceTreatment KEPT; it excludes MergeCoplanarPieces and SplitSeams. If the cells
   * around a touching point are all joined, as between two cavities, only the boundary has copies
   * of the point; a warning counts them. */
  void SetGamma(double gamma);
  double GetGamma();
  void SetConstrainFacets(bool constrain);
  bool GetConstrainFacets();
  vtkBooleanMacro(ConstrainFacets, bool);
  void SetNonManifold(int nonManifold);
  int GetNonManifold();
  ///@}

  ///@{
  /** An option of GetRefinement(), described there. */
  void SetEdgeLength(double length);
  double GetEdgeLength();
  ///@}

  ///@{
  /** Fill output 3, the hull: all cells, with w and Inside. Default off. */
  vtkSetMacro(GenerateHull, bool);
  vtkGetMacro(GenerateHull, bool);
  vtkBooleanMacro(GenerateHull, bool);
  ///@}

  /** For old state files of ParaView: off generates the hull, with a warning. On does nothing. */
  void SetExtractInside(bool extract);

  ///@{
  /** Cell array of the input that selects the cells kept by ConstrainFacets: those where it is not
   * 0. Default empty: all. */
  vtkSetStdStringFromCharMacro(ConstrainedFacetsArrayName);
  vtkGetCharFromStdStringMacro(ConstrainedFacetsArrayName);
  ///@}

  ///@{
  /**
   * Give each of two overlapping layers of the solid (w near 2) its own cells, so that a limb can
   * be pulled out of another. Default off: the solid fills every place once. Copies have the arrays
   * of their cells. Overlaps of more layers, and layers that cannot be distinguished by their
   * faces, stay glued; a warning counts them. Requires one body and, with Refine, SurfaceTreatment
   * KEPT; excludes MergeCoplanarPieces and SplitSeams.
   */
  vtkSetMacro(SeparateOverlaps, bool);
  vtkGetMacro(SeparateOverlaps, bool);
  vtkBooleanMacro(SeparateOverlaps, bool);
  ///@}

  ///@{
  /** Optional second input: seeds, points that must be inside or outside, by their point array
   * Inside (1 or 0). If several cells contain a seed, the one of the lowest id gets its label. All
   * blocks of a composite data set count. Seeds take precedence over ConstrainFacets and
   * NonManifold; a warning counts conflicts. */
  void SetSeedsData(vtkDataObject* seeds);
  void SetSeedsConnection(vtkAlgorithmOutput* output);
  ///@}

  ///@{
  /** Join the pieces of an input triangle if all of them lie on the boundary. Default off: the
   * triangles of the boundary are faces of the cells. Pieces stay if another triangle needs the
   * points between them. The boundary stays watertight. */
  vtkSetMacro(MergeCoplanarPieces, bool);
  vtkGetMacro(MergeCoplanarPieces, bool);
  vtkBooleanMacro(MergeCoplanarPieces, bool);
  ///@}

  ///@{
  /** Give the boundary a copy of a point for each texture coordinate and normal that the input has
   * there. Default off: one point, with the data of the lowest id. Each triangle of the boundary
   * then has the data of the input triangle that it lies on; the boundary is watertight by
   * coordinates, not by ids. The statistic SeamPoints counts such points of the input. */
  vtkSetMacro(SplitSeams, bool);
  vtkGetMacro(SplitSeams, bool);
  vtkBooleanMacro(SplitSeams, bool);
  ///@}

  ///@{
  /**
   * Make only the surfaces; the boundary of a closed input is found without tetrahedra, at the
   * speed of resolving self-intersections. Default off. Output 0 has no cells then. Tetrahedra are
   * made nevertheless if the input is open, has facets that could not be resolved, or has nothing
   * inside; for bodies, GenerateHull, Refine, seeds, ConstrainFacets, NonManifold,
   * SeparateOverlaps, MembranesSeparateRegions, a choice of regions, FillCavities, Topology and
   * DataTerm; and for a Gamma or Sigma above the default. The statistic Tetrahedra says whether
   * they were made (1 or 0). Without tetrahedra the statistics are those of the input and of the
   * boundary, and Volume.
   */
  vtkSetMacro(SurfaceOnly, bool);
  vtkGetMacro(SurfaceOnly, bool);
  vtkBooleanMacro(SurfaceOnly, bool);
  ///@}

  ///@{
  /**
   * Cell array of the input that tags the boundary, one integer or string per cell. Default empty:
   * tags are groups, materials, solids of an STL file, or blocks. Strings are numbered in the order
   * of their first cells. Integers keep their order. Their names come from the matching field array
   * of strings (GroupNames with GroupIds, PartNames with Part), or are the numbers; floats must be
   * whole. A point array with equal values in each cell is accepted, too. Empty: the first of
   * BoundaryTag, GroupIds, MaterialIds, STLSolidLabeling that differs between cells.
   */
  vtkSetStdStringFromCharMacro(TagArrayName);
  vtkGetCharFromStdStringMacro(TagArrayName);
  ///@}

  ///@{
  /**
   * Tags by geometry, "NAME=CONDITION; NAME=CONDITION" and so on. Conditions are "normal X Y Z
   * [DEGREES]", "box X Y Z X Y Z" and "sphere X Y Z RADIUS". Others are "plane X Y Z NX NY NZ
   * [DISTANCE]", "face X Y Z [DEGREES]" and "faces [DEGREES]". The last are "nearest X Y Z" and
   * "array NAME"; & joins several. Default empty: none. A triangle of the boundary gets the name of
   * the last rule that it satisfies, else its tag from the input. A rule without a triangle gives a
   * warning. Conditions: "normal": the outward normal is within 10 degrees of the direction. "box"
   * and "sphere" contain the triangle's center. "plane": the corners are within a millionth of the
   * diagonal. "face": the face nearest to the point; faces are separated by edges of over 30
   * degrees. "faces": every face, as NAME_1, NAME_2. "nearest": of the points of all such rules
   * this one is nearest to the center. "array": this cell array of the input is not 0.
   */
  vtkSetStdStringFromCharMacro(TagRules);
  vtkGetCharFromStdStringMacro(TagRules);
  ///@}

  ///@{
  /**
   * Cell array of the input with the body of each cell, one integer or string, or the two bodies
   * that it separates. The bodies become one mesh, with a region for each. Default empty: one body.
   * Bodies are numbered and named as tags are, for example by GroupIds of an OBJ or STL file. Two
   * integers are the bodies behind and in front of a cell, 0 for none (BoundaryLabels of
   * vtkSurfaceNets3D); cells that disagree with their neighbors on that are turned over.
   */
  vtkSetStdStringFromCharMacro(BodyArrayName);
  vtkGetCharFromStdStringMacro(BodyArrayName);
  ///@}

  ///@{
  /**
   * Make one mesh of a composite input, whose blocks are the bodies. Default off: each block
   * becomes its own solid. With one mesh, vtkOriginalPointIds count the points of one block after
   * the other, and vtkOriginalCellIds the vertices of all blocks, then lines, polygons and strips.
   * The partitions of a vtkPartitionedDataSet are one block.
   */
  void SetBlocksAreBodies(bool blocksAreBodies);
  vtkGetMacro(BlocksAreBodies, bool);
  vtkBooleanMacro(BlocksAreBodies, bool);
  ///@}

  ///@{
  /** Number of blocks of a composite data set that are meshed at once, each by one thread. Default
   * 1. Range 1 to infinity. The solids are the same, bit by bit. At most the number of threads
   * (OMP_NUM_THREADS). Each block takes the memory that it takes alone; up to eight finished hulls
   * per thread wait in memory. Without effect on a single surface and with BlocksAreBodies. */
  vtkInsideOutSetRangeMacro(BlocksAtOnce, int, 1, VTK_INT_MAX);
  vtkGetMacro(BlocksAtOnce, int);
  ///@}

  ///@{
  /**
   * Tetrahedralize parts of the surface with disjoint bounding boxes separately, by several threads
   * at once, without cells between them. Default off. All pieces with open edges or in a plane are
   * one part. The statistic PartsApart counts the parts. The solid and boundary of a closed surface
   * are the same, except for points added on it (SurfaceSteinerPoints); tetrahedra, energies and
   * the order of regions and points are different. Nothing is inside beyond the hulls of the parts
   * (output 3); a warning counts seeds there. TimeBudget applies to all parts together,
   * MemoryBudget to each. Requires one body and TOPOLOGY_ANY.
   */
  vtkSetMacro(PartsApart, bool);
  vtkGetMacro(PartsApart, bool);
  vtkBooleanMacro(PartsApart, bool);
  ///@}

  /** The regions of a mesh of several bodies. */
  enum RegionRuleType
  {
    BY_PRIORITY = 0, ///< a region for each body; in overlaps that of the first body in Priority
    ALL = 1          ///< a region for each combination of bodies that occurs
  };

  ///@{
  /** Regions of a mesh of several bodies. BY_PRIORITY: one for each body; a cell in several bodies
   * belongs to the first in Priority. ALL: one for each combination of bodies that occurs. Default
   * BY_PRIORITY. With ALL the field array RegionBodies has the bodies of each region. */
  vtkInsideOutSetRangeMacro(RegionRule, int, BY_PRIORITY, ALL);
  vtkGetMacro(RegionRule, int);
  ///@}

  ///@{
  /** Names of bodies, separated by commas: a cell in several bodies belongs to the first of them.
   * Default empty: none is named. Bodies that are not named follow, the inner of two nested ones
   * first, else in their own order; a warning says where nesting decides. A comma within a name is
   * written \, and a backslash \\. An unknown or repeated name is an error. */
  vtkSetStdStringFromCharMacro(Priority);
  vtkGetCharFromStdStringMacro(Priority);
  ///@}

  ///@{
  /** Let membranes, and other facets that do not count in w, separate regions, as horizons separate
   * the layers of a block. Default off. In output 1 their interfaces follow the boundary, with
   * RegionIds. Requires one body; excludes MergeCoplanarPieces, SplitSeams, SeparateOverlaps,
   * NONMANIFOLD_SPLIT. */
  vtkSetMacro(MembranesSeparateRegions, bool);
  vtkGetMacro(MembranesSeparateRegions, bool);
  vtkBooleanMacro(MembranesSeparateRegions, bool);
  ///@}

  ///@{
  /**
   * Replace the cells of the solid by better ones, as the options of refinement say. Default off.
   * Points that stay keep their vtkOriginalPointIds. Where the surface is remeshed, edges between
   * triangles of different tags stay.
   */
  vtkSetMacro(Refine, bool);
  vtkGetMacro(Refine, bool);
  vtkBooleanMacro(Refine, bool);
  ///@}

  /** The latest change of the filter and of its stages. */
  vtkMTimeType GetMTime() override;
  vtkInsideOutTouchToleranceMacro() // described in vtkInsideOutCounting.h

    protected : vtkRobustTetrahedralize();
  ~vtkRobustTetrahedralize() override;

  void ReportReferences(vtkGarbageCollector* collector) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkGeneralizedWindingNumber> WindingNumber;
  vtkSmartPointer<vtkGraphCutSegmentation> Segmentation;
  vtkSmartPointer<vtkRefineTetrahedra> Refinement;
  std::string ConstrainedFacetsArrayName;
  bool SeparateOverlaps = false;
  bool GenerateHull = false;
  bool MergeCoplanarPieces = false;
  bool SplitSeams = false;
  bool SurfaceOnly = false;
  std::string TagArrayName;
  std::string TagRules;
  std::string BodyArrayName;
  bool BlocksAreBodies = false;
  int BlocksAtOnce = 1;
  bool PartsApart;
  int RegionRule = BY_PRIORITY;
  std::string Priority;
  bool MembranesSeparateRegions = false;
  bool Refine = false;

private:
  void MeshBlocksAhead(vtkInsideOut::AlgorithmMonitor& monitor);
  bool PartsSolid();
  void CheckOptions();
  void CheckBodies();

  class Cache;
  std::unique_ptr<Cache> Hulls;

  vtkRobustTetrahedralize(const vtkRobustTetrahedralize&) = delete;
  void operator=(const vtkRobustTetrahedralize&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
