// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkRobustTetrahedralize
 * @brief   from a broken surface to tetrahedra of the solid that it means
 *
 * Takes any triangle or polygon surface, with holes, self-intersections, duplicates or non-manifold
 * edges. Facets are cut where they cross, and the convex hull is tetrahedralized so that each of
 * them is a union of faces. The tetrahedra are labelled inside or outside by the generalized
 * winding number and a graph cut (Jacobson, Kavan and Sorkine-Hornung 2013). Every input vertex is
 * a point of the hull, with its exact coordinates. Lines, and polygons in one plane, are errors:
 * they are for vtkRobustTriangulate.
 *
 * Output 0, the solid: vtkTetra with Inside, the arrays of vtkGeneralizedWindingNumber and
 * - RegionId (int, cells): part that faces connect, or body, from 0 by its first cell; -1 outside
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
 * - OutlierReason (unsigned char, cells): 0 segmented as outside, 1 lost by the mesh, 2 left out
 *   by the resolver, 3 degenerate
 * - OutlierReasonNames (string, field data): these reasons in words
 *
 * Output 3, made with GenerateHull: all cells of the convex hull, as they were before NonManifold
 * Split, SeparateOverlaps and Refine. All outputs carry the input's point data and
 * vtkOriginalPointIds, the surfaces its cell data. Normals and texture coordinates stay active.
 *
 * The options of the surface and its winding number belong to the filter that GetWindingNumber()
 * hands out, those of the cut to GetSegmentation(), those of the refinement to GetRefinement(). A
 * change there is a change of this filter, which has methods for those that most users set, too.
 *
 * A surface without tags has one tag, surface. Triangles that close a hole have the last tag, hole
 * (hole_2 where the input has it). Slabs and their rims have the tag of their sheet's facet.
 *
 * Several bodies become one mesh where BodyArrayName or BlocksAreBodies says which facets are
 * whose. Each body is oriented, has its winding number and is cut as if it were alone; all are
 * resolved together. Cells inside any body are the solid, and w is the sum over the bodies. Output
 * 1 is the boundary of all and, behind that, the interfaces between regions, each triangle once.
 * Tags are by both sides, as in "bone|fat" and "fat|outside", unless TagArrayName says what lies
 * outside. RegionId follows from RegionRule.
 * - BodyW, InBody (double and unsigned char, cells): winding number, and 1 inside, in a component
 *   for each body, of its name
 * - BodyNames, BodyVolume (string and double, field data): each body's name; volume of it alone,
 *   before refinement
 * - RegionNames, RegionBodies (string and unsigned char, field data): bodies of each region,
 *   joined by "+"; a component for each body
 * - RegionIds (int, cells of output 1, 2 components): regions behind and before it, -1 for outside
 * - BodyIds (int, cells of outputs 1 and 2): with BlocksAreBodies, the block
 *
 * Facets that no cell of their own bodies touches are outliers. The seeds' point array Body (a
 * string or a number) names their body; seeds outside may name none. LargestRegions and Topology
 * hold for each body. MergeCoplanarPieces, SplitSeams, SeparateOverlaps and NONMANIFOLD_SPLIT are
 * errors.
 *
 * The filter keeps the hull of its input: a change of the segmentation, its seeds or the refinement
 * does not mesh again. ReleaseDataFlagOn() saves that memory.
 *
 * Statistics are those of the stages, and more. SharedPoints: copies by NonManifold of the kind
 * Split that only the boundary has. SeparateOverlaps: Overlaps, SeparatedOverlaps, CopiedCells. The
 * outliers: OutlierFacets, a count for each reason, and LostShare of the surface's area. The solid:
 * Regions; with density 1 and in the units of the input Volume, CenterOfMassX to Z; the inertia
 * tensor about it, InertiaXX to InertiaXZ (XX is the integral of y^2 + z^2, XY of -x y). Topology:
 * SolidComponents, SolidTunnels and SolidCavities, the Betti numbers of the cells with all that
 * they touch in; SolidEulerCharacteristic; those of the boundary; Genus, half of BoundaryTunnels.
 *
 * Refine replaces the solid's cells and arrays, see vtkRefineTetrahedra; InsideCells counts those
 * before. Unless SurfaceTreatment is KEPT output 1 is their boundary, with interpolated point data.
 *
 * When no cell is inside there is a warning that gives the range of w, the likely cause and what to
 * set. Errors, which name the culprit, leave all outputs empty.
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
  /** Outputs 1, 2 and 3; six lines of the statistics: what was wrong, and what came out. */
  vtkPolyData* GetBoundary();
  vtkPolyData* GetOutliers();
  vtkUnstructuredGrid* GetHull();
  std::string GetSummary();
  ///@}

  ///@{
  /** The stages whose options this filter goes by. Their inputs and outputs are not used, nor are
   * their ExtractInside and SizingArrayName. Never null: setting null does nothing. */
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
  /** An option of GetWindingNumber(). It closes gaps between bodies, with a warning for each kind.
   * A facet all of whose corners are that near to the plane of a facet of an earlier body is moved
   * into it. Cells between bodies that are nowhere farther from either become cells of the last in
   * the order of Priority (statistics GapCells, GapVolume). */
  void SetMergeTolerance(double tolerance);
  double GetMergeTolerance();
  ///@}

  ///@{
  /** Options of GetSegmentation(), described there. NONMANIFOLD_SPLIT requires one body and, with
   * Refine, SurfaceTreatment KEPT; it excludes MergeCoplanarPieces and SplitSeams. Where cells
   * join all around what touches, as around two cavities, only the boundary has several points at
   * one location, whose cells share one; a warning counts them. */
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

  /** For older states of ParaView: off generates the hull, with a warning. On does nothing. */
  void SetExtractInside(bool extract);

  ///@{
  /** Cell array of the input that chooses the cells that ConstrainFacets keeps: those where it is
   * not 0. Default empty: all. */
  vtkSetStdStringFromCharMacro(ConstrainedFacetsArrayName);
  vtkGetCharFromStdStringMacro(ConstrainedFacetsArrayName);
  ///@}

  ///@{
  /**
   * Give each of two layers of the solid that overlap (w near 2) cells of its own, so that a limb
   * can be pulled out of another. Default off: the solid fills every place once. Both have the
   * arrays of the cells that they copy. Overlaps of more layers, and layers that their faces do not
   * tell apart, stay glued; a warning counts them. Requires one body and, with Refine,
   * SurfaceTreatment KEPT; excludes MergeCoplanarPieces and SplitSeams.
   */
  vtkSetMacro(SeparateOverlaps, bool);
  vtkGetMacro(SeparateOverlaps, bool);
  vtkBooleanMacro(SeparateOverlaps, bool);
  ///@}

  ///@{
  /** Optional second input: points that have to be inside or outside, by their array Inside (1 or
   * 0); all blocks of a composite one. The cell of the lowest id gets the label of a point that
   * several contain. Seeds win over ConstrainFacets and NonManifold; conflicts are warned about. */
  void SetSeedsData(vtkDataObject* seeds);
  void SetSeedsConnection(vtkAlgorithmOutput* output);
  ///@}

  ///@{
  /** Join the pieces of an input triangle on the boundary where all of it lies there. Default off:
   * the triangles of the boundary are faces of the cells, where there are cells. Pieces stay where
   * another triangle needs the points between. The boundary stays watertight. */
  vtkSetMacro(MergeCoplanarPieces, bool);
  vtkGetMacro(MergeCoplanarPieces, bool);
  vtkBooleanMacro(MergeCoplanarPieces, bool);
  ///@}

  ///@{
  /** Give the boundary a point for each of the input's texture coordinates and normals at one
   * location. Default off: one point, with the data of the lowest id. Every triangle of the
   * boundary then has the data of the input triangle that it lies on; it is watertight by
   * coordinates, not by ids. The statistic SeamPoints counts such points of the input. */
  vtkSetMacro(SplitSeams, bool);
  vtkGetMacro(SplitSeams, bool);
  vtkBooleanMacro(SplitSeams, bool);
  ///@}

  ///@{
  /**
   * Make only the surfaces; the boundary of a closed input is found without tetrahedra, at the
   * speed of resolving self-intersections. Default off. Output 0 has no cells then. Tetrahedra are
   * made all the same where the input is open, has facets that could not be resolved or nothing
   * inside; for bodies, GenerateHull, Refine, seeds, ConstrainFacets, NonManifold,
   * SeparateOverlaps, MembranesSeparateRegions, a choice of regions, FillCavities, Topology and
   * DataTerm; and for a Gamma or Sigma above the default. The statistic Tetrahedra is 1 or 0.
   * Without tetrahedra the statistics are those of the input and of the boundary, and Volume.
   */
  vtkSetMacro(SurfaceOnly, bool);
  vtkGetMacro(SurfaceOnly, bool);
  vtkBooleanMacro(SurfaceOnly, bool);
  ///@}

  ///@{
  /**
   * Cell array of the input that tags the boundary, one integer or string per cell. Default empty:
   * its groups, materials or solids do, or the blocks of a composite input. Strings are numbered in
   * the order of their first cells. Integers are in their own order, called by the field array of
   * strings that goes with the array (GroupNames with GroupIds, PartNames with Part), or else as
   * they are written; floats are whole. A point array with equal values in each cell will do, too.
   * Empty: the first of BoundaryTag, GroupIds, MaterialIds, STLSolidLabeling that differs by cell.
   */
  vtkSetStdStringFromCharMacro(TagArrayName);
  vtkGetCharFromStdStringMacro(TagArrayName);
  ///@}

  ///@{
  /**
   * Tags by geometry, "NAME=CONDITION; NAME=CONDITION" and so on. Conditions are "normal X Y Z
   * [DEGREES]", "box X Y Z X Y Z" and "sphere X Y Z RADIUS". Others are "plane X Y Z NX NY NZ
   * [DISTANCE]", "face X Y Z [DEGREES]" and "faces [DEGREES]". The last are "nearest X Y Z" and
   * "array NAME"; & joins several. Default
   * empty: none. A triangle of the boundary has the name of the last rule that it satisfies, else
   * its tag from elsewhere. A rule without a triangle gives a warning. Outward normals are within
   * 10 degrees of a direction. Centers are in a box or ball, corners in a plane, within a millionth
   * of the diagonal. A face lies between edges of over 30 degrees: the one next to a point, or
   * each, as NAME_1, NAME_2. A center belongs to the nearest of all points of "nearest". An array
   * of the input's cells is not 0.
   */
  vtkSetStdStringFromCharMacro(TagRules);
  vtkGetCharFromStdStringMacro(TagRules);
  ///@}

  ///@{
  /**
   * Cell array of the input that says which body each cell belongs to, one integer or string per
   * cell, or which two it lies between. All become one mesh, with a region for each. Default empty:
   * all is one body. Bodies are numbered and called as tags are: by GroupIds those of an OBJ or STL
   * file. Two integers are the bodies behind a cell and before it, 0 for none (BoundaryLabels of
   * vtkSurfaceNets3D); cells that disagree with their neighbors on that are turned over.
   */
  vtkSetStdStringFromCharMacro(BodyArrayName);
  vtkGetCharFromStdStringMacro(BodyArrayName);
  ///@}

  ///@{
  /**
   * Make one mesh of a composite input, whose blocks are the bodies. Default off: each block
   * becomes its own solid. vtkOriginalPointIds then count the points of one block after the other,
   * and vtkOriginalCellIds the vertices of all blocks, then lines, polygons and strips. The
   * partitions of a vtkPartitionedDataSet are one block.
   */
  void SetBlocksAreBodies(bool blocksAreBodies);
  vtkGetMacro(BlocksAreBodies, bool);
  vtkBooleanMacro(BlocksAreBodies, bool);
  ///@}

  ///@{
  /** Number of blocks of a composite data set that are meshed at once, each by one thread. Default
   * 1. Range 1 to infinity. The solids are the same, bit by bit. Limited to the threads that may
   * work (OMP_NUM_THREADS). Each block takes the memory that it takes alone, and eight hulls per
   * thread wait for their turn. Without effect on a single surface and with BlocksAreBodies. */
  vtkInsideOutSetRangeMacro(BlocksAtOnce, int, 1, VTK_INT_MAX);
  vtkGetMacro(BlocksAtOnce, int);
  ///@}

  ///@{
  /**
   * Tetrahedralize parts of the surface whose bounding boxes do not meet apart, by several threads
   * at once, without cells between them. Default off. All pieces with open edges or in a plane are
   * one part. The statistic PartsApart counts the parts. The solid and boundary of a closed surface
   * are the same, except for points added on it (SurfaceSteinerPoints); tetrahedra, energies and
   * the order of regions and points are different. Beyond the hulls of an open surface's parts
   * (output 3) nothing is inside; a warning tells of seeds there. TimeBudget is for all parts,
   * MemoryBudget for each. Requires one body and TOPOLOGY_ANY.
   */
  vtkSetMacro(PartsApart, bool);
  vtkGetMacro(PartsApart, bool);
  vtkBooleanMacro(PartsApart, bool);
  ///@}

  /** Cells that become a region where there are bodies. */
  enum RegionRuleType
  {
    BY_PRIORITY = 0, ///< a region for each body; where several are, the one that comes first
    ALL = 1          ///< a region for each combination of bodies that occurs
  };

  ///@{
  /** Regions that bodies become. BY_PRIORITY: one for each body; where several overlap, the first
   * in Priority has the cell. ALL: one for each combination of bodies that occurs. Default
   * BY_PRIORITY. With ALL the field array RegionBodies says which bodies a region is of. */
  vtkInsideOutSetRangeMacro(RegionRule, int, BY_PRIORITY, ALL);
  vtkGetMacro(RegionRule, int);
  ///@}

  ///@{
  /** Names of bodies from the one that has cells before all others, separated by commas. Default
   * empty: none is named. Bodies that are not named follow, the inner of two nested ones first,
   * else in their own order; a warning says where nesting decides. A comma within a name is
   * written \, and a backslash \\. Naming what is no body, or one twice, is an error. */
  vtkSetStdStringFromCharMacro(Priority);
  vtkGetCharFromStdStringMacro(Priority);
  ///@}

  ///@{
  /** Let membranes, and other facets that count 0, separate regions, as horizons do the layers of a
   * block. Default off. Output 1 has their interfaces behind the boundary, with RegionIds. Requires
   * one body; excludes MergeCoplanarPieces, SplitSeams, SeparateOverlaps, NONMANIFOLD_SPLIT. */
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
