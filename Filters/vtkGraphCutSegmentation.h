// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkGraphCutSegmentation
 * @brief   labels the cells of a grid inside or outside by their winding numbers
 *
 * Takes a conforming grid (cells of one dimension, 2 or 3, that meet in whole faces) with a cell
 * array w of one component. Finds the labelling of least energy (Jacobson, Kavan and
 * Sorkine-Hornung 2013, equations 8.8 to 8.10) by a minimum cut: cells with large w tend to be
 * inside, and neighbors with nearly equal w tend to have the same label. The result is a global
 * minimum, and of several minima the one with the fewest cells inside.
 *
 * Output: the input's cells with their data, or with ExtractInside, the default, only the cells
 * inside.
 * - Inside (unsigned char, cells): 1 inside, 0 outside
 *
 * Statistics: InsideCells, Energy and SecondsCut. On tetrahedra also: EnergyOfCut (before the
 * constraints); ForcedFacets (pieces of facets for which a cell was labelled inside), ForcedCells
 * (labelled inside by constraints), ChangedCells (by all constraints); UnsatisfiedFacets (pieces
 * not kept, because of seeds or dropped regions), NonManifoldPoints (remaining), SeedConflicts;
 * DroppedRegions, DroppedVolume, FilledCavities, FilledVolume, JoinedRegions (paths made between
 * two regions), EnergyBeforeTopology; SplitPoints (copies made by NONMANIFOLD_SPLIT) and
 * NonManifoldEdges (0 except in overlaps).
 *
 * Seeds, ConstrainFacets, NonManifold, the choice of regions and Topology require tetrahedra;
 * Topology requires a convex grid, too.
 *
 * @sa vtkGeneralizedWindingNumber
 */
#ifndef vtkGraphCutSegmentation_h
#define vtkGraphCutSegmentation_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutRange.h"         // for setters with a range
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkUnstructuredGridAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;

