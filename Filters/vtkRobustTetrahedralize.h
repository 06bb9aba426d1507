// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkRobustTetrahedralize
 * @brief   from a broken surface to tetrahedra of the solid that it means
 *
 * Takes any triangle or polygon surface, with holes, self-intersections, duplicates or non-
 * manifold edges, and gives tetrahedra of the solid that it most likely means. Facets are cut
 * where they cross, the convex hull is tetrahedralized so that each of them is a union of faces,
 * and the tetrahedra are labelled inside or outside by the surface's generalized winding number
 * and a graph cut (Jacobson, Kavan and Sorkine-Hornung 2013). Every input vertex is a point of
 * the hull, with its exact coordinates.
 *
 * Output 0, the solid: vtkTetra with the cell arrays w, Inside, FacetIds and FacetMultiplicity
 * (see vtkConstrainedDelaunay3D) and RegionId, and with field data Statistics_NAME, LeftOutCellIds
 * (see vtkResolveSelfIntersections), LostCellIds (see vtkConstrainedDelaunay3D), TurnedCellIds and
 * what each region weighs. Output 1, its boundary: triangles, oriented outward and watertight, with
 * vtkOriginalCellIds (the input cell each lies on, -1 where a hole was closed), Turned (1 where
 * that was turned over, see Orientation) and BoundaryTag. Output 2, the outliers: the pieces of
 * input facets that are no face of a cell inside, with the cell array OutlierReason (unsigned char,
 * see OutlierReasonType; their names are the field array OutlierReasonNames). All carry the input's
 * point data and vtkOriginalPointIds, the surfaces its cell data. Normals and texture coordinates
 * stay active.
 *
 * RegionId (int, -1 outside) are the parts of the solid, numbered from 0 by their first cell. Faces
 * connect: parts that touch in no more than an edge or a point are two. The field arrays
 * RegionVolume, RegionCenterOfMass (3 components) and RegionInertia (6: XX, YY, ZZ, XY, YZ, XZ,
 * about the region's own center) have a tuple for each; their units are those of the statistics
 * below.
 *
 * BoundaryTag (int, from 0) is what the input says of the cell that a triangle of the boundary lies
 * on: its group, material, solid or block, or what TagArrayName chooses. The field array
 * BoundaryTagNames (vtkStringArray) has the name of each; some may be of no triangle. A surface
 * that says nothing has one tag, surface. Triangles that lie on no cell close a hole: their tag is
 * the last, and called hole (hole_2 where the input has such a name). Slabs, and the rims around
 * them, have the tag of the sheet's facet that they belong to (see Thicken).
 *
 * Several bodies become one mesh where BodyArrayName or BlocksAreBodies says which facets are
 * whose: organs, parts of an assembly, fibres and what is around them. Each body is oriented, has
 * its winding number and is cut as if it were alone; all are resolved together, so that every cell
 * is in or out of each as a whole. Cells inside any are the solid, and w is the sum over the
 * bodies. RegionId follows from RegionRule; what faces connect is then no matter. Added are the
 * cell arrays BodyW (double, w of each body) and InBody (unsigned char, 1 in each body that has the
 * cell), of a component for each body, which has its name; and the field arrays BodyNames,
 * BodyVolume, RegionNames (the bodies of each region, joined by "+") and RegionBodies (unsigned
 * char, a tuple for each region and a component for each body, 1 where the region is of it). Output
 * 1 is the boundary of all, and behind that the interfaces between regions, each triangle once;
 * RegionIds (int, 2 components) are the regions behind and before a triangle, -1 for outside.
 * BoundaryTag is then by both, as in "bone|fat" and "fat|outside", but where TagArrayName says what
 * lies outside. Facets that no cell of their own bodies touches are outliers. Seeds are of the body
 * that their point array Body (a string, or a number that is a body's name) names; those to be
 * outside may name none, and are outside all. MergeCoplanarPieces, SplitSeams, SeparateOverlaps,
 * NONMANIFOLD_SPLIT and two dimensions are errors. BodyVolume is of each body as if it were alone,
 * before any refinement; Statistics_Bodies counts them.
 *
 * In two dimensions (Dimension) it takes lines and polylines, closed or open, whose direction
 * counts, or polygons in one plane, whose edges all count; their interiors may overlap. It gives
 * triangles in that plane, with three components of FacetIds and FacetMultiplicity, their boundary
 * as polylines with the inside on their left, and outliers as polylines. RegionArea takes the place
 * of RegionVolume, Statistics_Area that of Statistics_Volume. Thicken, the engine and its budgets,
 * MergeCoplanarPieces, SplitSeams and QuadratureOrder have nothing to do there, and SurfaceOnly
 * does no more than leave the cells away; SeparateOverlaps is an error.
 *
 * With Refine the triangles inside are others there: Delaunay refinement, by EdgeLength, Grading
 * and MaximumVolume, the largest area. KEPT: the boundary and all lines at inside triangles stay.
 * SPLIT: they are cut, so that no angle is below 20.7 degrees but at sharp corners of the lines;
 * where these lie too close to each other for that a warning says so. REMESHED and QuadraticCells
 * are errors, before any work. Statistics are AddedPoints, SurfacePoints, RefinedCells, MinAngle,
 * Angle1Percent, MaxAngle, and with Before in front the angles of the triangles before.
 *
 * The filter keeps the hull of its input: a change of what concerns only the segmentation (Gamma,
 * the constraints, seeds) does not mesh again. ReleaseDataFlagOn() saves that memory.
 *
 * Statistics of the segmentation: Energy of the solid, EnergyOfCut before the constraints,
 * ForcedFacets (pieces of facets that a cell was labelled inside for), ForcedCells (labelled inside
 * for a constraint), ChangedCells (that the constraints changed all in all), UnsatisfiedFacets
 * (pieces that seeds keep outside, or that were of dropped regions), NonManifoldPoints (that could
 * not be helped), SeedConflicts. Of regions and topology: DroppedRegions and DroppedVolume,
 * FilledCavities and FilledVolume, JoinedRegions (ways made between two), EnergyBeforeTopology. Of
 * NonManifold of the kind Split: SplitPoints (copies that the solid has), SharedPoints (those that
 * only the boundary has), NonManifoldEdges (0 but in overlaps). Of SeparateOverlaps: Overlaps,
 * SeparatedOverlaps, CopiedCells. Of the outliers: OutlierFacets and how many for each reason,
 * LostShare (of the surface's area). Of the solid: Regions; with density 1 and in the units of the
 * input: Volume, CenterOfMassX to Z, and the inertia tensor about it, InertiaXX to InertiaXZ (XX is
 * the integral of y^2 + z^2, XY of -x y); and, in space, its topology: SolidComponents,
 * SolidTunnels and SolidCavities, the Betti numbers of its cells with all that they touch in,
 * SolidEulerCharacteristic, the same of its boundary (BoundaryComponents and so on), and Genus,
 * half of BoundaryTunnels.
 *
 * With Refine the solid's cells are others of the same solid: see vtkRefineTetrahedra, which says
 * what becomes of its arrays, too. InsideCells then counts the cells before. Where Surface is not
 * KEPT output 1 is the boundary of those cells, its point data interpolated in the triangles
 * before.
 *
 * When no cell is inside there is a warning that gives the range of w, the likely cause and what to
 * set. Errors, which name the culprit, leave all outputs empty.
 *
 * @sa vtkGeneralizedWindingNumber vtkGraphCutSegmentation vtkRefineTetrahedra
 */
#ifndef vtkRobustTetrahedralize_h
#define vtkRobustTetrahedralize_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory>
#include <string>

class vtkInsideOutMonitor;
class vtkPointSet;
class vtkPolyData;

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
  /** The boundary of the solid (output 1) and the facets that are not part of it (output 2). */
  vtkPolyData* GetBoundary();
  vtkPolyData* GetOutliers();
  ///@}

  ///@{
  /**
   * Weight of a smooth boundary against the winding number, without unit. 0 is thresholding: inside
   * where w > 1/2. Larger values cut off and fill up thin parts where w is unsure. Default 2, range
   * 0 to infinity.
   */
  vtkSetClampMacro(Gamma, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /**
   * How large a step in w may be noise. Steps between two cells that are several times larger cost
   * nothing to cut along, smaller ones cost up to Gamma. Default 0.15, range 1e-6 to infinity.
   */
  vtkSetClampMacro(Sigma, double, 1e-6, VTK_DOUBLE_MAX);
  vtkGetMacro(Sigma, double);
  ///@}

  /** How many dimensions the input has. */
  enum DimensionType
  {
    DIMENSION_AUTOMATIC = 0, ///< what the input tells
    DIMENSION_2 = 2,         ///< it lies in a plane
    DIMENSION_3 = 3          ///< it is a surface in space
  };

  ///@{
  /**
   * How many dimensions the input has. 2: lines or polygons in a plane, to become triangles. 3: a
   * surface, to become tetrahedra. DIMENSION_AUTOMATIC (0): 2 for lines without polygons and for
   * polygons in one plane exactly, or but for rounding in double precision, which a warning says,
   * unless Thicken makes slabs of them; else 3. Default DIMENSION_AUTOMATIC, range 0, 2 and 3.
   */
  vtkSetClampMacro(Dimension, int, DIMENSION_AUTOMATIC, DIMENSION_3);
  vtkGetMacro(Dimension, int);
  ///@}

  /** How much a cell's own winding number counts against the others'. */
  enum DataTermType
  {
    UNIFORM = 0,        ///< every cell the same
    VOLUME_WEIGHTED = 1 ///< by the cell's volume over the mean volume
  };

  ///@{
  /**
   * How much a cell's own winding number counts: UNIFORM (0) as much as any other's, so that small
   * cells, of which there are many around details, keep what is thin; VOLUME_WEIGHTED (1) by
   * volume, so that slivers do not outvote large cells. Default UNIFORM.
   */
  vtkSetClampMacro(DataTerm, int, UNIFORM, VOLUME_WEIGHTED);
  vtkGetMacro(DataTerm, int);
  ///@}

  ///@{
  /**
   * Every piece of every facet has to be a face of a cell inside, also where it costs energy: for
   * thin sheets that are to be part of the solid. What is inside is then a local minimum. Default
   * off.
   */
  vtkSetMacro(ConstrainFacets, bool);
  vtkGetMacro(ConstrainFacets, bool);
  vtkBooleanMacro(ConstrainFacets, bool);
  ///@}

  ///@{
  /**
   * A cell array of the surface that chooses what ConstrainFacets keeps: polygons whose value is
   * not 0. Default empty: all.
   */
  vtkSetStdStringFromCharMacro(ConstrainedFacetsArrayName);
  vtkGetCharFromStdStringMacro(ConstrainedFacetsArrayName);
  ///@}

  /** What becomes of the solid's boundary where it is no 2-manifold. */
  enum NonManifoldType
  {
    NONMANIFOLD_KEEP = 0, ///< it stays so
    NONMANIFOLD_FILL = 1, ///< cells are added
    NONMANIFOLD_SPLIT = 2 ///< points are copied in their place
  };

  ///@{
  /**
   * What becomes of the solid's boundary where it is no 2-manifold, which has two faces at each
   * edge and one fan of faces at each point. NONMANIFOLD_KEEP (0): it stays so. NONMANIFOLD_FILL
   * (1): cells are added until it is one; what is inside is then a local minimum.
   * NONMANIFOLD_SPLIT (2): points are copied, so that parts of the solid that touch in points or
   * edges, and are not joined through faces around these, share none any more; places and cells
   * stay the same but for the points' ids, and vtkOriginalPointIds are those of the points that
   * were copied. Where cells join all around what touches, as around two cavities, the boundary
   * (output 1) alone has several points in a place, whose cells share one; a warning counts them.
   * NONMANIFOLD_SPLIT takes ExtractInside, one body and, with Refine, Surface KEPT; and neither
   * MergeCoplanarPieces nor SplitSeams. Default NONMANIFOLD_KEEP.
   */
  vtkSetClampMacro(NonManifold, int, NONMANIFOLD_KEEP, NONMANIFOLD_SPLIT);
  vtkGetMacro(NonManifold, int);
  void SetNonManifoldToKeep() { this->SetNonManifold(NONMANIFOLD_KEEP); }
  void SetNonManifoldToFill() { this->SetNonManifold(NONMANIFOLD_FILL); }
  void SetNonManifoldToSplit() { this->SetNonManifold(NONMANIFOLD_SPLIT); }
  ///@}

  ///@{
  /**
   * On: where two layers of the solid overlap, and w is near 2, each gets cells of its own, which
   * are glued to that layer alone, so that a limb that overlaps another can be pulled out; both
   * have the arrays of the cells that they are copies of. Overlaps that do not tell which of their
   * faces belong to which layer, or have more than two, stay glued, and a warning counts them.
   * Takes ExtractInside, one body and, with Refine, Surface KEPT; and neither MergeCoplanarPieces
   * nor SplitSeams. Default off: the solid has every place once.
   */
  vtkSetMacro(SeparateOverlaps, bool);
  vtkGetMacro(SeparateOverlaps, bool);
  vtkBooleanMacro(SeparateOverlaps, bool);
  ///@}

  ///@{
  /**
   * How many regions of the solid stay at most, the largest by volume (in two dimensions by area);
   * regions are parts that faces connect. What is dropped counts in the statistics DroppedRegions
   * and DroppedVolume, and its facets are outliers; a seed that is to be inside goes with its
   * region, and counts in SeedConflicts, with a warning. Where there are bodies each keeps so many.
   * Default 0: any number. Range 0 to VTK_INT_MAX.
   */
  vtkSetClampMacro(LargestRegions, int, 0, VTK_INT_MAX);
  vtkGetMacro(LargestRegions, int);
  ///@}

  ///@{
  /**
   * Drop regions of a smaller volume, in two dimensions area, in the units of the input. Default 0:
   * none. Range 0 to infinity.
   */
  vtkSetClampMacro(MinimumRegionVolume, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumRegionVolume, double);
  ///@}

  ///@{
  /**
   * Drop regions without a seed that is to be inside (second input). Default off.
   */
  vtkSetMacro(SeededRegions, bool);
  vtkGetMacro(SeededRegions, bool);
  vtkBooleanMacro(SeededRegions, bool);
  ///@}

  ///@{
  /**
   * Fill the solid's cavities, the parts of the outside that it encloses (in two dimensions its
   * holes), once regions are dropped; but not those with a seed that is to be outside. The
   * statistics FilledCavities and FilledVolume say how many. Default off.
   */
  vtkSetMacro(FillCavities, bool);
  vtkGetMacro(FillCavities, bool);
  vtkBooleanMacro(FillCavities, bool);
  ///@}

  /** What the solid's topology is to be, once regions are dropped and cavities filled. */
  enum TopologyType
  {
    TOPOLOGY_ANY = 0,             ///< as the segmentation has it
    TOPOLOGY_ONE_COMPONENT = 1,   ///< one region
    TOPOLOGY_SIMPLY_CONNECTED = 2 ///< one region without tunnels and cavities
  };

  ///@{
  /**
   * What the solid's topology is to be. TOPOLOGY_ANY (0): as the segmentation has it.
   * TOPOLOGY_ONE_COMPONENT (1): regions are joined, by the cells of shortest ways between them, or
   * dropped, whichever adds less energy, one after the other. TOPOLOGY_SIMPLY_CONNECTED (2): a ball
   * besides, in two dimensions a disc; tunnels and cavities are cut open by walls, or filled by
   * membranes, each tried in the way that adds less energy. Neither is a global minimum. Seeds,
   * ConstrainFacets and NonManifold of the kind Fill still hold; where they forbid what is asked
   * for a warning says so. The statistics have EnergyBeforeTopology, DroppedRegions and
   * JoinedRegions. Where there are bodies each is made so alone. Default TOPOLOGY_ANY.
   */
  vtkSetClampMacro(Topology, int, TOPOLOGY_ANY, TOPOLOGY_SIMPLY_CONNECTED);
  vtkGetMacro(Topology, int);
  void SetTopologyToAny() { this->SetTopology(TOPOLOGY_ANY); }
  void SetTopologyToOneComponent() { this->SetTopology(TOPOLOGY_ONE_COMPONENT); }
  void SetTopologyToSimplyConnected() { this->SetTopology(TOPOLOGY_SIMPLY_CONNECTED); }
  ///@}

  ///@{
  /**
   * Optional second input: points that have to be inside or outside, by their array Inside (1 or
   * 0). The cell that contains such a point, of several the one of the lowest id, gets that label.
   * Seeds win over ConstrainFacets and NonManifold; conflicts are warned about.
   */
  void SetSeedsData(vtkPointSet* seeds);
  void SetSeedsConnection(vtkAlgorithmOutput* output);
  ///@}

  ///@{
  /**
   * On: the output holds only the cells inside. Off: all cells of the hull, with the array Inside
   * to tell them apart. Default on.
   */
  vtkSetMacro(ExtractInside, bool);
  vtkGetMacro(ExtractInside, bool);
  vtkBooleanMacro(ExtractInside, bool);
  ///@}

  /** Which way the surface faces. */
  enum OrientationType
  {
    AUTOMATIC = 0, ///< what is inside out is turned over, with a warning
    AS_GIVEN = 1,  ///< nothing is
    REVERSE = 2,   ///< everything is
    OUTWARD = 3    ///< every part is made to face outward, within others too
  };

  ///@{
  /**
   * Which way facets are meant to face. AUTOMATIC (0) makes facets agree with those around them,
   * and turns parts over so that the least volume is left where w is below -1/2: a cavity stays,
   * and an open sheet turns nothing else over. AS_GIVEN (1) turns nothing, REVERSE (2) everything.
   * OUTWARD (3) makes every part that encloses something face outward, whatever lies within what.
   * Default AUTOMATIC.
   */
  vtkSetClampMacro(Orientation, int, AUTOMATIC, OUTWARD);
  vtkGetMacro(Orientation, int);
  ///@}

  ///@{
  /**
   * Give sheets, which enclose nothing, this thickness: a closed slab, half of it before the facets
   * and half behind, that joins what it touches; the facets stay as faces within. In units of the
   * surface. Default 0: sheets bound nothing. Range 0 to infinity.
   */
  vtkSetClampMacro(Thicken, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Thicken, double);
  ///@}

  ///@{
  /**
   * On: thicken every facet, and not only sheets. Default off.
   */
  vtkSetMacro(ThickenAll, bool);
  vtkGetMacro(ThickenAll, bool);
  vtkBooleanMacro(ThickenAll, bool);
  ///@}

  ///@{
  /**
   * Points at most this far apart become one, in units of the surface; of several the one with the
   * lowest id stays. Of several bodies flat faces become one, too: where all corners of a facet are
   * that near to the plane of a facet below it of an earlier body they are moved into it, with a
   * warning; faces that were turned and touch but for rounding need a tolerance for that: a warning
   * says which, and Statistics_NearTriangles counts these triangles. And cells between bodies no
   * point of which is farther from either become cells of the last of these in the order of
   * Priority, with a warning, Statistics_GapCells and Statistics_GapVolume. Default 0: only points
   * with equal coordinates are merged. Range 0 to infinity.
   */
  vtkSetClampMacro(MergeTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * Count a polygon as often as it is given. Default off: triangles with the same three points
   * count once per orientation, and opposite ones cancel.
   */
  vtkSetMacro(CountDuplicates, bool);
  vtkGetMacro(CountDuplicates, bool);
  vtkBooleanMacro(CountDuplicates, bool);
  ///@}

  ///@{
  /**
   * Name of a cell array of the input, of one number per cell: where it is not 0 the cell does not
   * count in w, but still shapes the mesh, as accessories that are no part of the body should. Such
   * a cell cancels no other. Default empty: every cell counts.
   */
  vtkSetStdStringFromCharMacro(NonParticipatingArrayName);
  vtkGetCharFromStdStringMacro(NonParticipatingArrayName);
  ///@}

  ///@{
  /**
   * On: the pieces into which an input triangle was cut become one triangle again on the boundary
   * (output 1), where all of it lies there and no other triangle needs the points between. The
   * boundary stays watertight, but its triangles are not all faces of the solid's cells any more.
   * Default off.
   */
  vtkSetMacro(MergeCoplanarPieces, bool);
  vtkGetMacro(MergeCoplanarPieces, bool);
  vtkBooleanMacro(MergeCoplanarPieces, bool);
  ///@}

  ///@{
  /**
   * What becomes of input points in one place with different texture coordinates or normals. Off:
   * they are one point of the boundary (output 1), which has the lowest id's data; a warning counts
   * them. On: the boundary has a point for each, so that every triangle has the data of the input
   * triangle that it lies on, also where triangles were cut along each other; it is watertight by
   * the points' places then, not by their ids. How many points of the input are such copies is in
   * `Statistics_SeamPoints`. Default off.
   */
  vtkSetMacro(SplitSeams, bool);
  vtkGetMacro(SplitSeams, bool);
  vtkBooleanMacro(SplitSeams, bool);
  ///@}

  ///@{
  /**
   * On: only the surfaces are wanted, outputs 1 and 2; output 0 has field data and no cells. Where
   * the input is closed the boundary is then found without tetrahedra, at the speed of
   * vtkResolveSelfIntersections, from the winding numbers on both sides of its facets: the same
   * solid, whose boundary has no self-intersections, inner walls and duplicates, and is watertight.
   * An input that is open, has facets that could not be resolved, or has nothing inside goes
   * through tetrahedra; so does all that is asked of cells or of more than one body: bodies,
   * Refine, seeds, ConstrainFacets, NonManifold, SeparateOverlaps, a choice of regions,
   * FillCavities, Topology, a Gamma or Sigma above the default and DataTerm. Statistics_Tetrahedra
   * says which way was taken (1 or 0). Without tetrahedra the statistics are those of the input and
   * of the boundary, and Volume. Default off.
   */
  vtkSetMacro(SurfaceOnly, bool);
  vtkGetMacro(SurfaceOnly, bool);
  vtkBooleanMacro(SurfaceOnly, bool);
  ///@}

  ///@{
  /**
   * Name of a cell array of the input, of one integer or string per cell: what becomes the
   * boundary's array BoundaryTag. Strings are numbered in the order of their first cells, integers
   * in their own order; these are called as the field array of strings says that goes with the
   * array (GroupNames with GroupIds, PartNames with Part), or else as they are written; floats have
   * to be whole numbers. Default empty: the first of BoundaryTag, GroupIds, MaterialIds and
   * STLSolidLabeling that tells polygons apart, or the blocks of a composite input.
   */
  vtkSetStdStringFromCharMacro(TagArrayName);
  vtkGetCharFromStdStringMacro(TagArrayName);
  ///@}

  ///@{
  /**
   * Name of a cell array of the input, of one integer or string per cell, as TagArrayName: which
   * body each cell is of. Bodies are numbered and called as tags are: those of an OBJ file by
   * GroupIds, of an STL file of several solids too. Default empty: all is one body.
   */
  vtkSetStdStringFromCharMacro(BodyArrayName);
  vtkGetCharFromStdStringMacro(BodyArrayName);
  ///@}

  ///@{
  /**
   * What becomes of a composite input. Off: each block is a surface by itself, and becomes a solid
   * by itself. On: each block is a body, called by the name of the block, and all become one mesh.
   * vtkOriginalPointIds then count the points of all blocks, one block after the other, and
   * vtkOriginalCellIds their cells: those of all blocks that are vertices, then lines, polygons and
   * strips. Default off.
   */
  void SetBlocksAreBodies(bool blocksAreBodies);
  vtkGetMacro(BlocksAreBodies, bool);
  vtkBooleanMacro(BlocksAreBodies, bool);
  ///@}

  ///@{
  /**
   * How many blocks of a composite data set are resolved and meshed at once, each by one thread;
   * the solids are the same, bit by bit. That pays where blocks are many and small, for of a small
   * one there is little that threads can share. As many as threads may work (OMP_NUM_THREADS) at
   * most; each takes the memory that it takes alone, and the hulls of eight for each thread are
   * kept until their turn comes. Of a single surface, of BlocksAreBodies and in a plane it does
   * nothing. Default 1: one after the other. Range 1 to infinity.
   */
  vtkSetClampMacro(BlocksAtOnce, int, 1, VTK_INT_MAX);
  vtkGetMacro(BlocksAtOnce, int);
  ///@}

  ///@{
  /**
   * On: parts of the surface whose bounding boxes do not meet are tetrahedralized apart, each in a
   * convex hull of its own and by a thread of its own; there are no cells between them. That saves
   * time where a surface has many parts: of 27 on two threads the tetrahedra took 0.6 of the time,
   * on one thread nearly as long. A part is all whose boxes meet; of one part are also all pieces
   * that have open edges or lie in a plane, for a solid may reach from one to another.
   * Statistics_PartsApart counts the parts.
   *
   * Where the surface is closed the solid fills the same space; its boundary has the same triangles
   * (where no points had to be added on them, see Statistics_SurfaceSteinerPoints), and its regions
   * weigh the same, within rounding. Its tetrahedra, the numbers of its regions and points, and the
   * energies are others; so may be what the constraints add, which depends on the tetrahedra.
   * Without ExtractInside output 0 is the hulls of the parts. Where the surface is open each cell
   * has the w of the whole surface, but nothing beyond the hulls of the parts is inside; a seed
   * that is to be inside and lies there does not count, with a warning. TimeBudget is for all
   * parts, MemoryBudget for each.
   *
   * Takes one body and TOPOLOGY_ANY; in a plane it does nothing, with a warning. Default off.
   */
  vtkSetMacro(PartsApart, bool);
  vtkGetMacro(PartsApart, bool);
  vtkBooleanMacro(PartsApart, bool);
  ///@}

  /** What becomes a region where there are bodies. */
  enum RegionRuleType
  {
    BY_PRIORITY = 0, ///< a region for each body; where several are, the one that comes first
    ALL = 1          ///< a region for each combination of bodies that occurs
  };

  ///@{
  /**
   * What becomes a region where there are bodies. BY_PRIORITY (0): each body is a region with the
   * body's number; where bodies overlap the first in Priority has the cell, and a body that others
   * cover whole has none. ALL (1): each combination of bodies that occurs is a region; the field
   * array RegionBodies says which bodies it is of. Default BY_PRIORITY.
   */
  vtkSetClampMacro(RegionRule, int, BY_PRIORITY, ALL);
  vtkGetMacro(RegionRule, int);
  ///@}

  ///@{
  /**
   * The names of bodies, parted by commas, from the one that has cells before all others; those
   * that are not named come after these, in their own order. A comma within a name is written \,
   * and a backslash \\. Default empty: in their own order. It is an error to name what is no body,
   * or one twice.
   */
  vtkSetStdStringFromCharMacro(Priority);
  vtkGetCharFromStdStringMacro(Priority);
  ///@}

  ///@{
  /**
   * How w is averaged over a cell: at the barycentre (1), or by quadrature that integrates
   * polynomials up to this degree exactly, of 4 (2), 8 (3) or 14 places (4 and 5). Matters on open
   * surfaces only: on a closed one w is constant in a cell. Next to an open edge w depends on the
   * direction from the edge, and high order gains little there. Default 1, range 1 to 5.
   */
  vtkSetClampMacro(QuadratureOrder, int, 1, 5);
  vtkGetMacro(QuadratureOrder, int);
  ///@}

  /** What makes the tetrahedra. */
  enum EngineType
  {
    ENGINE_AUTOMATIC = 0, ///< exact flips and cuts, and TetGen should these lose a facet
    ENGINE_EXACT = 1,     ///< flips and cuts with exact predicates, in this process
    ENGINE_TETGEN = 2     ///< TetGen alone
  };

  ///@{
  /**
   * What makes the tetrahedra: ENGINE_AUTOMATIC (0) tries exact flips and cuts, and TetGen should
   * these lose a facet; ENGINE_EXACT (1) and ENGINE_TETGEN (2) only the one. Where neither keeps
   * every facet the mesh that loses fewest is taken. Default ENGINE_AUTOMATIC.
   */
  vtkSetClampMacro(Engine, int, ENGINE_AUTOMATIC, ENGINE_TETGEN);
  vtkGetMacro(Engine, int);
  void SetEngineToAutomatic() { this->SetEngine(ENGINE_AUTOMATIC); }
  void SetEngineToExact() { this->SetEngine(ENGINE_EXACT); }
  void SetEngineToTetGen() { this->SetEngine(ENGINE_TETGEN); }
  ///@}

  ///@{
  /**
   * Seconds that tetrahedralizing may take, an equal part of it in each of the ways that are tried
   * in turn. Default 0: no clock. Exact cuts are then limited by a count of their work, so that a
   * busy machine gives the same mesh; TetGen, should it have its turn, by 4 s of processor time in
   * each of its ways, and 0.3 ms for each point and facet. Range 0 to infinity.
   */
  vtkSetClampMacro(TimeBudget, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TimeBudget, double);
  ///@}

  ///@{
  /**
   * MiB of memory that TetGen's process may hold; beyond it the next way is tried. Default 0: 1024
   * MiB, and 16 KiB for each point and facet, but at most three quarters of the machine's memory.
   * Range 0 to infinity.
   */
  vtkSetClampMacro(MemoryBudget, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MemoryBudget, double);
  ///@}

  ///@{
  /**
   * On: output 0 is refined before it is put out, as vtkRefineTetrahedra does it with the options
   * below, which do nothing without. Its points, and those of the boundary, keep their
   * vtkOriginalPointIds. Takes ExtractInside: there is an error without. Default off.
   */
  vtkSetMacro(Refine, bool);
  vtkGetMacro(Refine, bool);
  vtkBooleanMacro(Refine, bool);
  ///@}

  ///@{
  /**
   * How long edges are to be at most where the solid is refined, in units of the input; 0: as long
   * as those of the surface allow. Edges of the boundary may be longer. Default 0, range 0 to
   * infinity.
   */
  vtkSetClampMacro(EdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(EdgeLength, double);
  ///@}

  ///@{
  /**
   * By how much the length of edges may grow per unit of distance from the boundary where the solid
   * is refined. Default 0.35, range 1e-6 to infinity.
   */
  vtkSetClampMacro(Grading, double, 1e-6, VTK_DOUBLE_MAX);
  vtkGetMacro(Grading, double);
  ///@}

  ///@{
  /**
   * How large cells are to be at most where the solid is refined, in cubic units of the input, or
   * in square ones in two dimensions; 0: any size. Default 0, range 0 to infinity.
   */
  vtkSetClampMacro(MaximumVolume, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumVolume, double);
  ///@}

  /** What becomes of the surface. */
  enum SurfaceType
  {
    KEPT,
    SPLIT,
    REMESHED
  };

  ///@{
  /**
   * What becomes of the triangles of the boundary, and between regions, where the solid is refined.
   * KEPT: each stays as it is, bit by bit. SPLIT: points are added on them, so that long and thin
   * ones become pieces that are not; all points that were there stay, and the pieces lie in the
   * triangles' planes, within rounding. REMESHED: triangles of the edge length that is asked for
   * take their place, no farther away than SurfaceTolerance; edges above FeatureAngle stay where
   * they are. What would touch another part of the boundary so stays as it is. Default KEPT.
   */
  vtkSetClampMacro(Surface, int, KEPT, REMESHED);
  vtkGetMacro(Surface, int);
  ///@}

  ///@{
  /**
   * Where the surface is REMESHED: how far the new one may be from the old one, and the old one
   * from the new one, in units of the input; 0: a thousandth of the longest edge of its bounding
   * box. Default 0, range 0 to infinity.
   */
  vtkSetClampMacro(SurfaceTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SurfaceTolerance, double);
  ///@}

  ///@{
  /**
   * Where the surface is REMESHED: edges stay where they are between triangles whose normals differ
   * by more than this, but for those of steps lower than SurfaceTolerance, and between those of
   * different tags. In degrees; default 30, range 0 to 180.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Where the solid is refined: cells of second order (vtkQuadraticTetra), with points amid their
   * straight edges. Default off.
   */
  vtkSetMacro(QuadraticCells, bool);
  vtkGetMacro(QuadraticCells, bool);
  vtkBooleanMacro(QuadraticCells, bool);
  ///@}

protected:
  vtkRobustTetrahedralize();
  ~vtkRobustTetrahedralize() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Dimension = DIMENSION_AUTOMATIC;
  double Gamma;
  double Sigma;
  int DataTerm;
  bool ConstrainFacets;
  int NonManifold = NONMANIFOLD_KEEP;
  bool SeparateOverlaps = false;
  int LargestRegions;
  double MinimumRegionVolume;
  bool SeededRegions;
  bool FillCavities;
  int Topology;
  std::string ConstrainedFacetsArrayName;
  bool ExtractInside = true;
  int Orientation;
  double Thicken;
  bool ThickenAll;
  double MergeTolerance;
  bool CountDuplicates;
  std::string NonParticipatingArrayName;
  bool MergeCoplanarPieces = false;
  bool SplitSeams = false;
  bool SurfaceOnly = false;
  std::string TagArrayName;
  std::string BodyArrayName;
  bool BlocksAreBodies = false;
  int BlocksAtOnce = 1;
  bool PartsApart;
  int RegionRule = BY_PRIORITY;
  std::string Priority;
  int QuadratureOrder;
  int Engine;
  double TimeBudget;
  double MemoryBudget;
  bool Refine = false;
  double EdgeLength;
  double Grading;
  double MaximumVolume;
  int Surface;
  double SurfaceTolerance;
  double FeatureAngle;
  bool QuadraticCells = false;

private:
  void MeshBlocksAhead(vtkInsideOutMonitor& monitor);
  void MakeTriangles(vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  void PutOut(vtkUnstructuredGrid* grid, vtkPolyData* boundary, vtkPolyData* outliers,
    vtkInformationVector* outputVector);
  bool PartsSolid();
  void CheckOptions();
  void CheckPlanarOptions();
  void CheckBodies(bool isPlanar);

  class Cache;
  std::unique_ptr<Cache> Hulls;
  class CacheInAPlane;
  std::unique_ptr<CacheInAPlane> HullsInAPlane;

  vtkRobustTetrahedralize(const vtkRobustTetrahedralize&) = delete;
  void operator=(const vtkRobustTetrahedralize&) = delete;
};

#endif