class VTKFILTERSINSIDEOUT_EXPORT vtkGraphCutSegmentation : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGraphCutSegmentation* New();
  vtkTypeMacro(vtkGraphCutSegmentation, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Weight of a smooth boundary against the winding number w. 0: every cell with w above 1/2 is
   * inside; larger values cut off or fill thin parts where w is near 1/2. Default 2. Range 0 to
   * infinity.
   */
  vtkInsideOutSetRangeMacro(Gamma, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /**
   * Step of w between neighboring cells that counts as noise. Default 0.15. Range 1e-6 to infinity.
   * A boundary along much larger steps costs nothing; along smaller steps it costs up to Gamma.
   */
  vtkInsideOutSetRangeMacro(Sigma, double, 1e-6, VTK_DOUBLE_MAX);
  vtkGetMacro(Sigma, double);
  ///@}

  /** Weight of a cell's own winding number. */
  enum DataTermType
  {
    UNIFORM = 0,        ///< every cell the same
    VOLUME_WEIGHTED = 1 ///< by the cell's volume over the mean volume
  };

  ///@{
  /**
   * Weight of a cell's own winding number. UNIFORM: every cell counts the same, which keeps thin
   * parts. VOLUME_WEIGHTED: cells count by volume, so that slivers do not outvote large cells.
   * Default UNIFORM.
   */
  vtkInsideOutSetRangeMacro(DataTerm, int, UNIFORM, VOLUME_WEIGHTED);
  vtkGetMacro(DataTerm, int);
  ///@}

  ///@{
  /**
   * Keep every piece of every facet as a face of a cell inside, thin sheets included. Default off.
   * The labels are then a local minimum. Requires tetrahedra with the cell array FacetIds: faces
   * where it is not negative are kept.
   */
  vtkSetMacro(ConstrainFacets, bool);
  vtkGetMacro(ConstrainFacets, bool);
  vtkBooleanMacro(ConstrainFacets, bool);
  ///@}

  /** Treatment of edges and points where the boundary is not a 2-manifold. */
  enum NonManifoldType
  {
    NONMANIFOLD_KEEP = 0, ///< it stays so
    NONMANIFOLD_FILL = 1, ///< cells are added
    NONMANIFOLD_SPLIT = 2 ///< points are copied in their place
  };

  ///@{
  /**
   * Treatment of edges and points where the solid touches itself. NONMANIFOLD_KEEP leaves them,
   * NONMANIFOLD_FILL adds cells there, NONMANIFOLD_SPLIT copies the points, so that touching parts
   * share none. Default NONMANIFOLD_KEEP. The others make the boundary a 2-manifold: two faces at
   * each edge, one fan of faces at each point. The result of NONMANIFOLD_FILL is a local minimum.
   * NONMANIFOLD_SPLIT changes only point ids of cells; copies have the vtkOriginalPointIds of their
   * originals. Both require tetrahedra; NONMANIFOLD_SPLIT requires ExtractInside.
   */
  vtkInsideOutSetRangeMacro(NonManifold, int, NONMANIFOLD_KEEP, NONMANIFOLD_SPLIT);
  vtkGetMacro(NonManifold, int);
  void SetNonManifoldToKeep() { this->SetNonManifold(NONMANIFOLD_KEEP); }
  void SetNonManifoldToFill() { this->SetNonManifold(NONMANIFOLD_FILL); }
  void SetNonManifoldToSplit() { this->SetNonManifold(NONMANIFOLD_SPLIT); }
  ///@}

  ///@{
  /**
   * Keep at most this number of regions, the largest by volume, in a plane by area. A region is a
   * part connected through faces. Default 0: any number. Range 0 to infinity. The statistics
   * DroppedRegions and DroppedVolume count what is dropped; its facets are outliers. A seed in a
   * dropped region counts in SeedConflicts, with a warning. Requires tetrahedra, as the following
   * options do.
   */
  vtkInsideOutSetRangeMacro(LargestRegions, int, 0, VTK_INT_MAX);
  vtkGetMacro(LargestRegions, int);
  ///@}

  ///@{
  /** Drop regions with less than this volume, in a plane area, in units of the input. Default 0:
   * none. Range 0 to infinity. */
  vtkInsideOutSetRangeMacro(MinimumRegionVolume, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumRegionVolume, double);
  ///@}

  ///@{
  /** Drop regions that contain no seed with Inside 1. Default off. */
  vtkSetMacro(SeededRegions, bool);
  vtkGetMacro(SeededRegions, bool);
  vtkBooleanMacro(SeededRegions, bool);
  ///@}

  ///@{
  /**
   * Fill the cavities that the solid encloses, in a plane its holes. Default off. Regions are
   * dropped first. Cavities that contain a seed with Inside 0 stay. The statistics FilledCavities
   * and FilledVolume count the filled ones.
   */
  vtkSetMacro(FillCavities, bool);
  vtkGetMacro(FillCavities, bool);
  vtkBooleanMacro(FillCavities, bool);
  ///@}

  /** Required topology of the solid, after regions were dropped and cavities filled. */
  enum TopologyType
  {
    TOPOLOGY_ANY = 0,             ///< that of the graph cut
    TOPOLOGY_ONE_COMPONENT = 1,   ///< one region
    TOPOLOGY_SIMPLY_CONNECTED = 2 ///< one region without tunnels and cavities
  };

  ///@{
  /**
   * Required topology of the solid. TOPOLOGY_ANY: that of the graph cut. TOPOLOGY_ONE_COMPONENT:
   * regions are joined or dropped, whichever adds less energy. TOPOLOGY_SIMPLY_CONNECTED: in
   * addition, tunnels and cavities are cut open or filled. Default TOPOLOGY_ANY. Regions are joined
   * by the cells of shortest paths between them, one after the other. A simply connected solid is a
   * ball, in a plane a disc: each tunnel is cut open by a wall or filled by a membrane, whichever
   * adds less energy. Neither result is a global minimum. Seeds, ConstrainFacets and
   * NONMANIFOLD_FILL still hold; a warning says where they prevent the topology. The statistics
   * have EnergyBeforeTopology, DroppedRegions and JoinedRegions.
   */
  vtkInsideOutSetRangeMacro(Topology, int, TOPOLOGY_ANY, TOPOLOGY_SIMPLY_CONNECTED);
  vtkGetMacro(Topology, int);
  void SetTopologyToAny() { this->SetTopology(TOPOLOGY_ANY); }
  void SetTopologyToOneComponent() { this->SetTopology(TOPOLOGY_ONE_COMPONENT); }
  void SetTopologyToSimplyConnected() { this->SetTopology(TOPOLOGY_SIMPLY_CONNECTED); }
  ///@}

  ///@{
  /**
   * Optional second input: seeds, points that must be inside or outside, by their point array
   * Inside (1 or 0). If several cells contain a seed, the one of the lowest id gets its label.
   * Seeds take precedence over ConstrainFacets and NonManifold; a warning counts conflicts. The
   * blocks of a composite data set are one set of seeds.
   */
  void SetSeedsData(vtkDataObject* seeds);
  void SetSeedsConnection(vtkAlgorithmOutput* output);
  ///@}

  ///@{
  /** Output only the cells inside. Off: all cells of the hull, told apart by the array Inside.
   * Default on. */
  vtkSetMacro(ExtractInside, bool);
  vtkGetMacro(ExtractInside, bool);
  vtkBooleanMacro(ExtractInside, bool);
  ///@}

protected:
  vtkGraphCutSegmentation();
  ~vtkGraphCutSegmentation() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Gamma;
  double Sigma;
  int DataTerm;
  bool ConstrainFacets;
  int NonManifold = NONMANIFOLD_KEEP;
  int LargestRegions;
  double MinimumRegionVolume;
  bool SeededRegions;
  bool FillCavities;
  int Topology;
  bool ExtractInside = true;

private:
  vtkGraphCutSegmentation(const vtkGraphCutSegmentation&) = delete;
  void operator=(const vtkGraphCutSegmentation&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
